#include "isobench/metrics/angles/angles.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace isobench {

std::array<double, 3> triangle_angles(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d bc = c - b;
  const Eigen::Vector3d ca = a - c;
  const double twice_area = ab.cross(ca).norm();
  const auto degrees = [&](double dot) { return std::atan2(twice_area, dot) * 180.0 / std::numbers::pi; };
  return {degrees(-ab.dot(ca)), degrees(-ab.dot(bc)), degrees(-bc.dot(ca))};
}

AngleFigures measure_angles(const TriangleMesh& mesh) {
  AngleFigures figures;
  if (mesh.triangles.empty()) return figures;
  std::vector<std::array<double, 3>> angles(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, angles.size(), [&](std::size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    angles[t] = triangle_angles(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
  });
  figures.min = 180.0;
  for (const std::array<double, 3>& of_triangle : angles) {
    for (const double angle : of_triangle) {
      figures.min = std::min(figures.min, angle);
      figures.max = std::max(figures.max, angle);
      figures.histogram.add(angle);
    }
  }
  return figures;
}

}  // namespace isobench
