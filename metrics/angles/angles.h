// Interior angles of the triangles, in degrees.
#pragma once

#include <array>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/histogram.h"

namespace isobench {

/// The angles at a, b and c in degrees, by atan2(|u × v|, u · v): full precision near 0° and 180°, where acos loses
/// half the digits. An angle at a side of length zero is 0.
std::array<double, 3> triangle_angles(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

struct AngleFigures {
  double min = 0.0;
  double max = 0.0;
  Histogram histogram{0.0, 180.0, 180};
};
AngleFigures measure_angles(const TriangleMesh& mesh);

}  // namespace isobench
