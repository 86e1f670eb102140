// Fuzz targets for the readers of mesh files.
#include "isobench/foundation/testing/fuzz_target.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {

namespace {

void check_mesh(const TriangleMesh& mesh, std::size_t file_bytes) {
  require(!mesh.triangles.empty(), "a mesh has triangles");
  // zlib, in VTP, makes data at most 1032 times smaller; without it, a vertex or triangle takes at least a few bytes.
  require(mesh.triangles.size() + mesh.vertices.size() <= 1032 * file_bytes, "a mesh is no larger than its file");
  for (const Eigen::Vector3d& vertex : mesh.vertices) require(vertex.allFinite(), "coordinates are finite");
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) require(v < mesh.vertices.size(), "corners are vertices that exist");
  }
  for (const auto& [name, values] : mesh.vertex_data) {
    require(values.size() == mesh.vertices.size(), "vertex data have one value per vertex");
  }
  for (const auto& [name, values] : mesh.triangle_data) {
    require(values.size() == mesh.triangles.size(), "triangle data have one value per triangle");
  }
}

/// A mesh that was read can be written, and reading it again gives the same mesh.
void check_round_trip(const TriangleMesh& mesh, const std::string& name) {
  const std::filesystem::path path = fuzz_file(name, "");
  write_mesh(mesh, path);
  const TriangleMesh again = read_mesh(path);
  require(again.vertices == mesh.vertices && again.triangles == mesh.triangles, "writing and reading keep the mesh");
}

bool read(std::string_view bytes, const std::string& ending) {
  return accepts([&] {
    const TriangleMesh mesh = read_mesh(fuzz_file("mesh" + ending, bytes));
    check_mesh(mesh, bytes.size());
    if (ending != ".stl") check_round_trip(mesh, "again" + ending);  // STL has single precision only
    return true;
  });
}

}  // namespace

bool fuzz_vtp(std::string_view bytes) { return read(bytes, ".vtp"); }
bool fuzz_ply(std::string_view bytes) { return read(bytes, ".ply"); }
bool fuzz_off(std::string_view bytes) { return read(bytes, ".off"); }
bool fuzz_obj(std::string_view bytes) { return read(bytes, ".obj"); }
bool fuzz_stl(std::string_view bytes) { return read(bytes, ".stl"); }

}  // namespace isobench
