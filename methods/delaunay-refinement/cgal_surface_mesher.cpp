// CGAL 6 deprecates this package, and its headers print a warning. The engine stays as long as Debian ships the
// package, because published comparisons use it.
#define CGAL_NO_DEPRECATION_WARNINGS 1
#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include "isobench/methods/cgal_failure.h"
#include "isobench/methods/delaunay-refinement/cgal_oracle.h"

namespace isobench::delaunay_refinement {

namespace {

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Criterion = CGAL::Surface_mesher::Refine_criterion<Triangulation>;

/// A model of CGAL's concept SurfaceMeshTraits_3.
class Oracle {  // NOLINTBEGIN(readability-identifier-naming): the concept's names
 public:
  using Surface_3 = Problem;
  using Point_3 = Kernel::Point_3;
  using Segment_3 = Kernel::Segment_3;
  using Ray_3 = Kernel::Ray_3;
  using Line_3 = Kernel::Line_3;
  using Intersection_point = Point_3;

  struct Intersect_3 {
    template <class Query>
    CGAL::Object operator()(const Surface_3& problem, const Query& query) const {
      const std::optional<Point_3> x = Dual(problem).crossing(query);
      return x ? CGAL::make_object(*x) : CGAL::Object();
    }
  };
  Intersect_3 intersect_3_object() const { return {}; }

  struct Construct_initial_points {
    template <class Output>
    Output operator()(const Surface_3& problem, Output output, int count) const {
      for (int n = 0; n < count; ++n) *output++ = to_point(problem.seeds[static_cast<std::size_t>(n)]);
      return output;
    }
  };
  Construct_initial_points construct_initial_points_object() const { return {}; }
};  // NOLINTEND(readability-identifier-naming)

/// Bounds the radius of a facet's surface ball by factor·h. CGAL's own criterion has one bound for the whole surface.
class SizeCriterion final : public Criterion {
 public:
  SizeCriterion(const SizingField& sizes, double factor) : sizes_(sizes), factor_(factor) {}
  bool is_bad(const Triangulation::Facet& facet, Quality& quality) const override {
    const auto& [cell, index] = facet;
    const Kernel::Point_3& centre = cell->get_facet_surface_center(index);
    const double bound = factor_ * sizes_.h(to_eigen(centre));
    quality = bound * bound / CGAL::squared_distance(cell->vertex((index + 1) & 3)->point(), centre);
    return quality < 1.0;
  }

 private:
  const SizingField& sizes_;
  double factor_;
};

class RefinementBySurfaceMesher final : public Refinement {
 public:
  explicit RefinementBySurfaceMesher(const Problem& problem) : problem_(problem), complex_(triangulation_) {}

  TriangleMesh refine(double factor) override {
    namespace mesher = CGAL::Surface_mesher;
    mesher::Aspect_ratio_criterion<Triangulation> angles(problem_.angle);
    SizeCriterion sizes(problem_.sizes, factor);
    mesher::Curvature_size_criterion<Triangulation> distances(problem_.distance);
    const mesher::Standard_criteria<Criterion> criteria({&angles, &sizes, &distances});
    const bool is_first = triangulation_.number_of_vertices() == 0;
    with_cgal("delaunay-refinement", [&] {
      CGAL::make_surface_mesh(complex_, problem_, Oracle(), criteria, CGAL::Manifold_tag(),
                              is_first ? static_cast<int>(problem_.seeds.size()) : 0);
    });
    MeshOfFacets<Triangulation::Vertex_handle> mesh;
    for (auto facet = complex_.facets_begin(); facet != complex_.facets_end(); ++facet)
      mesh.add(facet->first, facet->second, is_inside(facet->first));
    return mesh.take();
  }

 private:
  bool is_inside(const Triangulation::Cell_handle& cell) const {
    return !triangulation_.is_infinite(cell) && Dual(problem_).is_inside(triangulation_.dual(cell));
  }

  Problem problem_;
  Triangulation triangulation_;
  Complex complex_;
};

}  // namespace

std::unique_ptr<Refinement> refinement_by_surface_mesher(const Problem& problem) {
  return std::make_unique<RefinementBySurfaceMesher>(problem);
}

}  // namespace isobench::delaunay_refinement
