#include "isobench/methods/particles/finish/finish.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh/self_intersections.h"
#include "isobench/methods/method.h"
#include "isobench/methods/particles/mesh_edits/bad_spots.h"
#include "isobench/methods/particles/mesh_edits/shape_energy.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench::particles {
namespace {

struct Shape {
  double least_q = 1.0;
  double mean_q = 0.0;
  double six = 0.0;  ///< share of vertices
  std::size_t outside = 0;
  double longest = 0.0;  ///< edge over h0
  double least_angle = 180.0;
  double largest_angle = 0.0;
  double least_area = 1e300;  ///< around a vertex, over the mean at the same h
  double largest_area = 0.0;
};

double degrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

void measure_areas(const TriangleMesh& mesh, const SizingField& sizing, Shape& shape) {
  std::vector<double> area(mesh.vertices.size(), 0.0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d to_b = mesh.vertices[b] - mesh.vertices[a];
    const Eigen::Vector3d to_c = mesh.vertices[c] - mesh.vertices[a];
    for (const std::uint32_t v : {a, b, c}) area[v] += to_b.cross(to_c).norm() / 6.0;
  }
  double sum = 0.0;
  double asked = 0.0;
  for (std::size_t v = 0; v < area.size(); ++v) {
    const double h = sizing.h(mesh.vertices[v]);
    sum += area[v];
    asked += h * h;
  }
  for (std::size_t v = 0; v < area.size(); ++v) {
    const double h = sizing.h(mesh.vertices[v]);
    const double share = area[v] / (h * h) * asked / sum;
    shape.least_area = std::min(shape.least_area, share);
    shape.largest_area = std::max(shape.largest_area, share);
  }
}

Shape shape_of(const TriangleMesh& mesh, const SizingField& sizing) {
  Shape shape;
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const double q = radius_ratio(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    shape.least_q = std::min(shape.least_q, q);
    shape.mean_q += q / static_cast<double>(mesh.triangles.size());
    for (std::size_t c = 0; c < 3; ++c) {
      ++valence[t[c]];
      const Eigen::Vector3d& a = mesh.vertices[t[c]];
      const Eigen::Vector3d& b = mesh.vertices[t[(c + 1) % 3]];
      shape.longest = std::max(shape.longest, 2.0 * (a - b).norm() / (sizing.h0(a) + sizing.h0(b)));
      const double angle = degrees(b - a, mesh.vertices[t[(c + 2) % 3]] - a);
      shape.least_angle = std::min(shape.least_angle, angle);
      shape.largest_angle = std::max(shape.largest_angle, angle);
    }
  }
  for (const int v : valence) {
    shape.six += v == 6 ? 1.0 / static_cast<double>(valence.size()) : 0.0;
    shape.outside += v < 5 || v > 7 ? 1 : 0;
  }
  measure_areas(mesh, sizing, shape);
  return shape;
}

struct Finished {
  TriangleMesh mesh;
  Shape shape;
  double off = 0.0;  ///< voxels, the vertex farthest from F = c
};

Finished finished(const std::string& name, int nodes, const SizingRequest& request, int rounds = -1,
                  double area_weight = 1.0) {
  const Isosurface surface(sample_phantom(phantom(name), nodes), 0.0);
  const Method& particles = method("particles");
  Parameters parameters(particles.parameters);
  if (rounds >= 0) parameters.set(particles.parameters, "finish", static_cast<double>(rounds));
  parameters.set(particles.parameters, "area_weight", area_weight);
  Monitor monitor;
  const MeshingTask task(surface, request, parameters, 1);
  Finished result{particles.mesh(task, monitor), {}, 0.0};
  result.shape = shape_of(result.mesh, *task.sizing_field(monitor));
  for (const Eigen::Vector3d& x : result.mesh.vertices) {
    const Jet jet = surface.value_gradient(x);
    result.off = std::max(result.off, std::abs(jet.value) / jet.gradient.norm() / surface.voxel());
  }
  return result;
}

// The bounds are those that the four real volumes must meet.
TEST(Finish, ReachesTheGoalUnderGradation) {
  for (const char* name : {"torus", "ellipsoid", "rounded-box", "gyroid-ball"}) {
    const Finished result = finished(name, 64, adaptive(0.25, 0.3));
    const MeshFacts facts = mesh_facts(result.mesh);
    EXPECT_EQ(facts.euler, phantom(name).euler) << name;
    EXPECT_EQ(facts.open_edges, 0U) << name;
    EXPECT_EQ(facts.nonmanifold_edges, 0U) << name;
    EXPECT_GE(result.shape.least_q, 0.84) << name;
    EXPECT_GE(result.shape.mean_q, 0.975) << name;
    EXPECT_EQ(result.shape.outside, 0U) << name;
    EXPECT_GE(result.shape.six, 0.7) << name;
    EXPECT_LE(result.shape.longest, 1.0) << name;
    EXPECT_LE(result.off, 1e-5) << name;  // Newton stops at 1e-6
  }
}

TEST(Finish, ReachesTheGoalAtUniformSize) {
  for (const char* name : {"sphere", "torus"}) {
    const Finished before = finished(name, 48, with_vertices(5000), 0);
    const Finished after = finished(name, 48, with_vertices(5000));
    EXPECT_GE(after.shape.least_q, 0.88) << name;
    EXPECT_GE(after.shape.mean_q, 0.985) << name;
    EXPECT_GT(after.shape.mean_q, before.shape.mean_q) << name;
    EXPECT_GE(after.shape.six, 0.8) << name;
    EXPECT_EQ(after.shape.outside, 0U) << name;
    EXPECT_NEAR(static_cast<double>(after.mesh.vertices.size()), 5000.0, 100.0) << name;
  }
}

// Smallest vertex areas decide the step of explicit time integration. With shapes alone they go down to 0.5.
TEST(Finish, MakesAreasEven) {
  const auto check = [](const char* name, const SizingRequest& request, double least, double largest) {
    const Shape even = finished(name, 64, request).shape;
    EXPECT_GE(even.least_area, least) << name;
    EXPECT_LE(even.largest_area, largest) << name;
    EXPECT_GE(even.least_angle, 42.0) << name;
    EXPECT_LE(even.largest_angle, 82.0) << name;
    const Shape shapes_alone = finished(name, 64, request, -1, 0.0).shape;
    EXPECT_LT(shapes_alone.least_area, even.least_area - 0.05) << name;
    EXPECT_GT(shapes_alone.mean_q, even.mean_q) << name;
  };
  check("sphere", with_vertices(5000), 0.65, 1.5);
  check("torus", with_vertices(5000), 0.65, 1.5);
  check("torus", adaptive(0.3, 0.3), 0.55, 1.8);
}

TEST(Finish, DoesNotDependOnThreads) {
  std::vector<TriangleMesh> meshes;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    meshes.push_back(finished("gyroid-ball", 48, adaptive(0.35, 0.3)).mesh);
  }
  for (const TriangleMesh& mesh : meshes) {
    ASSERT_EQ(mesh.vertices.size(), meshes[0].vertices.size());
    EXPECT_EQ(mesh.triangles, meshes[0].triangles);
    EXPECT_EQ(
        std::memcmp(mesh.vertices.data(), meshes[0].vertices.data(), mesh.vertices.size() * sizeof(Eigen::Vector3d)),
        0);
  }
}

