// CGAL's Mesh_3 on F = c, for one thread or for several.
#pragma once

#include <CGAL/Mesh_3/Mesher_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_facet_topology.h>
#include <CGAL/Mesh_triangulation_3.h>

#include <array>
#include <filesystem>
#include <tuple>
#if CGAL_VERSION_NR < 1060000000
#include <boost/optional.hpp>
#else
#include <optional>
#endif

#include "isobench/methods/cgal_failure.h"
#include "isobench/methods/delaunay-refinement/cgal_oracle.h"

namespace isobench::delaunay_refinement {

// The concept MeshDomain_3 asks for std::optional from CGAL 6 on. Only CGAL's own domains have a name for the type, and
// their headers take longer to compile than the mesher's.
#if CGAL_VERSION_NR < 1060000000
template <class Value>
using MeshOptional = boost::optional<Value>;
#else
template <class Value>
using MeshOptional = std::optional<Value>;
#endif

/// A model of CGAL's concept MeshDomain_3: one body, bounded by one surface. CGAL's own labelled domain uses only the
/// sign of f and finds a crossing by bisection; with the values of f it takes half as many evaluations and is exact.
class Domain {  // NOLINTBEGIN(readability-identifier-naming): the concept's names
 public:
  using R = Kernel;
  using FT = Kernel::FT;
  using Point_3 = Kernel::Point_3;
  using Segment_3 = Kernel::Segment_3;
  using Ray_3 = Kernel::Ray_3;
  using Line_3 = Kernel::Line_3;
  using Vector_3 = Kernel::Vector_3;
  using Has_features = CGAL::Tag_false;
  using Subdomain_index = int;
  using Surface_patch_index = int;
  using Index = int;
  using Subdomain = MeshOptional<Subdomain_index>;
  using Surface_patch = MeshOptional<Surface_patch_index>;
  using Intersection = std::tuple<Point_3, Index, int>;

  explicit Domain(const Problem& problem) : dual_(problem) {}

  CGAL::Bbox_3 bbox() const {
    const Eigen::Vector3d& high = dual_.problem().surface.extent();
    return {0.0, 0.0, 0.0, high[0], high[1], high[2]};
  }

  struct Is_in_domain {
    Dual dual;
    Subdomain operator()(const Point_3& p) const { return dual.is_inside(p) ? Subdomain(the_only) : Subdomain(); }
  };
  Is_in_domain is_in_domain_object() const { return {dual_}; }

  struct Construct_intersection {
    Dual dual;
    template <class Query>
    Intersection operator()(const Query& query) const {
      const std::optional<Point_3> x = dual.crossing(query);
      return x ? Intersection(*x, the_only, 2) : Intersection(Point_3(), 0, 0);
    }
  };
  Construct_intersection construct_intersection_object() const { return {dual_}; }

  struct Do_intersect_surface {
    Dual dual;
    template <class Query>
    Surface_patch operator()(const Query& query) const {
      return dual.crossing(query) ? Surface_patch(the_only) : Surface_patch();
    }
  };
  Do_intersect_surface do_intersect_surface_object() const { return {dual_}; }

  Index index_from_surface_patch_index(Surface_patch_index index) const { return index; }
  Index index_from_subdomain_index(Subdomain_index index) const { return index; }
  Surface_patch_index surface_patch_index(Index index) const { return index; }
  Subdomain_index subdomain_index(Index index) const { return index; }

  static constexpr int the_only = 1;

 private:
  Dual dual_;
};  // NOLINTEND(readability-identifier-naming)

/// The bound on the radius of a facet's surface ball, in the form that Mesh_3 takes.
struct RadiusBound {  // NOLINTBEGIN(readability-identifier-naming): the concept's names
  using FT = Kernel::FT;
  using Point_3 = Kernel::Point_3;
  using Index = Domain::Index;
  FT operator()(const Point_3& p, int /*dimension*/, Index /*index*/) const { return factor * sizes->h(to_eigen(p)); }

  const SizingField* sizes;
  double factor;
};  // NOLINTEND(readability-identifier-naming)

/// Where Mesh_3 stops at one of its own checks, it leaves its state in two files of the working folder. This removes
/// them, unless files of these names were there before.
class NoDumps {
 public:
  NoDumps() {
    for (std::size_t n = 0; n < names.size(); ++n) existed_[n] = std::filesystem::exists(names[n]);
  }
  ~NoDumps() {
    std::error_code ignored;
    for (std::size_t n = 0; n < names.size(); ++n) {
      if (!existed_[n]) std::filesystem::remove(names[n], ignored);
    }
  }
  NoDumps(const NoDumps&) = delete;
  NoDumps& operator=(const NoDumps&) = delete;

 private:
  static constexpr std::array names = {"dump-bug.mesh", "dump-bug.binary.cgal"};
  std::array<bool, names.size()> existed_{};
};

template <class Concurrency>
class RefinementByMesh3 final : public Refinement {
 public:
  explicit RefinementByMesh3(const Problem& problem) : problem_(problem), domain_(problem_) {
    problem_.stop = &stop_;  // an exception would leak the parallel mesher's task groups
    Triangulation& triangulation = complex_.triangulation();
    const auto weighted = triangulation.geom_traits().construct_weighted_point_3_object();
    for (const Eigen::Vector3d& seed : problem_.seeds) {
      const auto vertex = triangulation.insert(weighted(to_point(seed)));
      complex_.set_dimension(vertex, 2);
      complex_.set_index(vertex, Domain::the_only);
    }
  }

  TriangleMesh refine(double factor) override {
    const typename Criteria::Facet_criteria facets(problem_.angle, RadiusBound{&problem_.sizes, factor},
                                                   problem_.distance);
    const typename Criteria::Cell_criteria cells(0.0, 0.0);  // no bounds: only facets matter here
    const Criteria criteria(facets, cells);                  // must outlive the mesher
    // These are the steps of CGAL::refine_mesh_3 without its cell optimisers, which take a minute and 2 GB to compile.
    CGAL::Mesh_3::Mesher_3<Complex, Criteria, Domain> mesher(complex_, domain_, criteria, CGAL::MANIFOLD, 0, nullptr,
                                                             &stop_);
    with_cgal("delaunay-refinement", [&mesher] {
      const NoDumps no_dumps;
      mesher.refine_mesh();
    });
    problem_.monitor.check();
    complex_.clear_manifold_info();
    MeshOfFacets<typename Triangulation::Vertex_handle> mesh;
    for (auto facet = complex_.facets_in_complex_begin(); facet != complex_.facets_in_complex_end(); ++facet)
      mesh.add(facet->first, facet->second, complex_.is_in_complex(facet->first));
    return mesh.take();
  }

 private:
  using Triangulation = typename CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

  std::atomic<bool> stop_{false};
  Problem problem_;
  Domain domain_;
  Complex complex_;
};

}  // namespace isobench::delaunay_refinement
