#include "isobench/methods/mesh/mesh_checksum.h"

#include "isobench/foundation/sha256.h"

namespace isobench {

std::string checksum(const TriangleMesh& mesh) {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::uint32_t),
                "hashed as arrays of numbers");
  Sha256 hash;
  const std::array<std::uint64_t, 2> counts = {mesh.vertices.size(), mesh.triangles.size()};
  hash.add(counts.data(), sizeof counts);
  hash.add(mesh.vertices.data(), mesh.vertices.size() * sizeof(Eigen::Vector3d));
  hash.add(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  return hash.hex();
}

}  // namespace isobench