// A ball with a spherical cavity that comes close to the outer surface at the north pole. Triangles of the usual size
// would cut into the cavity there. This mesh has smaller triangles near the pole, but the finish makes all sizes even.
struct HollowBall {
  static constexpr double outer = 10.0;
  static constexpr double hollow = 8.0;
  Eigen::Vector3d centre{15.0, 15.0, 15.0};
  Eigen::Vector3d hollow_centre;
  Isosurface surface;
  TriangleMesh mesh;

  HollowBall(double gap, double crowded)
      : hollow_centre(centre + Eigen::Vector3d(0.0, 0.0, outer - hollow - gap)), surface(sampled(), 0.0) {
    mesh = sample_meshes::icosphere(2);
    for (Eigen::Vector3d& v : mesh.vertices) {
      const double angle = std::acos(std::clamp(v.z(), -1.0, 1.0));
      const double nearer = std::numbers::pi * std::pow(angle / std::numbers::pi, crowded);
      const double round = std::hypot(v.x(), v.y());
      const double scale = round > 1e-12 ? std::sin(nearer) / round : 0.0;
      v = centre + outer * Eigen::Vector3d(v.x() * scale, v.y() * scale, std::cos(nearer));
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const TriangleMesh inner = sample_meshes::icosphere(3);
    for (const Eigen::Vector3d& v : inner.vertices) mesh.vertices.emplace_back(hollow_centre + hollow * v);
    for (const auto& [a, b, c] : inner.triangles) mesh.triangles.push_back({first + a, first + c, first + b});
    for (Eigen::Vector3d& v : mesh.vertices) {
      if (const auto foot = surface.project(v)) v = *foot;
    }
  }

 private:
  FloatVolume sampled() const {
    constexpr int nodes = 61;
    FloatVolume volume;
    volume.lattice.size = {nodes, nodes, nodes};
    volume.lattice.spacing = {0.5, 0.5, 0.5};
    for (int k = 0; k < nodes; ++k) {
      for (int j = 0; j < nodes; ++j) {
        for (int i = 0; i < nodes; ++i) {
          const Eigen::Vector3d x = 0.5 * Eigen::Vector3d(i, j, k);
          volume.samples.push_back(
              static_cast<float>(std::min(outer - (x - centre).norm(), (x - hollow_centre).norm() - hollow)));
        }
      }
    }
    return volume;
  }
};

double rolled_back(const Monitor& monitor) {
  const auto found = monitor.counters().find("finish/intersections rolled back");
  return found == monitor.counters().end() ? 0.0 : found->second;
}

TEST(Finish, RollsBackWhereSheetsWouldIntersect) {
  const HollowBall ball(0.25, 1.3);
  ASSERT_EQ(count_self_intersections(ball.mesh), 0U);
  const SizingField sizing(3.0);
  Monitor monitor;
  // Shapes alone: the given sizes are not even, and even areas would cost shape.
  const TriangleMesh finished =
      finish(SizedSurface(ball.surface, sizing), ball.mesh, {.rounds = 3, .area_weight = 0.0}, monitor);
  EXPECT_GT(rolled_back(monitor), 0.0) << "no intersections: the mesh does not test the rollback";
  EXPECT_EQ(count_self_intersections(finished), 0U);
  const MeshFacts facts = mesh_facts(finished);
  EXPECT_EQ(facts.euler, 4);
  EXPECT_EQ(facts.open_edges, 0U);
  // The finish still improves the mesh away from the pole.
  const auto mean_q = [&](const TriangleMesh& mesh) {
    double sum = 0.0;
    int count = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      if (mesh.vertices[a].z() > ball.centre.z() || (mesh.vertices[a] - ball.centre).norm() < 9.5) continue;
      sum += radius_ratio(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
      ++count;
    }
    return sum / count;
  };
  EXPECT_GT(mean_q(finished), mean_q(ball.mesh) + 0.003);
}

TEST(Finish, KeepsIntersectionsOfTheGivenMesh) {
  const HollowBall ball(0.3, 1.2);
  const std::size_t given = count_self_intersections(ball.mesh);
  ASSERT_GT(given, 0U);
  const SizingField sizing(3.0);
  Monitor monitor;
  const TriangleMesh finished = finish(SizedSurface(ball.surface, sizing), ball.mesh, {}, monitor);
  EXPECT_LE(count_self_intersections(finished), given);
  EXPECT_NE(finished.vertices, ball.mesh.vertices)
      << "intersections in one place must not prevent the finish elsewhere";
}

class FinishLocalSearch : public testing::Test {
 protected:
  FinishLocalSearch() : surface_(sample_phantom(phantom("sphere"), 32), 0.0), sizing_(0.25), sized_(surface_, sizing_) {
    const Method& particles = method("particles");
    Monitor monitor;
    const TriangleMesh mesh =
        particles.mesh(MeshingTask(surface_, with_vertices(500), Parameters(particles.parameters), 1), monitor);
    std::vector<Eigen::Vector3d> normals;
    for (const auto& x : mesh.vertices) normals.push_back(outward_normal(surface_.value_gradient(x).gradient));
    mesh_ = EditableMesh(mesh.vertices, normals, mesh.triangles);
  }

