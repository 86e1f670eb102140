#include "isobench/methods/delaunay-refinement/cgal_mesh_3.h"

namespace isobench::delaunay_refinement {

std::unique_ptr<Refinement> refinement_by_parallel_mesh_3(const Problem& problem) {
  return std::make_unique<RefinementByMesh3<CGAL::Parallel_tag>>(problem);
}

}  // namespace isobench::delaunay_refinement
