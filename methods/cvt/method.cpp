#include "isobench/methods/method.h"

#include <cmath>
#include <limits>

#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/cvt/optimise.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/cure/cure.h"
#include "isobench/methods/particles/cure/local_relaxation.h"
#include "isobench/methods/particles/sampling/component_seeds.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench {
namespace {

using namespace cvt;

void record_cure(const particles::CureResult& cured, Monitor& monitor) {
  monitor.set("cvt/pinched", static_cast<double>(cured.after.pinched));
  monitor.set("cvt/tilted", static_cast<double>(cured.after.tilted));
  monitor.set("cvt/crossed", static_cast<double>(cured.after.crossed));
  monitor.set("cvt/lost components", static_cast<double>(cured.after.lost));
  monitor.add("cvt/inserted", static_cast<double>(cured.inserted));
  monitor.add("cvt/labels changed", static_cast<double>(cured.flipped));
}

class Mesher {
 public:
  Mesher(const MeshingTask& task, particles::SizedSurface& sized, Monitor& monitor)
      : task_(task), sized_(sized), monitor_(monitor) {}

  TriangleMesh mesh() {
    seed();
    std::vector<Triangle> triangles = close();
    optimise({task_.parameters.integer("lloyd"), task_.parameters.integer("quasi_newton")}, std::move(triangles));
    std::size_t sites = sites_.size();
    triangles = close();
    // The optimisation would spread the sites that the cure has added, and the defects would return. So h is made
    // smaller around them.
    const int rounds = task_.parameters.integer("rounds");
    int round = 0;
    for (; round < rounds && sites_.size() > sites && !gave_up_; ++round) {
      particles::shrink_around({sites_.points.begin() + static_cast<std::ptrdiff_t>(sites), sites_.points.end()},
                               sized_);
      constexpr Iterations again{3, 20};
      optimise(again, std::move(triangles));
      sites = sites_.size();
      triangles = close();
    }
    monitor_.set("cvt/rounds", round);
    TriangleMesh result;
    result.triangles = std::move(triangles);
    result.vertices = std::move(sites_.points);
    monitor_.set("cvt/unused", static_cast<double>(drop_unused_vertices(result)));
    if (result.triangles.empty()) throw Skipped("cvt: the sites are too few or too far apart to show the surface");
    return result;
  }

 private:
  void seed() {
    const auto stage = monitor_.stage("seeds");
    const TriangleMesh lattice_mesh = marching_cubes(task_.surface, monitor_);
    const double ideal = task_.sizing.vertices.value_or(particles::ideal_count(sized_, lattice_mesh));
    std::vector<Eigen::Vector3d> seeds =
        particles::eliminate_to_seeds(sized_, lattice_mesh, static_cast<std::size_t>(std::llround(ideal)),
                                      task_.parameters.number("candidates"), task_.seed, monitor_);
    particles::add_component_seeds(task_.topology(monitor_), sized_, seeds);
    sites_ = particles::make_particles(sized_, std::move(seeds));
    seeds_ = sites_.size();
    monitor_.set("cvt/seeds", static_cast<double>(seeds_));
  }

  void optimise(const Iterations& iterations, std::vector<Triangle> triangles) {
    const auto stage = monitor_.stage("optimisation");
    DelaunayMesh mesh(std::move(triangles), sites_.size());
    const Optimised done = cvt::optimise(sized_, sites_, mesh, iterations, monitor_);
    monitor_.add("cvt/lloyd iterations", done.lloyd);
    monitor_.add("cvt/quasi-newton iterations", done.quasi_newton);
    monitor_.add("cvt/shortened steps", static_cast<double>(done.shortened));
    monitor_.add("cvt/flips", static_cast<double>(done.flips));
    monitor_.set("cvt/energy", done.energy);
  }

  /// The labelled Delaunay triangulation of the sites, after a cure that may add sites.
  std::vector<Triangle> close() {
    const auto stage = monitor_.stage("triangulation");
    particles::drop_doubles(sites_);
    LabelledDelaunay delaunay(sites_.points, task_.surface, monitor_);
    particles::CureOptions options;
    options.rounds = task_.parameters.integer("cure");
    options.usual_particles = seeds_;
    const particles::CureResult cured =
        particles::cure(sized_, task_.topology(monitor_), sites_, delaunay, options, monitor_);
    record_cure(cured, monitor_);
    gave_up_ = cured.gave_up;
    return delaunay.triangles();
  }

  const MeshingTask& task_;
  particles::SizedSurface& sized_;
  Monitor& monitor_;
  particles::Particles sites_;
  std::size_t seeds_ = 0;
  bool gave_up_ = false;  // the cure has, on these sites
};

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  const auto field = task.sizing_field(monitor);
  constexpr double delta = 0.3;  // slope of h around a place where it is made smaller
  const double contraction = task.sizing.uniform() ? 1.0 : task.parameters.number("contraction");
  particles::SizedSurface sized(task.surface, *field, contraction, delta);
  return Mesher(task, sized, monitor).mesh();
}

}  // namespace

Method method_cvt() {
  Method method;
  method.name = "cvt";
  method.summary =
      "Centroidal Voronoi tessellation of F = c with density 1/h^4, by Lloyd's iterations and L-BFGS, closed by a "
      "sign-labelled Delaunay triangulation (Du, Faber, Gunzburger 1999; Liu, Wang, Levy et al. 2009)";
  method.revision = 5;
  method.parameters = {
      {"contraction",
       1.5,
       "",
       "g: with an adaptive sizing, sites are spaced by h/g as for particles, so that methods compare at equal sizing",
       1.0,
       4.0,
       {},
       false},
      {"candidates", 4.0, "per site", "random candidates from which the seeds are chosen", 2.0, 20.0, {}, false},
      {"lloyd", 10.0, "", "maximum number of Lloyd iterations", 0.0, 10000.0, {}, true},
      {"quasi_newton", 60.0, "", "maximum number of L-BFGS iterations after them", 0.0, 10000.0, {}, true},
      {"rounds",
       8.0,
       "",
       "maximum number of rounds that make h smaller around sites added by the cure and optimise again",
       0.0,
       100.0,
       {},
       true},
      {"cure",
       20.0,
       "",
       "maximum number of rounds that add sites where the topology of the triangulation is not that of the surface",
       0.0,
       100.0,
       {},
       true},
  };
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
