#include "isobench/methods/particles/finish/easing.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <vector>

#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/particles/closing_stage.h"
#include "isobench/methods/particles/finish/finish.h"
#include "isobench/methods/particles/finish/thinning.h"
#include "isobench/methods/particles/mesh_edits/shortfall.h"
#include "isobench/methods/particles/sampling_stages.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench::particles {
namespace {

constexpr double edge_length = 2.5;  // mm

/// A mesh of particles on a phantom, dense at a place where a bound makes h a third of what the sizing asks for.
struct Crowded {
  explicit Crowded(const std::string& name)
      : surface(surface_of(name, 48)), sizing(edge_length), sized(surface, sizing) {
    Monitor monitor;
    const TriangleMesh lattice = marching_cubes(surface, monitor);
    const Eigen::Vector3d& place = lattice.vertices.front();
    // A second bound nearby, as the cure makes them: to raise only one of the two changes nothing.
    sized.add_bounds({{place, edge_length / 3.0, edge_length, edge_length},
                      {place + Eigen::Vector3d::Constant(0.2), edge_length / 2.9, edge_length, edge_length}});
    const Method& method = isobench::method("particles");
    const MeshingTask task(surface, uniform(edge_length), Parameters(method.parameters), 1);
    Particles particles = seed_particles(task, sized, lattice, {}, monitor);
    relax_particles(task, sized, particles, monitor);
    given = close_particles(task, sized, std::move(particles), monitor);
    FinishOptions options;
    options.easing = 0.0;
    given = finish(sized, given, options, monitor);
  }

  EditableMesh editable() const {
    std::vector<Eigen::Vector3d> normals;
    for (const auto& x : given.vertices) normals.push_back(outward_normal(surface.value_gradient(x).gradient));
    return {given.vertices, normals, given.triangles};
  }
  FinishContext context() const { return {surface, sizing, AskedAreas(sized, given), finish_energies(sizing)}; }
  double least_share(const EditableMesh& mesh) const {
    const std::vector<double> shares = area_shares(mesh, context().areas.with_bounds({}));
    return *std::min_element(shares.begin(), shares.end());
  }

  Isosurface surface;
  SizingField sizing;
  SizedSurface sized;
  TriangleMesh given;
};

TEST(Easing, RemovesVerticesThatNothingNeeds) {
  for (const char* name : {"sphere", "torus"}) {
    const Crowded crowded(name);
    const FinishContext context = crowded.context();
    EditableMesh mesh = crowded.editable();
    ASSERT_LT(crowded.least_share(mesh), 0.3) << name;
    ASSERT_EQ(shortfall(context, mesh, {}), 0.0) << name;
    SearchBudget budget{1e6};
    EXPECT_EQ(ease_bounds(context, crowded.sized, mesh, {}, budget), 2U) << name;
    EXPECT_GT(crowded.least_share(mesh), 0.55) << name;
    EXPECT_EQ(shortfall(context, mesh, {}), 0.0) << name;
    const TriangleMesh eased = mesh.triangle_mesh();
    EXPECT_LT(eased.vertices.size(), crowded.given.vertices.size() - 10) << name;
    EXPECT_EQ(mesh_facts(eased).euler, phantom(name).euler) << name;
    EXPECT_EQ(mesh_facts(eased).open_edges, 0U) << name;
  }
}

/// The best shapes that all triangles of a mesh have.
ShapeGoal own_goal(const FinishContext& context, const EditableMesh& mesh) {
  ShapeGoal goal{1.0, 60.0, 60.0};
  while (shortfall(context, mesh, goal) > 0.0) {
    goal.radius_ratio -= 0.002;
    goal.least_angle -= 0.2;
    goal.largest_angle += 0.2;
  }
  return goal;
}

// With little work allowed, fewer vertices do not have the shapes that more had.
TEST(Thinning, SucceedsOnlyIfTheGoalIsKept) {
  const Crowded crowded("sphere");
  const FinishContext given = crowded.context();
  FinishContext raised = given;
  raised.areas = given.areas.with_bounds({});
  const ShapeGoal goal = own_goal(given, crowded.editable());
  int successes = 0;
  int failures = 0;
  for (const double moves : {1.0, 100.0, 300.0, 1000.0, 3000.0, 1e6}) {
    EditableMesh mesh = crowded.editable();
    SearchBudget budget{moves};
    const bool succeeded = thin_out(raised, given.areas, goal, mesh, budget);
    (succeeded ? successes : failures) += 1;
    EXPECT_TRUE(!succeeded || shortfall(given, mesh, goal) == 0.0) << moves;
    EXPECT_LT(mesh.triangle_mesh().vertices.size(), crowded.given.vertices.size());
  }
  EXPECT_GT(successes, 0);
  EXPECT_GT(failures, 0);
}

TEST(Easing, DoesNotDependOnThreads) {
  const Crowded crowded("torus");
  std::vector<TriangleMesh> meshes;
  for (const std::size_t threads : {1U, 3U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EditableMesh mesh = crowded.editable();
    SearchBudget budget{1e6};
    ease_bounds(crowded.context(), crowded.sized, mesh, {}, budget);
    meshes.push_back(mesh.triangle_mesh());
  }
  EXPECT_EQ(meshes[0].vertices, meshes[1].vertices);
  EXPECT_EQ(meshes[0].triangles, meshes[1].triangles);
}

}  // namespace
}  // namespace isobench::particles
