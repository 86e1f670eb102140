#include "isobench/methods/mesh_files/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

struct MeshFormat {
  std::string ending;
  PolygonMesh (*read)(const fs::path&);
  void (*write)(const TriangleMesh&, const fs::path&);  ///< nullptr if it is only read
};

const std::vector<MeshFormat>& mesh_formats() {
  static const std::vector<MeshFormat> formats = {{".vtp", read_vtp, write_vtp}, {".ply", read_ply, write_ply},
                                                  {".off", read_off, write_off}, {".obj", read_obj, write_obj},
                                                  {".stl", read_stl, write_stl}, {".vtk", read_vtk, nullptr},
                                                  {".vtu", read_vtp, nullptr}};
  return formats;
}

enum class Access { read, write };

/// "a, b or c"
std::string endings(Access access) {
  std::vector<std::string> known;
  for (const MeshFormat& format : mesh_formats()) {
    if (access == Access::read || format.write != nullptr) known.push_back(format.ending);
  }
  const std::string last = known.back();
  known.pop_back();
  return fmt::format("{} or {}", fmt::join(known, ", "), last);
}

const MeshFormat& format_of(const fs::path& path, Access access) {
  const std::string ending = lower_case(path.extension().string());
  for (const MeshFormat& format : mesh_formats()) {
    if (ending == format.ending && (access == Access::read || format.write != nullptr)) return format;
  }
  if (access == Access::write)
    throw UsageError(fmt::format("{}: unknown ending '{}'; meshes are written to files that end in {}", path.string(),
                                 path.extension().string(), endings(access)));
  if (ending == ".gz" || ending == ".zip" || ending == ".bz2" || ending == ".xz")
    throw UsageError(path.string() + ": compressed mesh files cannot be read; unpack it first");
  throw UsageError(fmt::format("{}: unknown ending '{}'; mesh files that can be read end in {}", path.string(),
                               path.extension().string(), endings(access)));
}

void check(const PolygonMesh& mesh, const fs::path& path) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) bad_mesh(path, fmt::format("the coordinates of vertex {} are not finite", v));
  }
  if (mesh.vertices.size() >= std::numeric_limits<std::uint32_t>::max()) bad_mesh(path, "has more than 2^32 vertices");
  for (std::size_t n = 0; n < mesh.size(); ++n) {
    for (const std::uint32_t v : mesh.polygon(n)) {
      if (v < mesh.vertices.size()) continue;
      bad_mesh(path, fmt::format("face {} names a vertex that is not there (the file has {}, and faces count from 0)",
                                 n, mesh.vertices.size()));
    }
    if (mesh.polygon(n).size() > most_corners) {
      bad_mesh(path, fmt::format("face {} has {} corners, more than {}; cut it into triangles first", n,
                                 mesh.polygon(n).size(), most_corners));
    }
  }
}

TriangleMesh read_mesh_and_notes(const fs::path& path, std::vector<std::string>& notes) {
  PolygonMesh polygons = format_of(path, Access::read).read(path);
  check(polygons, path);
  TriangleMesh mesh = to_triangles(std::move(polygons), notes);
  if (!mesh.triangles.empty()) return mesh;
  bad_mesh(path, mesh.vertices.empty() ? "has no points and no triangles"
                                       : fmt::format("has {} points and no triangles; make a surface of them first",
                                                     mesh.vertices.size()));
}

/// What the first bytes show a file to be; "" if they do not.
std::string first_bytes_say(std::string_view bytes) {
  if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
  const std::string head = lower_case(std::string(bytes.substr(0, 512)));
  if (head.starts_with("ply\n") || head.starts_with("ply\r")) return "a PLY file, whose name ends in .ply";
  if (head.starts_with("# vtk datafile")) return "a legacy VTK file, whose name ends in .vtk";
  if (head.find("<vtkfile") != std::string::npos) return "a VTK XML file, such as one whose name ends in .vtp or .vtu";
  if (head.starts_with("solid ") && head.find("facet") != std::string::npos)
    return "an STL file, whose name ends in .stl";
  if (head.starts_with("off\n") || head.starts_with("off\r")) return "an OFF file, whose name ends in .off";
  if (head.starts_with("$meshformat")) return "a Gmsh file; export it as PLY, STL or VTK";
  if (head.starts_with("\x1f\x8b") || head.starts_with("pk\x03\x04")) return "a compressed file; unpack it first";
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff")) return "text in UTF-16; save it as UTF-8";
  if (head.starts_with("version https://git-lfs"))
    return "a pointer of Git LFS, not the file; fetch it with git lfs pull";
  if (head.starts_with("<!doctype html") || head.starts_with("<html"))
    return "a web page, not a mesh; download it again";
  return "";
}

}  // namespace

void check_mesh_path(const fs::path& path) {
  if (fs::is_directory(path) || !path.has_filename()) {
    throw UsageError(
        fmt::format("{}: is a folder; name a file in it, such as {}", path.string(), (path / "mesh.vtp").string()));
  }
  format_of(path, Access::write);
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {
    throw UsageError(path.string() + ": the folder " + folder.string() + " does not exist; make it first");
  }
}

void write_mesh(const TriangleMesh& mesh, const fs::path& path) { format_of(path, Access::write).write(mesh, path); }

TriangleMesh read_mesh(const fs::path& path) {
  std::vector<std::string> notes;
  return read_mesh_and_notes(path, notes);
}

TriangleMesh read_mesh(const fs::path& path, Monitor& monitor) {
  std::vector<std::string> notes;
  TriangleMesh mesh = read_mesh_and_notes(path, notes);
  for (const std::string& note : notes) monitor.note(fmt::format("{}: {}", path.filename().string(), note));
  return mesh;
}

std::string read_bytes(const fs::path& path) {
  // A directory can be opened; only reading from it fails.
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) bad_mesh(path, "cannot be read; does this file exist?");
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) bad_mesh(path, "reading failed before the end of the file");
  if (bytes.empty()) bad_mesh(path, "the file is empty");
  return bytes;
}

void bad_mesh(const fs::path& path, const std::string& message) { throw DataError(path.string() + ": " + message); }

void not_of_format(const fs::path& path, std::string_view bytes, const std::string& format, const std::string& why) {
  const std::string other = first_bytes_say(bytes);
  bad_mesh(path, fmt::format("is not {}: {}", format, other.empty() ? why : "its first bytes are those of " + other));
}

}  // namespace isobench
