#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

/// The vertex of a face's corner, "v", "v/t", "v//n" or "v/t/n". Positive numbers count from 1, negative numbers back
/// from the latest vertex. Positive ones may name a later vertex; read_mesh() reports those that never come.
std::uint32_t corner_of_face(const TextLines& lines, std::string_view word, std::size_t vertices) {
  const std::optional<long> index = to_integer(word.substr(0, word.find('/')));
  if (!index) lines.fail(fmt::format("'{}' is not a corner of a face", word));
  if (*index == 0 || (*index < 0 && static_cast<std::size_t>(-(*index + 1)) >= vertices)) {
    lines.fail(
        fmt::format("the face names a vertex that is not there ('{}', with {} vertices so far)", word, vertices));
  }
  return to_index(static_cast<double>(*index < 0 ? *index + static_cast<long>(vertices) : *index - 1));
}

template <std::size_t count>
bool is_among(const std::array<std::string_view, count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Statements of names, groups, materials and shading, and data of vertices: nothing of the surface's shape.
bool is_no_shape(std::string_view keyword) {
  static constexpr std::array<std::string_view, 23> words{
      "vn",        "vt",  "vp",     "g",      "o",      "s",        "mg",       "usemtl",
      "mtllib",    "lod", "usemap", "maplib", "bevel",  "c_interp", "d_interp", "shadow_obj",
      "trace_obj", "end", "call",   "csh",    "cstype", "deg",      "group"};
  return is_among(words, keyword);
}

/// Statements of curves and surfaces by control points.
bool is_free_form(std::string_view keyword) {
  static constexpr std::array<std::string_view, 11> words{"curv", "curv2", "surf", "bmat", "step", "parm",
                                                          "trim", "hole",  "scrv", "sp",   "con"};
  return is_among(words, keyword);
}

/// What a file has besides its faces.
struct OtherStatements {
  std::size_t points = 0;
  std::size_t lines = 0;
  std::size_t free_form = 0;
  std::size_t unknown = 0;
  std::string example;  ///< the first unknown word

  void add(std::string_view keyword) {
    if (keyword == "p") {
      ++points;
    } else if (keyword == "l") {
      ++lines;
    } else if (is_free_form(keyword)) {
      ++free_form;
    } else if (!is_no_shape(keyword)) {
      if (unknown++ == 0) example = keyword.substr(0, 40);
    }
  }
  void note(PolygonMesh& mesh) const {
    mesh.note_left_out(points, lines);
    if (free_form > 0) {
      mesh.notes.push_back(
          fmt::format("{} of its statements are of free-form curves and surfaces; left out", free_form));
    }
    if (unknown > 0) {
      mesh.notes.push_back(
          fmt::format("{} of its lines begin with a word that OBJ does not have ('{}'); left out", unknown, example));
    }
  }
};

}  // namespace

PolygonMesh read_obj(const std::filesystem::path& path) {
  const std::string text = read_bytes(path);
  TextLines lines(text, path, Continued::after_backslash);
  PolygonMesh mesh;
  OtherStatements others;
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    if (words[0] == "v") {
      mesh.vertices.push_back(lines.position(1));  // a weight or a colour may follow
    } else if (words[0] == "f" || words[0] == "fo") {
      if (words.size() < 4) lines.fail("a face needs three corners");
      for (std::size_t c = 1; c < words.size(); ++c) {
        mesh.corners.push_back(corner_of_face(lines, words[c], mesh.vertices.size()));
      }
      mesh.end_polygon();
    } else {
      others.add(words[0]);
    }
  }
  if (mesh.vertices.empty() && mesh.ends.empty()) {
    not_of_format(path, text, "an OBJ file of a mesh", "it has no line that begins with v or f");
  }
  others.note(mesh);
  return mesh;
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string text = mesh.space.empty() ? "" : "# " + space_mark(mesh) + "\n";
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& v : mesh.vertices) fmt::format_to(out, "v {} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) {
    fmt::format_to(out, "f {} {} {}\n", std::uint64_t{t[0]} + 1, std::uint64_t{t[1]} + 1, std::uint64_t{t[2]} + 1);
  }
  write_text(path, text);
}

}  // namespace isobench
