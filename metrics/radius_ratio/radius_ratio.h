// Radius ratio Q = 2 r_in / r_circ of each triangle: 1 for an equilateral one, 0 for a degenerate one
// (Meyer, Kirby, Whitaker 2007, Table 2 and Figure 5; the reciprocal of Verdict's normalisation).
#pragma once

#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/histogram.h"

namespace isobench {

double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Radius ratio of each triangle.
std::vector<double> radius_ratios(const TriangleMesh& mesh);

struct RadiusRatioFigures {
  double min = 0.0;
  double p01 = 0.0;  ///< 0.1 percentile by nearest rank: the ⌈n/1000⌉-th smallest of n, a value that occurs
  double avg = 0.0;  ///< over triangles, each counting the same
  Histogram histogram{0.0, 1.0, 100};
};
RadiusRatioFigures measure_radius_ratio(const TriangleMesh& mesh);
RadiusRatioFigures summarize_radius_ratios(std::vector<double> ratios);

}  // namespace isobench
