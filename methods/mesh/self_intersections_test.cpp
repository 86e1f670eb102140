#include "isobench/methods/mesh/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "isobench/methods/mesh/box_tree.h"
#include "isobench/methods/mesh/sample_meshes.h"

namespace isobench {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

/// The number of pairs by CGAL's own function, which needs a manifold mesh.
std::size_t count_by_cgal(const TriangleMesh& mesh) {
  SurfaceMesh cgal;
  for (const Eigen::Vector3d& v : mesh.vertices) cgal.add_vertex(Point(v.x(), v.y(), v.z()));
  const auto vertex = [](std::uint32_t v) { return SurfaceMesh::Vertex_index(v); };
  for (const Triangle& t : mesh.triangles) {
    EXPECT_NE(cgal.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])), SurfaceMesh::null_face());
  }
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(cgal, std::back_inserter(pairs));
  return pairs.size();
}

TriangleMesh shaken(TriangleMesh mesh, double amount) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Eigen::Vector3d& v : mesh.vertices) v += Eigen::Vector3d(shift(random), shift(random), shift(random));
  return mesh;
}

TEST(SelfIntersections, CleanMeshesHaveNone) {
  EXPECT_EQ(count_self_intersections(sample_meshes::tetrahedron()), 0U);
  EXPECT_EQ(count_self_intersections(sample_meshes::box({0, 0, 0}, {1, 2, 3})), 0U);
  EXPECT_EQ(count_self_intersections(sample_meshes::torus(40)), 0U);
  EXPECT_EQ(count_self_intersections(sample_meshes::moebius_strip(40)), 0U);
  EXPECT_EQ(count_self_intersections({}), 0U);
}

TEST(SelfIntersections, TwoCrossingTrianglesAreOnePair) {
  EXPECT_EQ(count_self_intersections(sample_meshes::mesh(
                {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 1}}, {{0, 1, 2}, {3, 4, 5}})),
            1U);
}

TEST(SelfIntersections, TouchingInOnePointCounts) {
  EXPECT_EQ(count_self_intersections(sample_meshes::mesh(
                {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {3, 3, 1}}, {{0, 1, 2}, {3, 4, 5}})),
            1U);
}

TEST(SelfIntersections, CommonVertex) {
  // The second triangle's opposite edge pierces the first triangle or misses it.
  const auto pair = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return count_self_intersections(
        sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, p, q}, {{0, 1, 2}, {0, 3, 4}}));
  };
  EXPECT_EQ(pair({0.5, 0.5, -1}, {0.5, 0.5, 1}), 1U);
  EXPECT_EQ(pair({3, 3, -1}, {3, 3, 1}), 1U) << "the first's opposite edge pierces the second";
  EXPECT_EQ(pair({-1, -1, 0}, {-1, -1, 1}), 0U);
  EXPECT_EQ(pair({-1, 0, 0}, {0, -1, 0}), 0U) << "in one plane, apart";
  EXPECT_EQ(pair({1, 0.2, 0}, {0.2, 1, 0}), 1U) << "in one plane, one within the other";
}

TEST(SelfIntersections, CommonEdge) {
  const auto pair = [](const Eigen::Vector3d& apex) {
    return count_self_intersections(
        sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, apex}, {{0, 1, 2}, {1, 0, 3}}));
  };
  EXPECT_EQ(pair({1, -1, 0}), 0U) << "flat";
  EXPECT_EQ(pair({1, 1, 0}), 1U) << "folded onto itself";
  EXPECT_EQ(pair({1, 1, 1e-12}), 0U) << "folded, but not quite";
}

TEST(SelfIntersections, SameTriangleTwiceIsOnePair) {
  const TriangleMesh twice = sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}, {1, 0, 2}});
  EXPECT_EQ(count_self_intersections(twice), 1U);
}

TEST(SelfIntersections, CoplanarOverlapsOfSeparateTriangles) {
  const TriangleMesh square = sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}});
  TriangleMesh moved = square;
  for (Eigen::Vector3d& v : moved.vertices) v += Eigen::Vector3d(0.5, 0.5, 0.0);
  EXPECT_EQ(count_self_intersections(sample_meshes::together(square, moved)), 1U);
  for (Eigen::Vector3d& v : moved.vertices) v += Eigen::Vector3d(5.0, 0.0, 0.0);
  EXPECT_EQ(count_self_intersections(sample_meshes::together(square, moved)), 0U);
}