  FinishContext context() const {
    return {surface_, sizing_, AskedAreas(sized_, mesh_.triangle_mesh()), finish_energies(sizing_)};
  }

  Isosurface surface_;
  SizingField sizing_;
  SizedSurface sized_;
  EditableMesh mesh_;
};

TEST_F(FinishLocalSearch, LeavesTheMeshWithoutAChange) {
  const TriangleMesh before = mesh_.triangle_mesh();
  const std::vector<EditableMesh::Index> centres{17};
  const Submesh submesh = extract_submesh(mesh_, centres, 3);
  EXPECT_GT(submesh.vertices.size(), 19U);
  EXPECT_EQ(submesh.core.size(), mesh_.valence(17) + 1U);
  put_back_submesh(mesh_, submesh);
  const MeshFacts facts = mesh_facts(mesh_.triangle_mesh());
  EXPECT_EQ(facts.euler, 2);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(mesh_.triangle_mesh().vertices, before.vertices);
  for (EditableMesh::Index v = 0; v < mesh_.vertex_count(); ++v) EXPECT_TRUE(mesh_.movable(v));
}

// Splitting an edge creates a vertex of valence 4, which the search must remove.
TEST_F(FinishLocalSearch, ImprovesABadSpot) {
  const FinishContext context = this->context();
  ASSERT_EQ(shortfall(context, mesh_, ShapeGoal{}), 0.0);
  ASSERT_NE(split_edge_at_middle(context, mesh_, 100), EditableMesh::none);
  ASSERT_GT(shortfall(context, mesh_, ShapeGoal{}), 1.0);
  SearchBudget budget{1e6};
  EXPECT_EQ(improve_bad_spots(context, mesh_, ShapeGoal{}, {4, 2, 3}, budget), 1U);
  EXPECT_LT(budget.moves, 1e6);
  EXPECT_EQ(shortfall(context, mesh_, ShapeGoal{}), 0.0);
  EXPECT_EQ(mesh_facts(mesh_.triangle_mesh()).euler, 2);
  EXPECT_EQ(mesh_facts(mesh_.triangle_mesh()).open_edges, 0U);
}

// Two vertices of valence 4, far apart; one has a sliver as well.
TEST_F(FinishLocalSearch, MendsTheWorstSpotsFirstIfTheBudgetIsSmall) {
  const FinishContext context = this->context();
  const auto valences = [this] {
    std::size_t bad = 0;
    for (EditableMesh::Index v = 0; v < mesh_.vertex_count(); ++v)
      bad += mesh_.alive(v) && valence_shortfall(mesh_, v) > 0.0 ? 1 : 0;
    return bad;
  };
  const Eigen::Vector3d centre = 0.5 * surface_.extent();
  EditableMesh::Index far = 100;
  for (EditableMesh::Index e = 0; e < mesh_.half_edge_count(); ++e) {
    const auto away = [&](EditableMesh::Index half) {
      return (mesh_.points[mesh_.origin(half)] - mesh_.points[mesh_.origin(100)]).norm();
    };
    if (away(e) > away(far)) far = e;
  }
  const EditableMesh::Index mild = split_edge_at_middle(context, mesh_, 100);
  const EditableMesh::Index bad = split_edge_at_middle(context, mesh_, far);
  ASSERT_NE(mild, EditableMesh::none);
  ASSERT_NE(bad, EditableMesh::none);
  const Eigen::Vector3d aside = mesh_.points[mesh_.target(mesh_.out(bad))];
  mesh_.points[bad] = centre + (0.2 * mesh_.points[bad] + 0.8 * aside - centre).normalized() * (aside - centre).norm();
  ASSERT_EQ(valences(), 2U);
  SearchBudget budget{1.0};
  EXPECT_EQ(improve_bad_spots(context, mesh_, ShapeGoal{}, {4, 2, 3}, budget), 1U);
  EXPECT_LT(budget.moves, 0.0);
  EXPECT_GT(valence_shortfall(mesh_, mild), 0.0);
  EXPECT_EQ(improve_bad_spots(context, mesh_, ShapeGoal{}, {4, 2, 3}, budget), 0U);
}

}  // namespace
}  // namespace isobench::particles
