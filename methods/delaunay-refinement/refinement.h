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

/// What is refined, and until when but for the size. Referred to must outlive the refinement.
struct Problem {
  const Isosurface& surface;
  const SizingField& sizes;
  std::vector<Eigen::Vector3d> seeds;  ///< on F = c, spanning a tetrahedron, some on every component
  double angle = 30.0;                 ///< degrees, smallest of a facet; above 30 refinement need not end
  double distance = 0.0;               ///< mm, of a facet's circumcentre to that of its ball on F = c; 0: any
  const Monitor& monitor;              ///< asked now and then whether to go on
  /// What an engine looks at that must not be left by an exception; set then instead of throwing Cancelled.
  std::atomic<bool>* stop = nullptr;
};

class Refinement {
 public:
  virtual ~Refinement() = default;
  /// Goes on until the ball about each facet that is centred on F = c and has no vertex inside is no larger than
  /// `factor`·h there, and the facets are a closed manifold. Later calls add to what there is, so factors may only
  /// fall. Throws Cancelled.
  virtual TriangleMesh refine(double factor) = 0;

 protected:
  Refinement() = default;
  Refinement(const Refinement&) = default;
  Refinement& operator=(const Refinement&) = default;
};

/// CGAL's Mesh_3, facets alone (Boissonnat, Oudot 2005; Jamin et al. 2015); `parallel`: on all threads by TBB, and not
/// the same mesh twice.
std::unique_ptr<Refinement> refinement_by_mesh_3(const Problem& problem);
std::unique_ptr<Refinement> refinement_by_parallel_mesh_3(const Problem& problem);
/// The older make_surface_mesh (Rineau, Yvinec 2007).
std::unique_ptr<Refinement> refinement_by_surface_mesher(const Problem& problem);

}  // namespace isobench::delaunay_refinement
