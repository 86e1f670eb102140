#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

std::uint32_t checked_index(const TextLines& lines, long index, std::size_t vertices) {
  if (index < 0 || static_cast<std::size_t>(index) >= vertices) {
    lines.fail(fmt::format("the face names a vertex that is not there ({} so far)", vertices));
  }
  return static_cast<std::uint32_t>(index);
}

void next_or_truncated(TextLines& lines, const char* what) {
  if (!lines.next()) lines.fail(fmt::format("the file is truncated: it ends within its {}", what));
}

/// The vertex of an OBJ face's corner, "v", "v/t", "v//n" or "v/t/n". Positive numbers count from 1, negative numbers
/// back from the latest vertex.
std::uint32_t obj_corner(const TextLines& lines, std::string_view word, std::size_t vertices) {
  const std::optional<long> index = to_integer(word.substr(0, word.find('/')));
  if (!index) lines.fail(fmt::format("'{}' is not a corner of a face", word));
  return checked_index(lines, *index < 0 ? *index + static_cast<long>(vertices) : *index - 1, vertices);
}

bool ignored_in_obj(std::string_view keyword) {
  static constexpr std::array<std::string_view, 13> kIgnored{"vn", "vt", "vp",     "g",      "o",   "s",     "l",
                                                             "p",  "mg", "usemtl", "mtllib", "lod", "usemap"};
  return std::find(kIgnored.begin(), kIgnored.end(), keyword) != kIgnored.end();
}

}  // namespace

TriangleMesh read_off(const std::filesystem::path& path) {
  const std::string text = read_bytes(path);
  TextLines lines(text, path);
  const bool any = lines.next();
  const std::string_view keyword = any ? lines.words()[0] : "";
  // Vertices with colours (C) or normals (N) also start with their three coordinates.
  if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF") {
    bad_mesh(path, "is not an OFF file: it does not start with the word OFF");
  }
  std::size_t first = 1;  // the counts may follow on the same line
  if (lines.words().size() == 1) {
    next_or_truncated(lines, "header");
    first = 0;
  }
  const long vertices = lines.integer(first);
  const long triangles = lines.integer(first + 1);
  if (vertices < 0 || triangles < 0) lines.fail("counts cannot be negative");

  TriangleMesh mesh;
  for (long v = 0; v < vertices; ++v) {
    next_or_truncated(lines, "vertices");
    mesh.vertices.emplace_back(lines.number(0), lines.number(1), lines.number(2));
  }
  for (long t = 0; t < triangles; ++t) {
    next_or_truncated(lines, "faces");
    if (lines.integer(0) != 3) lines.fail("only triangles can be read");
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      triangle[c] = checked_index(lines, lines.integer(c + 1), mesh.vertices.size());
    }
  }
  return mesh;
}

TriangleMesh read_obj(const std::filesystem::path& path) {
  const std::string text = read_bytes(path);
  TextLines lines(text, path);
  TriangleMesh mesh;
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    if (words[0] == "v") {
      mesh.vertices.emplace_back(lines.number(1), lines.number(2), lines.number(3));
    } else if (words[0] == "f") {
      if (words.size() != 4) lines.fail("only triangles can be read");
      Triangle& triangle = mesh.triangles.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) triangle[c] = obj_corner(lines, words[c + 1], mesh.vertices.size());
    } else if (!ignored_in_obj(words[0])) {
      lines.fail(fmt::format("'{}' is unknown in an OBJ file of triangles", words[0]));
    }
  }
  return mesh;
}

void write_off(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
  const auto out = std::back_inserter(text);
  // "{}" prints the fewest digits from which the same double is read back.
  for (const Eigen::Vector3d& v : mesh.vertices) fmt::format_to(out, "{} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  write_text(path, text);
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& v : mesh.vertices) fmt::format_to(out, "v {} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) {
    fmt::format_to(out, "f {} {} {}\n", std::uint64_t{t[0]} + 1, std::uint64_t{t[1]} + 1, std::uint64_t{t[2]} + 1);
  }
  write_text(path, text);
}

}  // namespace isobench
