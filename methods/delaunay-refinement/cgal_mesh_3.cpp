#include "isobench/methods/delaunay-refinement/cgal_mesh_3.h"

namespace isobench::delaunay_refinement {

std::unique_ptr<Refinement> refinement_by_mesh_3(const Problem& problem) {
  return std::make_unique<RefinementByMesh3<CGAL::Sequential_tag>>(problem);
}

}  // namespace isobench::delaunay_refinement
