// Records made by hand for the tests of reports.
#pragma once

#include <string>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// One parameter changed, the others as they are.
inline void set_parameter(RunRequest& request, const std::string& name, const ParameterValue& value) {
  ParameterValues all = *request.parameters;
  all[name] = value;
  request.parameters = std::move(all);
}

inline RunRecord sample_record(const std::string& dataset, const std::string& method, const std::string& label = "") {
  RunRecord record;
  RunRequest& request = record.request;
  request.run = dataset + "-" + (label.empty() ? method : label);
  request.dataset = dataset;
  request.dataset_checksum = "0123";
  request.method = method;
  request.label = label.empty() ? method : label;
  request.parameters = ParameterValues{{"finish", true}, {"sweeps", 60.0}, {"start", std::string("grid, fine")}};
  request.sizing.epsilon = 0.5;
  request.sizing.delta = 0.3;
  request.limit_minutes = 20.0;
  record.status = Status::ok;
  record.started = "2026-01-02T03:04:05Z";
  record.threads = 2;
  record.environment.commit = "abcdef";
  record.environment.libraries = LibraryVersions{{"VTK", "9.1.0"}};
  DatasetRecord& data = record.dataset.emplace();
  data.title = "A " + dataset;
  data.source = "phantom";
  data.preparation = {"gaussian"};
  data.isovalue = 0.5;
  data.inside = "above";
  data.kernel = "bspline";
  data.lattice.size = {64, 32, 16};
  data.lattice.spacing = {0.5, 1.0, 1.5};
  data.lattice.direction.col(0) = Eigen::Vector3d(0.0, 1.0, 0.0);
  record.sizing = SizingRecord{false, 0.25, 0.3, 4.0};
  Measurement& m = record.measurement.emplace();
  for (const FigureDeclaration& figure : declared_figures()) m.set(figure.name, 0.0);
  for (const HistogramDeclaration& histogram : declared_histograms()) m.histogram(histogram.name) = histogram.empty();
  m.set("vertices", 1002);
  m.set("triangles", 2000);
  m.set("radius_ratio_min", 0.1 + 0.2);  // no short decimal
  m.set("radius_ratio_avg", 0.9449);
  m.histogram("radius_ratio").add(0.25);
  m.set("valence_lt5_percent", 0.25);
  m.set("valence_5_percent", 17.5);
  m.set("valence_6_percent", 64.0);
  m.set("valence_7_percent", 18.0);
  m.set("valence_gt7_percent", 0.25);
  m.histogram("valence").counts = {0, 0, 0, 0, 3, 5};
  m.histogram("valence").high = 6.0;
  m.set("edge_over_h0_max", 1.25);
  m.set("edge_over_h0_exceed_count", 3);
  m.set("edge_over_h0_exceed_triangle_percent", 0.0035);
  m.set("components", 1);
  m.set("euler", -14);
  m.set("euler_reference", -12);
  m.set("components_reference", 3);
  m.set("distance_mean", 0.0125);
  record.mesh_checksum = "c0ffee";
  record.environment.host = "node1";
  record.measured_again = MeasuredAgain{"2026-02-03T04:05:06Z", "fedcba", true};
  record.seconds_prepare = 1.5;
  record.seconds_sizing = 2.0;
  record.seconds_method = 3.25;
  record.seconds_total = 5.25;
  record.peak_memory_mb = 321.0;
  record.stages = {{"mesh", 5.25, 9.5}, {"mesh/sizing", 2.0, 3.0}};
  record.counters = {{"particles/splits", 7.0}};
  record.traces = {{"energy", {3.0, 2.0, 1.5}}};
  record.notes = {"a note"};
  return record;
}

}  // namespace isobench
