#include <fmt/format.h>

#include <iterator>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

void next_or_truncated(TextLines& lines, const char* what) {
  if (!lines.next()) lines.fail(fmt::format("the file is truncated: it ends within its {}", what));
}

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

/// Goes to the line with the counts and returns its words from there on. The keyword may be left out.
std::vector<std::string_view> count_words(TextLines& lines, std::string_view text, const std::filesystem::path& path) {
  const bool any = lines.next();
  std::string_view keyword = any ? lines.words()[0] : "";
  if (to_integer(keyword) && lines.words().size() >= 2) return lines.words();
  // Texture coordinates (ST), colours (C) and normals (N) of a vertex follow its three coordinates.
  for (const char* of_vertices : {"ST", "C", "N"}) take_prefix(keyword, of_vertices);
  const bool other_dimension = take_prefix(keyword, "4") || take_prefix(keyword, "n");
  if (!take_prefix(keyword, "OFF") && !take_prefix(keyword, "off")) {
    not_of_format(path, text, "an OFF file", "it does not start with the word OFF");
  }
  if (other_dimension) bad_mesh(path, "its points do not have three coordinates, as those of a surface in space have");
  std::vector<std::string_view> words(lines.words().begin() + 1, lines.words().end());
  if (!words.empty() && words[0] == "BINARY") bad_mesh(path, "is a binary OFF file; save it as text, or as PLY");
  if (!keyword.empty()) words.insert(words.begin(), keyword);  // some programs forget the line's end: "OFF8 12 0"
  if (!words.empty()) return words;
  next_or_truncated(lines, "header");
  return lines.words();
}

long to_count(const TextLines& lines, const std::vector<std::string_view>& words, std::size_t n) {
  if (n >= words.size()) lines.fail("the number of vertices or faces is missing");
  const std::optional<long> count = to_integer(words[n]);
  if (!count) lines.fail(fmt::format("'{}' is not a number of vertices or faces", words[n]));
  if (*count < 0) lines.fail("counts cannot be negative");
  return *count;
}

/// Returns false if the face of the current line has no area: a point, a line or nothing.
bool add_face(const TextLines& lines, PolygonMesh& mesh) {
  const long corners = lines.integer(0);
  if (corners < 0) lines.fail("a face cannot have a negative number of corners");
  const std::size_t before = mesh.corners.size();
  for (long c = 0; c < corners; ++c) {
    const long corner = lines.integer(static_cast<std::size_t>(c) + 1);
    if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.vertices.size()) {
      lines.fail(fmt::format("the face names vertex {}, but the vertices are 0 to {}", corner,
                             static_cast<long>(mesh.vertices.size()) - 1));
    }
    mesh.corners.push_back(static_cast<std::uint32_t>(corner));
  }
  if (corners < 3) {
    mesh.corners.resize(before);
    return false;
  }
  mesh.end_polygon();
  return true;
}

}  // namespace

PolygonMesh read_off(const std::filesystem::path& path) {
  const std::string text = read_bytes(path);
  TextLines lines(text, path);
  const std::vector<std::string_view> counts = count_words(lines, text, path);
  const long vertices = to_count(lines, counts, 0);
  const long faces = to_count(lines, counts, 1);

  PolygonMesh mesh;
  for (long v = 0; v < vertices; ++v) {
    next_or_truncated(lines, "vertices");
    mesh.vertices.push_back(lines.position(0));
  }
  std::size_t points = 0, edges = 0;
  for (long f = 0; f < faces; ++f) {
    next_or_truncated(lines, "faces");
    if (!add_face(lines, mesh)) ++(lines.integer(0) == 1 ? points : edges);
  }
  mesh.note_left_out(points, edges);
  return mesh;
}

void write_off(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string text = fmt::format("OFF\n{}{} {} 0\n", mesh.space.empty() ? "" : "# " + space_mark(mesh) + "\n",
                                 mesh.vertices.size(), mesh.triangles.size());
  const auto out = std::back_inserter(text);
  // "{}" prints the fewest digits from which the same double is read back.
  for (const Eigen::Vector3d& v : mesh.vertices) fmt::format_to(out, "{} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  write_text(path, text);
}

}  // namespace isobench
