// Shared by CGAL's two surface meshers: their queries about F = c, and the conversion of their facets to a mesh.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_hash_function.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include "isobench/methods/delaunay-refinement/crossing.h"
#include "isobench/methods/delaunay-refinement/refinement.h"

namespace isobench::delaunay_refinement {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Eigen::Vector3d to_eigen(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }
inline Kernel::Point_3 to_point(const Eigen::Vector3d& x) { return {x[0], x[1], x[2]}; }

/// Where the dual of a facet crosses F = c. The dual is the segment between the circumcentres of two cells or, at the
/// convex hull, a ray.
class Dual {
 public:
  explicit Dual(const Problem& problem) : problem_(&problem) {}

  std::optional<Kernel::Point_3> crossing(const Kernel::Segment_3& segment) const {
    return between(to_eigen(segment.source()), to_eigen(segment.target()));
  }
  /// The ray is followed until it has left the volume.
  std::optional<Kernel::Point_3> crossing(const Kernel::Ray_3& ray) const {
    const Eigen::Vector3d from = to_eigen(ray.source());
    const Kernel::Vector_3 along = ray.to_vector();
    const Eigen::Vector3d direction = Eigen::Vector3d(along.x(), along.y(), along.z()).normalized();
    const double reach = (from.cwiseAbs() + problem_->surface.extent()).norm();
    return between(from, from + reach * direction);
  }
  /// Duals are lines only while all vertices lie in one plane; the seeds span a tetrahedron.
  std::optional<Kernel::Point_3> crossing(const Kernel::Line_3& /*line*/) const { return std::nullopt; }

  bool is_inside(const Kernel::Point_3& p) const {
    return delaunay_refinement::is_inside(problem_->surface, to_eigen(p));
  }
  const Problem& problem() const { return *problem_; }

 private:
  void check() const {
    if (problem_->stop == nullptr) return problem_->monitor.check();
    if (problem_->monitor.is_cancelled()) problem_->stop->store(true);
  }

  std::optional<Kernel::Point_3> between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    check();
    const std::optional<Eigen::Vector3d> x = delaunay_refinement::crossing(problem_->surface, a, b);
    if (!x) return std::nullopt;
    return to_point(*x);
  }

  const Problem* problem_;
};

/// Collects facets into a mesh; vertices are numbered in the order in which they are met.
template <class Vertex>
class MeshOfFacets {
 public:
  /// Adds the facet of `cell` opposite its vertex `index`; `inside` says whether the cell is inside the object.
  template <class Cell>
  void add(const Cell& cell, int index, bool inside) {
    Triangle triangle{};
    for (int corner = 0; corner < 3; ++corner) {
      // For an even index, these corners run clockwise seen from the opposite vertex (CGAL's convention), so
      // counter-clockwise seen from outside the cell.
      const int at = (index + 1 + corner) & 3;
      triangle[static_cast<std::size_t>(corner)] = number(cell->vertex(at));
    }
    if ((index % 2 == 0) != inside) std::swap(triangle[1], triangle[2]);
    mesh_.triangles.push_back(triangle);
  }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t number(const Vertex& vertex) {
    const auto [entry, is_new] = numbers_.try_emplace(vertex, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const auto& p = vertex->point();
      mesh_.vertices.emplace_back(p.x(), p.y(), p.z());
    }
    return entry->second;
  }

  TriangleMesh mesh_;
  std::unordered_map<Vertex, std::uint32_t, CGAL::Handle_hash_function> numbers_;
};

}  // namespace isobench::delaunay_refinement
