// A triangle mesh on F = c whose connectivity can be changed locally: half-edges in plain index arrays.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::particles {

/// A triangle has three half-edges. Half-edge e belongs to triangle e/3 and runs from its origin to the origin of the
/// next half-edge of the triangle.
///
/// A vertex is fixed if its triangles do not form one closed fan, as at a border or a pinch, or if fix() was called for
/// it. A fixed vertex does not move, and no operation removes it. So a part of a mesh with a border can be edited as a
/// mesh of its own.
class EditableMesh {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  EditableMesh() = default;
  /// One outward unit normal per vertex. Cost: O(n log n).
  EditableMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Eigen::Vector3d> normals,
               std::span<const Triangle> triangles);

  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;

  std::size_t vertex_count() const { return points.size(); }  ///< including removed vertices
  std::size_t half_edge_count() const { return origin_.size(); }
  bool alive(Index v) const { return out_[v] != none; }
  bool fixed(Index v) const { return fixed_[v] != 0; }
  /// Fixes v. Its triangles can still change: an edge between fixed vertices can be flipped or split.
  void fix(Index v) { fixed_[v] = 1; }
  bool movable(Index v) const { return alive(v) && !fixed(v); }
  bool triangle_alive(Index t) const { return origin_[3 * t] != none; }
  Triangle triangle(Index t) const { return {origin_[3 * t], origin_[3 * t + 1], origin_[3 * t + 2]}; }
  /// The number of triangles around v; or the number set by set_valence(), for a vertex whose other triangles are in
  /// the mesh from which this one was extracted.
  Index valence(Index v) const { return valence_[v]; }
  void set_valence(Index v, Index valence) { valence_[v] = valence; }

  static Index next(Index e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static Index previous(Index e) { return e % 3 == 0 ? e + 2 : e - 1; }
  Index origin(Index e) const { return origin_[e]; }
  Index target(Index e) const { return origin_[next(e)]; }
  Index apex(Index e) const { return origin_[previous(e)]; }
  Index twin(Index e) const { return twin_[e]; }
  /// A half-edge that starts at v.
  Index out(Index v) const { return out_[v]; }
  /// The next half-edge counter-clockwise around the origin of e. Precondition: the origin is movable.
  Index turn(Index e) const { return twin_[previous(e)]; }
  /// Whether an edge joins u and v; true also if both are fixed, where this is not known.
  bool adjacent(Index u, Index v) const;

  /// Whether the mesh stays a manifold with the same topology.
  bool can_flip(Index e) const;
  bool can_collapse(Index e) const;

  /// Replaces the edge by the other diagonal of its two triangles. Precondition: can_flip().
  void flip(Index e);
  /// Removes origin(e) by merging it into target(e). Precondition: can_collapse().
  void collapse(Index e);
  /// Inserts a vertex on an edge with two triangles. Returns the vertex.
  Index split_edge(Index e, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
  /// Splits a movable vertex, at which both half-edges start. A new vertex takes its triangles from `first` counter-
  /// clockwise up to `last`; at least one triangle is on either side. Returns the new vertex.
  Index split_vertex(Index first, Index last, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  /// Replaces the triangles `old` by `fresh`, which have the same border and orientation.
  void replace(std::span<const Index> old, std::span<const Triangle> fresh);
  Index add_vertex(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  /// The mesh without removed vertices and triangles; vertices keep their order.
  TriangleMesh triangle_mesh() const;

 private:
  Index add_triangle();
  void link(Index e, Index f);
  void pair_up(std::span<const Index> half_edges);
  void find_fixed();

  std::vector<Index> origin_;
  std::vector<Index> twin_;
  std::vector<Index> out_;
  std::vector<Index> valence_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace isobench::particles
