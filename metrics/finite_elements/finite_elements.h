// Linear finite elements on a triangle mesh: the matrices that geometry processing and simulation work with.
//
//   K   stiffness, ∫ ∇φ_i·∇φ_j. For the two ends of an edge it is −(cot α + cot β)/2, with the angles opposite to the
//       edge (Pinkall and Polthier 1993; Dziuk 1988 for surfaces). Without unit.
//   M   consistent mass, ∫ φ_i φ_j: area/6 on the diagonal of a triangle, area/12 beside it. mm².
//   M_L lumped mass: a third of the area of a vertex's triangles. mm².
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/finite_elements/sparse_matrix.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

/// The cotangent of the angle at a corner: `u` and `v` lead from it to the other two. ±∞ for an angle of 0° or 180° in
/// a triangle without area.
double cotangent(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/// Each vertex that has a triangle is an unknown. Triangles with two equal corners are left out.
struct FiniteElements {
  std::vector<std::uint32_t> vertex;  ///< of each unknown, rising
  SparseMatrix stiffness;             ///< K
  SparseMatrix mass;                  ///< M
  Eigen::VectorXd lumped_mass;        ///< M_L
  /// Whether the vertex is the end of an edge that has not exactly two triangles. There, K says nothing of curvature.
  std::vector<std::uint8_t> on_border;
  std::size_t triangles = 0;
  double area = 0.0;  ///< mm²
  /// Whether all cotangents are finite and all lumped masses positive. They are not where a triangle has no area.
  bool regular = false;

  Eigen::Index size() const { return lumped_mass.size(); }
  /// The squared edge length of as many equilateral triangles of the same area, (4/√3) · area/triangles. mm².
  double mean_squared_edge() const;
  /// L²: the squared radius of a sphere with this area. mm².
  double squared_radius() const;
};

/// Linear time; about 0.4 s for 250,000 vertices. `sides` are sorted_half_edges() of the mesh. Works for any mesh:
/// with borders, with edges of three triangles, with triangles that have no area.
FiniteElements finite_elements(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides);

/// The edge length h_i that was asked for at each unknown, scaled by one factor so that the cells of hexagonal lattices
/// with these lengths, Σ (√3/2) h_i², have the mesh's area: otherwise meshes with longer edges than asked for would
/// win. A uniform sizing, or none, gives the same length everywhere. mm. Precondition: there is an unknown.
Eigen::VectorXd asked_lengths(const FiniteElements& elements, const TriangleMesh& mesh, const SizingField* sizing);

/// Why a mesh has no figures that need K, as FigureDeclaration::unmeasured says it.
inline constexpr const char* no_stiffness = "a triangle of the mesh has no area";

}  // namespace isobench
