// Results on many data sets, made by hand for tests.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>

#include "isobench/foundation/random.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {

namespace sample_survey {

inline constexpr std::array<const char*, 3> families = {"random-field", "islands", "mask"};

/// The name of the n-th data set, for example "islands-0004".
inline std::string dataset(std::size_t n) { return fmt::format("{}-{:04}", families[n % families.size()], n); }

inline RunRecord record(std::size_t n, const std::string& method) {
  RunRecord record = sample_record(dataset(n), method);
  record.request.family = families[n % families.size()];
  record.request.sizing = {};
  record.request.sizing.edge_length = 2.5;
  record.mesh_checksum = record.request.run;
  Measurement& m = *record.measurement;
  m.set("euler", 2);
  m.set("euler_reference", 2);
  m.set("components", 1);
  m.set("components_reference", 1);
  m.set("edge_over_h0_exceed_count", 0);
  m.set("edge_over_h0_max", 0.99);
  return record;
}

/// A good method: its radius ratios are 0.8 to 0.9, its angles 36° to 89°.
inline RunRecord good(std::size_t n) {
  RunRecord run = record(n, "good");
  const double u = uniform_random(1, n, 0);
  run.measurement->set("radius_ratio_min", 0.8 + 0.1 * u);
  run.measurement->set("radius_ratio_avg", 0.98 + 0.01 * u);
  run.measurement->set("angle_min", 36.0 + 4.0 * u);
  run.measurement->set("angle_max", 89.0 - 3.0 * u);
  run.seconds_total = 2.0 + uniform_random(2, n, 0);
  return run;
}

/// A fast one: radius ratios of 0 to 0.3; the topology is wrong on every fourth data set and the mesh open on every
/// tenth.
inline RunRecord fast(std::size_t n) {
  RunRecord run = record(n, "fast");
  const double u = uniform_random(3, n, 0);
  run.measurement->set("radius_ratio_min", 0.3 * u);
  run.measurement->set("radius_ratio_avg", 0.6 + 0.1 * u);
  run.measurement->set("angle_min", 10.0 * u);
  run.measurement->set("angle_max", 170.0 - 20.0 * u);
  run.measurement->set("valence_extreme_count", 5 + static_cast<double>(n % 7));
  if (n % 4 == 0) run.measurement->set("euler", 0);
  if (n % 10 == 0) run.measurement->set("boundary_edges", 4);
  run.seconds_total = 0.02 + 0.01 * u;
  return run;
}

/// One in between that runs out of time on every twentieth data set.
inline RunRecord slow(std::size_t n) {
  RunRecord run = record(n, "slow");
  const double u = uniform_random(4, n, 0);
  run.measurement->set("radius_ratio_min", 0.5 + 0.3 * u);
  run.measurement->set("radius_ratio_avg", 0.93 + 0.02 * u);
  run.measurement->set("angle_min", 20.0 + 12.0 * u);
  run.measurement->set("angle_max", 120.0 - 15.0 * u);
  run.seconds_total = 8.0 + 4.0 * u;
  if (n % 20 == 19) {
    run.status = Status::timeout;
    run.reason = "not finished after 1 minute";
    run.measurement.reset();
    run.mesh_checksum.clear();
  }
  return run;
}

/// The three methods on this many data sets.
inline Results results(std::size_t datasets) {
  Results all;
  all.name = "wild";
  all.title = "Many surfaces";
  for (std::size_t n = 0; n < datasets; ++n) {
    all.records.push_back(good(n));
    all.records.push_back(fast(n));
    all.records.push_back(slow(n));
  }
  return all;
}

}  // namespace sample_survey

}  // namespace isobench
