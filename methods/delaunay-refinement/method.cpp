#include "isobench/methods/method.h"

#include <cmath>

#include "isobench/methods/delaunay-refinement/refinement.h"
#include "isobench/methods/delaunay-refinement/seeds.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace delaunay_refinement {
namespace {

struct Engine {
  std::unique_ptr<Refinement> (*start)(const Problem&);
  /// The bound on the radii of surface balls at which a smooth surface gets as many vertices as equilateral triangles
  /// with edges of length 1 would have. Measured on spheres and tori of 2,000 to 50,000 vertices, with angles ≥ 30°.
  double radius;
};

Engine engine_of(const Parameters& parameters) {
  const bool parallel = parameters.flag("parallel");
  if (parameters.text("engine") == "mesh-3")
    return {parallel ? refinement_by_parallel_mesh_3 : refinement_by_mesh_3, 0.756};
  if (parallel) throw Skipped("delaunay-refinement: the engine surface-mesher has no parallel variant");
  return {refinement_by_surface_mesher, 0.770};
}

/// Refines to a requested number of vertices. A mesh with too few vertices is refined further, which gives the same
/// mesh as a smaller bound from the start. Vertices cannot be removed: a mesh with too many is made again.
class RefinementToNumber {
 public:
  RefinementToNumber(const Engine& engine, const Problem& problem, double vertices)
      : engine_(engine), problem_(problem), vertices_(vertices) {}

  TriangleMesh mesh(Monitor& monitor) {
    double factor = engine_.radius * (1.0 + margin);
    std::unique_ptr<Refinement> refinement = engine_.start(problem_);
    TriangleMesh mesh = refinement->refine(factor);
    int tries = 1;
    for (; tries < most && std::abs(share(mesh) - 1.0) > tolerance; ++tries) {
      factor *= std::sqrt(share(mesh));
      if (share(mesh) > 1.0) {
        factor *= 1.0 + margin;
        refinement = engine_.start(problem_);
      }
      mesh = refinement->refine(factor);
    }
    monitor.set("delaunay-refinement/tries", tries);
    monitor.set("delaunay-refinement/radius over h", factor);
    return mesh;
  }

 private:
  double share(const TriangleMesh& mesh) const { return static_cast<double>(mesh.vertices.size()) / vertices_; }

  static constexpr double tolerance = 0.01;
  static constexpr double margin = 0.003;
  static constexpr int most = 8;

  const Engine& engine_;
  const Problem& problem_;
  double vertices_;
};

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  const Engine engine = engine_of(task.parameters);
  const auto field = task.sizing_field(monitor);
  Problem problem{task.surface,
                  *field,
                  {},
                  task.parameters.number("angle"),
                  task.parameters.number("distance") * task.surface.voxel(),
                  monitor};
  {
    const auto stage = monitor.stage("seeds");
    constexpr double spacing = 3.0;
    problem.seeds = seeds_on(marching_cubes(task.surface, monitor), spacing * field->largest(), task.seed);
    monitor.set("delaunay-refinement/seeds", static_cast<double>(problem.seeds.size()));
  }
  const auto stage = monitor.stage("refinement");
  TriangleMesh mesh;
  if (task.sizing.vertices) {
    mesh = RefinementToNumber(engine, problem, *task.sizing.vertices).mesh(monitor);
  } else {
    const double contraction = task.sizing.uniform() ? 1.0 : task.parameters.number("contraction");
    mesh = engine.start(problem)->refine(engine.radius / contraction);
  }
  if (mesh.triangles.empty()) throw Skipped("delaunay-refinement: no facet was found; the surface may be too small");
  return mesh;
}

}  // namespace
}  // namespace delaunay_refinement

Method method_delaunay_refinement() {
  Method method;
  method.name = "delaunay-refinement";
  method.summary =
      "CGAL's Delaunay refinement of F = c with Mesh_3 or make_surface_mesh (Boissonnat, Oudot 2005; Rineau, Yvinec "
      "2007; Jamin, Alliez, Yvinec, Boissonnat 2015)";
  method.parameters = {
      {"engine",
       std::string("mesh-3"),
       "",
       "CGAL package: Mesh_3 or the older make_surface_mesh",
       0.0,
       0.0,
       {"mesh-3", "surface-mesher"}},
      {"parallel", false, "", "refine on all threads (mesh-3 only); two runs then give different meshes"},
      {"contraction", 1.5, "",
       "g: adaptive sizing aims at a mean edge length of h/g, as particles does, so that methods compare at equal "
       "sizing",
       1.0, 4.0},
      {"angle", 30.0, "°", "lower bound on the angles of triangles; 0: no bound", 0.0, 30.0},
      {"distance", 0.0, "voxels",
       "upper bound on the distance from a facet's circumcentre to the centre of its surface ball; 0: no bound", 0.0,
       100.0},
  };
  // The surface mesher gave different meshes for the same seed, perhaps because it orders cells by their addresses.
  method.deterministic_with = [](const Parameters& parameters) {
    return !parameters.flag("parallel") && parameters.text("engine") == "mesh-3";
  };
  method.mesh = delaunay_refinement::mesh;
  return method;
}

}  // namespace isobench
