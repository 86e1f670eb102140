// One method on one data set at several sizings: how its errors fall as its meshes get finer.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/runs/spread.h"

namespace isobench {

/// The runs of one label on one data set, sizing by sizing.
struct Refinement {
  std::string dataset;
  std::string label;
  /// All runs at one sizing, over seeds and repeats. The finest meshes, by the median number of vertices, come last;
  /// sizings without a finished run come first.
  std::vector<Runs> levels;
};

/// All runs except those that are aside (RunRequest::aside), in the order of the plan. Points into `results`.
std::vector<Refinement> refinements(const Results& results);

/// The same runs, but of each label only those at its finest sizing on each data set: one variant a label, and so one
/// mesh of each method to compare.
RunGrid finest_runs(const RunGrid& runs);

/// The mean edge length h of a mesh if its triangles were equilateral, mm: h² = (4/√3) × mean area of a triangle. NaN
/// where there is no mesh.
double mean_edge_length(const RunRecord& run);

/// Wall seconds of factorising and solving the system of poisson_max. NaN where the run was measured without it, or by
/// a version that did not book them.
double solving_seconds(const RunRecord& run);

/// The order p of an error ~ hᵖ: the slope of log(error) over log(h), by least squares over the medians of each level.
struct Order {
  double value = 0.0;    ///< NaN where there is none
  std::string untested;  ///< why there is none, for example "fewer than 3 sizings"; "" if there is one
};
/// There is an order only where at least three levels have the error, and their h differ by half as much again or more.
Order order_of_convergence(const Refinement& refinement, const Figure& error);

}  // namespace isobench
