#include "isobench/methods/cvt/cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace isobench::cvt {

namespace {

/// The contribution of a triangle to the cell of one of its corners. The moment is about that corner.
struct Share {
  double mass = 0.0;
  double energy = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

/// A point in the plane of a triangle, relative to the corner whose share is computed, and the density there.
struct Node {
  Eigen::Vector3d x;
  double density;
};

/// Adds the integrals of ρ, ρ(x − p) and ρ|x − p|² over the triangle p, a, b, with ρ linear. `area` may be negative.
void add(Share& share, double area, double at_p, const Node& a, const Node& b) {
  share.mass += area * (at_p + a.density + b.density) / 3.0;
  const double to_a = area * (at_p + 2.0 * a.density + b.density) / 12.0;
  const double to_b = area * (at_p + a.density + 2.0 * b.density) / 12.0;
  share.moment += to_a * a.x + to_b * b.x;
  const double aa = area * (at_p + 3.0 * a.density + b.density) / 30.0;
  const double bb = area * (at_p + a.density + 3.0 * b.density) / 30.0;
  const double ab = area * (at_p + 2.0 * a.density + 2.0 * b.density) / 60.0;
  share.energy += aa * a.x.squaredNorm() + bb * b.x.squaredNorm() + 2.0 * ab * a.x.dot(b.x);
}

/// The shares of the three corners of a triangle, and ∫√ρ over it.
struct Shares {
  std::array<Share, 3> of{};
  double root = 0.0;
};

Shares share_out(const std::array<Eigen::Vector3d, 3>& x, const std::array<double, 3>& h) {
  Shares shares;
  const Eigen::Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]);
  const double double_area = normal.norm();
  if (double_area <= 1e-12 * (x[1] - x[0]).squaredNorm()) return shares;
  std::array<double, 3> cotangent{};
  for (std::size_t k = 0; k < 3; ++k) {
    cotangent[k] = (x[(k + 1) % 3] - x[k]).dot(x[(k + 2) % 3] - x[k]) / double_area;
  }
  // Barycentric coordinates of the circumcentre are proportional to sin 2α, hence to cot α |edge|².
  std::array<double, 3> weight{};
  for (std::size_t k = 0; k < 3; ++k) {
    weight[k] = cotangent[k] * (x[(k + 2) % 3] - x[(k + 1) % 3]).squaredNorm();
  }
  const double sum = weight[0] + weight[1] + weight[2];
  const Eigen::Vector3d centre = (weight[0] * x[0] + weight[1] * x[1] + weight[2] * x[2]) / sum;
  const double h_centre = (weight[0] * h[0] + weight[1] * h[1] + weight[2] * h[2]) / sum;
  const auto [least, most] = std::minmax({h[0], h[1], h[2]});
  const double density_centre = density(std::clamp(h_centre, least, most));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    const double at_p = density(h[k]);
    const Node to_centre{centre - x[k], density_centre};
    const Node to_next{0.5 * (x[next] - x[k]), density(0.5 * (h[k] + h[next]))};
    const Node to_last{0.5 * (x[last] - x[k]), density(0.5 * (h[k] + h[last]))};
    // The distance of the circumcentre from an edge is half the edge times the cotangent of the opposite angle.
    add(shares.of[k], 0.125 * (x[next] - x[k]).squaredNorm() * cotangent[last], at_p, to_next, to_centre);
    add(shares.of[k], 0.125 * (x[last] - x[k]).squaredNorm() * cotangent[next], at_p, to_centre, to_last);
    shares.root += double_area / 6.0 / (h[k] * h[k]);
  }
  return shares;
}

}  // namespace

double density(double h) { return 1.0 / (h * h * h * h); }

Cells voronoi_cells(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& h,
                    const std::vector<Triangle>& triangles) {
  std::vector<Shares> shares(triangles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto& [a, b, c] = triangles[n];
      shares[n] = share_out({points[a], points[b], points[c]}, {h[a], h[b], h[c]});
    }
  });
  Cells cells;
  cells.mass.assign(points.size(), 0.0);
  cells.centroids.assign(points.size(), Eigen::Vector3d::Zero());
  double root = 0.0;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    root += shares[n].root;
    for (std::size_t k = 0; k < 3; ++k) {
      const Share& share = shares[n].of[k];
      cells.mass[triangles[n][k]] += share.mass;
      cells.centroids[triangles[n][k]] += share.moment;
      cells.energy += share.energy;
    }
  }
  std::size_t count = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const bool has_cell = cells.mass[n] > 0.0;
    count += has_cell ? 1 : 0;
    cells.centroids[n] = has_cell ? (points[n] + cells.centroids[n] / cells.mass[n]).eval() : points[n];
  }
  cells.hexagonal = 5.0 / (18.0 * std::sqrt(3.0)) * root * root / static_cast<double>(count);
  return cells;
}

}  // namespace isobench::cvt
