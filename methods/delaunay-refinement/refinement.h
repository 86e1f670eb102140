// Delaunay refinement of F = c by CGAL, behind an interface that needs none of its headers.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <memory>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::delaunay_refinement {

/// The surface to mesh and the bounds that its facets must meet. The referenced objects must outlive the refinement.
struct Problem {
  const Isosurface& surface;
  const SizingField& sizes;
  std::vector<Eigen::Vector3d> seeds;  ///< on F = c, several on every component; together they span a tetrahedron
  double angle = 30.0;     ///< degrees, lower bound on a facet's angles; above 30, refinement may not terminate
  double distance = 0.0;   ///< mm, upper bound on circumcentre to centre of the surface ball; 0: no bound
  const Monitor& monitor;  ///< asked regularly whether to go on
  /// For engines that an exception must not leave: if not null, it is set on cancellation and Cancelled is not thrown.
  std::atomic<bool>* stop = nullptr;
};

class Refinement {
 public:
  virtual ~Refinement() = default;
  /// Refines until every facet's surface ball (centred on F = c, through the facet's corners, without vertices inside)
  /// has a radius of at most `factor`·h at its centre and the facets form a closed manifold. A later call continues
  /// from the present mesh, so factors must not grow. Throws Cancelled, and Error where CGAL does not go on.
  virtual TriangleMesh refine(double factor) = 0;

 protected:
  Refinement() = default;
  Refinement(const Refinement&) = default;
  Refinement& operator=(const Refinement&) = default;
};

/// CGAL's Mesh_3, refining facets only (Boissonnat, Oudot 2005; Jamin et al. 2015). The parallel variant uses all
/// threads through TBB; two runs of it give different meshes.
std::unique_ptr<Refinement> refinement_by_mesh_3(const Problem& problem);
std::unique_ptr<Refinement> refinement_by_parallel_mesh_3(const Problem& problem);
/// The older make_surface_mesh (Rineau, Yvinec 2007).
std::unique_ptr<Refinement> refinement_by_surface_mesher(const Problem& problem);

}  // namespace isobench::delaunay_refinement
