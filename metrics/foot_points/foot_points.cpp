#include "isobench/metrics/foot_points/foot_points.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

namespace isobench {

double FootPoint::mean_curvature() const {
  const Eigen::Vector3d n = normal();
  // f decreases outwards: the divergence of n = −∇f/|∇f| is −(Δf − nᵀ∇²f n)/|∇f|, and twice the mean curvature.
  return -0.5 * (jet.hessian.trace() - n.dot(jet.hessian * n)) / jet.gradient.norm();
}

std::vector<FootPoint> foot_points(const Isosurface& surface, const std::vector<Eigen::Vector3d>& points) {
  // A step is at most half a voxel, so the steps reach surfaces within 20 voxels.
  constexpr double tolerance = 1e-9;
  constexpr int max_steps = 40;
  std::vector<FootPoint> feet(points.size());
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t n) {
    FootPoint& foot = feet[n];
    const std::optional<Eigen::Vector3d> on_surface = surface.project(points[n], tolerance, max_steps);
    foot.projected = on_surface.has_value();
    foot.x = on_surface.value_or(points[n]);
    foot.jet = surface.jet(foot.x);
    foot.exists = foot.jet.gradient.norm() > 0.0;
  });
  return feet;
}

bool any_projected(const std::vector<FootPoint>& feet) {
  return std::any_of(feet.begin(), feet.end(), [](const FootPoint& foot) { return foot.projected; });
}

std::vector<Eigen::Vector3d> centroids(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    result.emplace_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0);
  }
  return result;
}

}  // namespace isobench
