// Fuzz targets for the readers of mesh files.
#include "isobench/foundation/testing/fuzz_target.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_notes.h"

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

/// Reads a file of one ending and writes it with another one.
bool read(std::string_view bytes, const std::string& ending, const std::string& written_as) {
  return accepts([&] {
    Monitor monitor;
    const TriangleMesh mesh = read_mesh(fuzz_file("mesh" + ending, bytes), monitor);
    check_mesh(mesh, bytes.size());
    std::vector<std::string> notes = notes_on(mesh);
    notes.push_back(loss_in_file(mesh, "a.stl"));
    notes.insert(notes.end(), monitor.notes().begin(), monitor.notes().end());
    for (const std::string& note : notes) require(note.size() < 500, "a note is a sentence");
    check_round_trip(mesh, "again" + written_as);
    return true;
  });
}

}  // namespace

bool fuzz_vtp(std::string_view bytes) { return read(bytes, ".vtp", ".vtp"); }
bool fuzz_vtu(std::string_view bytes) { return read(bytes, ".vtu", ".vtp"); }
bool fuzz_vtk(std::string_view bytes) { return read(bytes, ".vtk", ".ply"); }
bool fuzz_ply(std::string_view bytes) { return read(bytes, ".ply", ".ply"); }
bool fuzz_off(std::string_view bytes) { return read(bytes, ".off", ".off"); }
bool fuzz_obj(std::string_view bytes) { return read(bytes, ".obj", ".obj"); }
bool fuzz_stl(std::string_view bytes) { return read(bytes, ".stl", ".off"); }  // STL itself has single precision only

}  // namespace isobench
