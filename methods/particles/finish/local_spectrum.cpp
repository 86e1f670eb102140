#include "isobench/methods/particles/finish/local_spectrum.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "isobench/foundation/random.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

struct Edge {
  Index a = 0;
  Index b = 0;
  double weight = 0.0;  // half the cotangent of the angle opposite
};

struct Laplacian {
  std::vector<Edge> edges;  // once for each triangle
  Eigen::VectorXd diagonal;
  Eigen::VectorXd mass;
  bool has_flat_triangle = false;

  explicit Laplacian(const EditableMesh& mesh)
      : diagonal(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertex_count()))), mass(diagonal) {
    for (Index t = 0; 3 * t < mesh.half_edge_count(); ++t) {
      if (mesh.triangle_alive(t)) add(mesh, mesh.triangle(t));
    }
  }

  // K x
  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result = diagonal.cwiseProduct(x);
    for (const Edge& edge : edges) {
      result[edge.a] -= edge.weight * x[edge.b];
      result[edge.b] -= edge.weight * x[edge.a];
    }
    return result;
  }

 private:
  void add(const EditableMesh& mesh, const Triangle& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{corners[k], corners[(k + 1) % 3], 0.0};
      const Eigen::Vector3d& apex = mesh.points[corners[(k + 2) % 3]];
      const Eigen::Vector3d to_a = mesh.points[edge.a] - apex;
      const Eigen::Vector3d to_b = mesh.points[edge.b] - apex;
      const double twice_area = to_a.cross(to_b).norm();
      if (!(twice_area > 0.0)) has_flat_triangle = true;
      const double weight = 0.5 * to_a.dot(to_b) / twice_area;
      edges.push_back({edge.a, edge.b, weight});
      diagonal[edge.a] += weight;
      diagonal[edge.b] += weight;
      mass[corners[k]] += twice_area / 6.0;
    }
  }
};

// The largest eigenvalue of S K S for the diagonal matrix S of `scale`.
double largest_eigenvalue(const Laplacian& laplacian, const Eigen::VectorXd& scale) {
  constexpr int iterations = 60;
  Eigen::VectorXd x(scale.size());
  for (Eigen::Index n = 0; n < x.size(); ++n) x[n] = uniform_random(1, static_cast<std::uint64_t>(n), 0) - 0.5;
  x = x.cwiseProduct(scale);
  double quotient = 0.0;
  for (int n = 0; n < iterations; ++n) {
    const double norm = x.norm();
    if (!(norm > 0.0)) break;  // no vertex is free
    x /= norm;
    const Eigen::VectorXd next = scale.cwiseProduct(laplacian.times(scale.cwiseProduct(x)));
    quotient = x.dot(next);
    x = next;
  }
  return quotient;
}

}  // namespace

LocalSpectrum local_spectrum(const EditableMesh& mesh, const std::vector<double>& areas) {
  const Laplacian laplacian(mesh);
  if (laplacian.has_flat_triangle)
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Eigen::VectorXd by_size = Eigen::VectorXd::Zero(laplacian.diagonal.size());
  Eigen::VectorXd by_diagonal = by_size;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.movable(v)) continue;
    by_size[v] = std::sqrt(4.0 / std::numbers::sqrt3 * areas[v] / laplacian.mass[v]);
    by_diagonal[v] = 1.0 / std::sqrt(std::max(laplacian.diagonal[v], 1e-300));
  }
  return {largest_eigenvalue(laplacian, by_size), largest_eigenvalue(laplacian, by_diagonal)};
}

}  // namespace isobench::particles
