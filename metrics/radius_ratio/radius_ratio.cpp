#include "isobench/metrics/radius_ratio/radius_ratio.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace isobench {

double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double x = ab.norm();
  const double y = ac.norm();
  const double z = (c - b).norm();
  // r_in = 2A/(x + y + z), r_circ = xyz/(4A), |ab × ac| = 2A.
  const double denominator = x * y * z * (x + y + z);
  if (!(denominator > 0.0)) return 0.0;
  // Rounding can leave an equilateral triangle an ulp above 1.
  return std::min(1.0, 4.0 * ab.cross(ac).squaredNorm() / denominator);
}

std::vector<double> radius_ratios(const TriangleMesh& mesh) {
  std::vector<double> ratios(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, ratios.size(), [&](std::size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    ratios[t] = radius_ratio(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
  });
  return ratios;
}

RadiusRatioFigures summarize_radius_ratios(std::vector<double> ratios) {
  RadiusRatioFigures figures;
  if (ratios.empty()) return figures;
  double sum = 0.0;
  for (const double ratio : ratios) {
    sum += ratio;
    figures.histogram.add(ratio);
  }
  figures.avg = sum / static_cast<double>(ratios.size());
  const std::size_t rank = (ratios.size() + 999) / 1000;
  const auto nth = ratios.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(ratios.begin(), nth, ratios.end());
  figures.p01 = *nth;
  figures.min = *std::min_element(ratios.begin(), nth + 1);
  return figures;
}

RadiusRatioFigures measure_radius_ratio(const TriangleMesh& mesh) {
  return summarize_radius_ratios(radius_ratios(mesh));
}

}  // namespace isobench
