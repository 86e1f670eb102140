#include "isobench/methods/mesh_files/mesh_files.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"
#include "isobench/methods/mesh_files/mesh_formats.h"

namespace isobench {

namespace {

struct MeshFormat {
  const char* ending;
  TriangleMesh (*read)(const std::filesystem::path&);
  void (*write)(const TriangleMesh&, const std::filesystem::path&);
};

constexpr MeshFormat kFormats[] = {{".vtp", read_vtp, write_vtp},
                                   {".ply", read_ply, write_ply},
                                   {".off", read_off, write_off},
                                   {".obj", read_obj, write_obj},
                                   {".stl", read_stl, write_stl}};

const MeshFormat& format_of(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  for (const MeshFormat& format : kFormats) {
    if (ending == format.ending) return format;
  }
  throw UsageError(path.string() + ": mesh files end in .vtp, .ply, .off, .obj or .stl");
}

void check(const TriangleMesh& mesh, const std::filesystem::path& path) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) bad_mesh(path, fmt::format("the coordinates of vertex {} are not finite", v));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.vertices.size()) continue;
      bad_mesh(path,
               fmt::format("triangle {} names a vertex that is not there (the file has {})", t, mesh.vertices.size()));
    }
  }
  if (mesh.triangles.empty()) bad_mesh(path, "has no triangles");
}

}  // namespace

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path) { format_of(path).write(mesh, path); }

TriangleMesh read_mesh(const std::filesystem::path& path) {
  TriangleMesh mesh = format_of(path).read(path);
  check(mesh, path);
  return mesh;
}

std::string read_bytes(const std::filesystem::path& path) {
  // A directory can be opened; only reading from it fails.
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) bad_mesh(path, "cannot be read; does this file exist?");
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) bad_mesh(path, "reading failed before the end of the file");
  if (bytes.empty()) bad_mesh(path, "the file is empty");
  return bytes;
}

void bad_mesh(const std::filesystem::path& path, const std::string& message) {
  throw DataError(path.string() + ": " + message);
}

}  // namespace isobench