TEST(SelfIntersections, TrianglesWithoutAreaAreLeftOut) {
  EXPECT_EQ(count_self_intersections(
                sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.5, 0.5, 2}},
                                    {{0, 1, 2}, {3, 4, 5}, {0, 0, 1}})),
            0U);
}

TEST(SelfIntersections, AgreesWithCgalOnManifoldMeshes) {
  using sample_meshes::box;
  using sample_meshes::together;
  const TriangleMesh boxes = together(box({0, 0, 0}, {2, 2, 2}), box({1.1, 0.9, 0.8}, {3, 3.2, 3.1}));
  EXPECT_GT(count_self_intersections(boxes), 0U);
  EXPECT_EQ(count_self_intersections(boxes), count_by_cgal(boxes));
  for (const double amount : {0.02, 0.1, 0.5}) {
    const TriangleMesh mesh = shaken(sample_meshes::torus(40), amount);
    EXPECT_EQ(count_self_intersections(mesh), count_by_cgal(mesh)) << "shaken by " << amount;
  }
  EXPECT_GT(count_self_intersections(shaken(sample_meshes::torus(40), 0.5)), 100U);
}

TEST(SelfIntersections, OfMarkedTrianglesAreThoseOfAllThatHaveOne) {
  const TriangleMesh mesh = shaken(sample_meshes::torus(40), 0.2);
  const std::vector<std::array<std::uint32_t, 2>> all = self_intersections(mesh);
  ASSERT_GT(all.size(), 20U);
  std::vector<std::uint8_t> marked(mesh.triangles.size(), 0);
  EXPECT_TRUE(self_intersections(mesh, marked).empty());
  for (std::size_t t = 0; t < marked.size(); t += 7) marked[t] = 1;
  std::vector<std::array<std::uint32_t, 2>> expected = all;
  std::erase_if(expected, [&](const auto& pair) { return marked[pair[0]] == 0 && marked[pair[1]] == 0; });
  EXPECT_LT(expected.size(), all.size());
  EXPECT_EQ(self_intersections(mesh, marked), expected);
  std::fill(marked.begin(), marked.end(), 1);
  EXPECT_EQ(self_intersections(mesh, marked), all);
}

TEST(SelfIntersections, AreTheSamePairsForAnyNumberOfThreads) {
  const TriangleMesh mesh = shaken(sample_meshes::torus(60), 0.2);
  const auto pairs = self_intersections(mesh);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  for (const auto& [a, b] : pairs) EXPECT_LT(a, b);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(self_intersections(mesh), pairs) << threads << " threads";
  }
}

// Compared with a test of all pairs, on boxes of very different sizes; some are points, some only touch.
TEST(BoxTree, FindsEachOverlapOnce) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(0, 40);
  std::uniform_int_distribution<int> length(0, 5);
  for (const std::size_t count : {0, 1, 2, 5, 64, 65, 700}) {
    std::vector<BoxTree::Box> boxes;
    for (std::size_t n = 0; n < count; ++n) {
      const Eigen::Vector3d low(place(random), place(random), place(random));
      const int scale = n % 50 == 7 ? 6 : 1;
      boxes.emplace_back(low, low + scale * Eigen::Vector3d(length(random), length(random), length(random)));
    }
    std::vector<std::array<std::uint32_t, 2>> expected;
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        if (boxes[a].intersects(boxes[b])) expected.push_back({a, b});
      }
    }
    std::vector<std::array<std::uint32_t, 2>> found;
    const BoxTree tree(boxes);
    ASSERT_EQ(tree.size(), count);
    for (std::size_t n = 0; n < count; ++n) {
      tree.overlapping_later(n, [&](std::uint32_t a, std::uint32_t b) {
        found.push_back({std::min(a, b), std::max(a, b)});
      });
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << count << " boxes";
    if (count == 700) {
      EXPECT_GT(found.size(), 100U);
    }
  }
}

}  // namespace

}  // namespace isobench
