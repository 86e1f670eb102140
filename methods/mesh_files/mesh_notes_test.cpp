#include "isobench/methods/mesh_files/mesh_notes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {
namespace {

TriangleMesh octahedron_at(double x) {
  TriangleMesh mesh;
  mesh.vertices = {{x + 1, 0, 0}, {x - 1, 0, 0}, {x, 1, 0}, {x, -1, 0}, {x, 0, 1}, {x, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// The notes, one a line.
std::string notes(const TriangleMesh& mesh) {
  std::string text;
  for (const std::string& note : notes_on(mesh)) text += note + '\n';
  return text;
}

TEST(MeshNotes, AnInsideOutMeshIsNoticed) {
  EXPECT_EQ(notes(octahedron_at(0)), "");
  EXPECT_EQ(notes(turned(octahedron_at(0))),
            "the mesh is inside out: it is closed, and its triangles are clockwise seen from outside (volume -1.33333 "
            "mm³); turn its triangles\n");
  EXPECT_NE(notes(turned(octahedron_at(1e6))), "") << "far from the origin, the volume keeps its sign";
  TriangleMesh open = turned(octahedron_at(0));
  open.triangles.pop_back();
  EXPECT_EQ(notes(open), "") << "an open mesh has no inside";
  TriangleMesh half = octahedron_at(0);
  for (std::size_t t = 0; t < 5; ++t) std::swap(half.triangles[t][1], half.triangles[t][2]);
  EXPECT_EQ(notes(half), "") << "its volume has no meaning";
  TriangleMesh cavity = octahedron_at(0);
  for (Eigen::Vector3d& x : cavity.vertices) x *= 0.5;
  EXPECT_EQ(notes(sample_meshes::together(octahedron_at(0), turned(cavity))), "") << "a wall of a cavity faces inwards";
}

TEST(MeshNotes, TrianglesThatShareNothingAreNoticed) {
  TriangleMesh soup;
  const TriangleMesh whole = octahedron_at(0);
  for (const Triangle& t : whole.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) soup.vertices.push_back(whole.vertices[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_NE(notes(soup).find("no two of its 8 triangles share an edge: its 24 vertices are at 6 different places"),
            std::string::npos)
      << notes(soup);
}

TEST(MeshNotes, TrianglesAndVerticesWithoutAreaAreCounted) {
  TriangleMesh mesh = octahedron_at(0);
  mesh.triangles.push_back({5, 5, 1});
  mesh.triangles.push_back({2, 2, 2});
  mesh.vertices.emplace_back(900, 900, 900);
  EXPECT_EQ(notes(mesh),
            "2 of its triangles name a vertex twice and have no area\n1 of its vertices have no triangle\n");
  EXPECT_EQ(notes(TriangleMesh{}), "");
}

TEST(LossInFile, CountsTheVerticesThatAnStlFileGivesBack) {
  const TestFolder folder;
  const auto path = folder.path() / "mesh.STL";
  TriangleMesh mesh = sample_meshes::torus(40);
  EXPECT_EQ(loss_in_file(mesh, path), "");
  for (Eigen::Vector3d& x : mesh.vertices) x += Eigen::Vector3d(2e7, 1e7, 1e7);
  write_mesh(mesh, path);
  const std::size_t back = read_mesh(path).vertices.size();
  EXPECT_LT(back, mesh.vertices.size());
  const std::string loss = loss_in_file(mesh, path);
  EXPECT_TRUE(loss.starts_with(fmt::format("{}: STL holds single precision, in which {} of the {} vertices survive",
                                           path.string(), back, mesh.vertices.size())))
      << loss;
  EXPECT_NE(loss.find(".ply, .vtp or .off"), std::string::npos) << loss;
  for (const char* name : {"a.ply", "a.vtp", "a.off", "a.obj"}) EXPECT_EQ(loss_in_file(mesh, folder.path() / name), "");
}

TEST(LossInFile, SaysThatVerticesMove) {
  // Single precision has steps of 1/16 mm at 1e6: vertices move by up to 0.03 mm, 2 % of an edge, and none merge.
  const TriangleMesh mesh = octahedron_at(1e6 + 0.03);
  const std::string loss = loss_in_file(mesh, "a.stl");
  EXPECT_NE(loss.find("moves vertices by up to 0.02"), std::string::npos) << loss;
  EXPECT_NE(loss.find("all 6 vertices survive"), std::string::npos) << loss;
  EXPECT_EQ(loss_in_file(octahedron_at(1e4 + 0.03), "a.stl"), "");
  EXPECT_NE(loss_in_file(octahedron_at(1e30), "a.stl"), "") << "in one place also in double precision";
  const TriangleMesh twice = sample_meshes::together(octahedron_at(0), octahedron_at(0));
  EXPECT_NE(loss_in_file(twice, "a.stl").find("vertices at the same place become one, and 6 of the 12 survive"),
            std::string::npos);
}

}  // namespace
}  // namespace isobench
