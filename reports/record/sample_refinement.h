// Records made by hand of a method whose meshes get finer and whose errors fall with known orders.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "isobench/reports/record/sample_records.h"

namespace isobench {

/// A record without the figures that only `metrics_of_use` measures.
inline RunRecord without_use(RunRecord record) {
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    if (metric_of_figure(n).when == When::on_request) record.measurement->set_unknown(n);
  }
  return record;
}

/// A run with edges of one length and this many vertices on a closed surface of 1000 mm². poisson_l2 and poisson_max
/// are `error` (h/10 mm)^order, gradient_max is (h/10 mm).
inline RunRecord sample_level(const std::string& dataset, const std::string& label, double vertices, double error,
                              double order) {
  RunRecord record = sample_record(dataset, label);
  record.request.sizing = {};
  record.request.sizing.vertices = vertices;
  record.request.run += "-" + std::to_string(static_cast<int>(vertices));
  record.sizing->uniform = true;
  record.stages.push_back({"measure/conditioning/factorize", 0.5, 0.5});
  record.stages.push_back({"measure/poisson/solve", 0.25, 0.25});
  Measurement& m = *record.measurement;
  m.set("vertices", vertices);
  m.set("triangles", 2.0 * vertices);
  m.set("area", 1000.0);
  const double h = std::sqrt(4.0 / std::sqrt(3.0) * 1000.0 / (2.0 * vertices));
  m.set("poisson_l2", error * std::pow(h / 10.0, order));
  m.set("poisson_max", error * std::pow(h / 10.0, order));
  m.set("gradient_max", h / 10.0);
  m.set("step_factor", 12.0);
  m.set("condition", 6.0);
  m.set("cg_iterations", 300);
  return record;
}

inline std::vector<RunRecord> sample_levels(const std::string& dataset, const std::string& label, double error,
                                            double order) {
  return {sample_level(dataset, label, 1000.0, error, order), sample_level(dataset, label, 4000.0, error, order),
          sample_level(dataset, label, 16000.0, error, order)};
}

}  // namespace isobench
