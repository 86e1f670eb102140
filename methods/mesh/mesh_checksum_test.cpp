#include "isobench/methods/mesh/mesh_checksum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {
namespace {

TriangleMesh odd_tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0.1, 0.0, 0.0}, {1.0 / 3.0, 0.0, 0.0}, {0.0, std::sqrt(2.0), 0.0}, {0.0, 0.0, 1e-9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

TEST(MeshChecksum, IsOfCoordinatesAndCornersToTheLastBit) {
  std::set<std::string> seen = {checksum(odd_tetrahedron())};
  TriangleMesh mesh = odd_tetrahedron();
  mesh.vertices[1].x() = std::nextafter(mesh.vertices[1].x(), 1.0);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = odd_tetrahedron();
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = odd_tetrahedron();
  mesh.triangles[2] = {2, 3, 1};
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = odd_tetrahedron();
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  EXPECT_TRUE(seen.insert(checksum(mesh)).second);
  mesh = odd_tetrahedron();
  mesh.vertex_data["h0"] = {1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(checksum(mesh), checksum(odd_tetrahedron()));
}

TEST(MeshChecksum, SurvivesVtp) {
  const TestFolder folder;
  const std::filesystem::path path = folder.path() / "checksum.vtp";
  write_mesh(odd_tetrahedron(), path);
  EXPECT_EQ(checksum(read_mesh(path)), checksum(odd_tetrahedron()));
}

}  // namespace
}  // namespace isobench
