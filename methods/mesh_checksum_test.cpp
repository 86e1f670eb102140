#include "methods/mesh_checksum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "datasets/test_folder.h"
#include "methods/mesh_files.h"

namespace isobench {
namespace {

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0.1, 0.0, 0.0}, {1.0 / 3.0, 0.0, 0.0}, {0.0, std::sqrt(2.0), 0.0}, {0.0, 0.0, 1e-9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

TEST(MeshChecksum, IsOfCoordinatesAndCornersToTheLastBit) {
  std::set<std::string> seen = {checksum(tetrahedron())};
  TriangleMesh mesh = tetrahedron();
  mesh.vertices[1].x() = std::nextafter(mesh.vertices[1].x(), 1.0);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = tetrahedron();
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = tetrahedron();
  mesh.triangles[2] = {2, 3, 1};
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = tetrahedron();
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = tetrahedron();
  mesh.vertex_data["h0"] = {1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(checksum(mesh), checksum(tetrahedron()));
}

TEST(MeshChecksum, SurvivesVtp) {
  const TestFolder folder;
  const std::filesystem::path path = folder.path() / "checksum.vtp";
  write_mesh(tetrahedron(), path);
  EXPECT_EQ(checksum(read_mesh(path)), checksum(tetrahedron()));
}

}  // namespace
}  // namespace isobench
