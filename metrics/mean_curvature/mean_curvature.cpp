#include "isobench/metrics/mean_curvature/mean_curvature.h"

#include <algorithm>
#include <cmath>

namespace isobench {

std::optional<double> curvature_error(const FiniteElements& elements, const TriangleMesh& mesh,
                                      const std::vector<FootPoint>& feet) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> x(elements.size(), 3);
  for (Eigen::Index i = 0; i < elements.size(); ++i) {
    x.row(i) = mesh.vertices[elements.vertex[static_cast<std::size_t>(i)]].transpose();
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 3> laplacian = elements.stiffness * x;
  double mass = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < elements.size(); ++i) {
    const FootPoint& foot = feet[elements.vertex[static_cast<std::size_t>(i)]];
    if (elements.on_border[static_cast<std::size_t>(i)] != 0 || !foot.exists) continue;
    const double m = elements.lumped_mass[i];
    const double h = foot.mean_curvature();
    mass += m;
    squares += m * h * h;
    largest = std::max(largest, (laplacian.row(i).transpose() / (2.0 * m) - h * foot.normal()).norm());
  }
  // ∫H² is at least 4π on a closed surface (Willmore): this is rounding.
  if (!(squares > 1e-9)) return std::nullopt;
  return largest / std::sqrt(squares / mass);
}

}  // namespace isobench
