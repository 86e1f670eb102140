// A triangle mesh on F = c that can be changed locally: half-edges in plain index arrays.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::particles {

/// Three half-edges a triangle: half-edge e belongs to triangle e/3 and runs from its origin to the next one's.
///
/// Where the triangles do not form one closed fan around a vertex (a border, a pinch), or where fix() says so, the
/// vertex is fixed: it stays where it is, and no operation takes it away. That makes a piece cut out of a mesh a mesh
/// of its own.
class EditableMesh {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  EditableMesh() = default;
  /// Normals are outward and unit, one a vertex. Cost: O(n log n).
  EditableMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Eigen::Vector3d> normals,
               std::span<const Triangle> triangles);

  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;

  std::size_t vertex_count() const { return points.size(); }  ///< with those taken away
  std::size_t half_edge_count() const { return origin_.size(); }
  bool alive(Index v) const { return out_[v] != none; }
  bool fixed(Index v) const { return fixed_[v] != 0; }
  /// Makes v one of the fixed vertices. Where all corners are, triangles stay as they are.
  void fix(Index v) { fixed_[v] = 1; }
  bool movable(Index v) const { return alive(v) && !fixed(v); }
  bool triangle_alive(Index t) const { return origin_[3 * t] != none; }
  Triangle triangle(Index t) const { return {origin_[3 * t], origin_[3 * t + 1], origin_[3 * t + 2]}; }
  /// How many triangles are around v; of a piece, in the mesh that it was cut from, if set_valence() said so.
  Index valence(Index v) const { return valence_[v]; }
  void set_valence(Index v, Index valence) { valence_[v] = valence; }

  static Index next(Index e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static Index previous(Index e) { return e % 3 == 0 ? e + 2 : e - 1; }
  Index origin(Index e) const { return origin_[e]; }
  Index target(Index e) const { return origin_[next(e)]; }
  Index apex(Index e) const { return origin_[previous(e)]; }
  Index twin(Index e) const { return twin_[e]; }
  /// A half-edge from v; of a movable vertex, turn() leads through all of them counter-clockwise.
  Index out(Index v) const { return out_[v]; }
  Index turn(Index e) const { return twin_[previous(e)]; }
  /// True also where that cannot be told because both are fixed.
  bool adjacent(Index u, Index v) const;

  /// Whether the mesh is still one, at every edge and vertex, after the operation.
  bool can_flip(Index e) const;
  bool can_collapse(Index e) const;

  /// Turns the edge within its two triangles. Precondition: can_flip.
  void flip(Index e);
  /// Takes origin(e) away: its triangles are drawn to target(e). Precondition: can_collapse.
  void collapse(Index e);
  /// A new vertex on an edge with two triangles. Returns it.
  Index split_edge(Index e, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
  /// A new vertex takes the triangles from half-edge `first` counter-clockwise up to `last`, both from the same movable
  /// vertex, with at least one triangle on either side. Returns it.
  Index split_vertex(Index first, Index last, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  /// Puts `fresh` in the place of the triangles `old`, which cover the same piece: same border, same turning.
  void replace(std::span<const Index> old, std::span<const Triangle> fresh);
  Index add_vertex(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  /// What is alive, vertices in their order.
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
