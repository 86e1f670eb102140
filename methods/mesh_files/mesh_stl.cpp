#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/text.h"
#include "isobench/methods/mesh_files/mesh_bytes.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;  // normal, three corners, two bytes of attributes

struct PlaceHash {
  std::size_t operator()(const std::array<double, 3>& place) const {
    std::uint64_t hash = 0;
    for (const double x : place) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32U;  // singles stored as doubles differ only in their upper bits
    }
    return hash;
  }
};

/// STL files have no vertex numbers: corners with the same coordinates become one vertex, numbered in reading order.
class CornerMerger {
 public:
  void add(const Eigen::Vector3d& corner) {
    // −0 becomes 0: they are equal but have different hashes.
    const std::array<double, 3> place{corner.x() + 0.0, corner.y() + 0.0, corner.z() + 0.0};
    const auto [entry, is_new] = numbers_.try_emplace(place, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.emplace_back(place[0], place[1], place[2]);
    mesh_.corners.push_back(entry->second);
  }
  std::size_t open_corners() const { return mesh_.corners.size() - (mesh_.ends.empty() ? 0 : mesh_.ends.back()); }
  PolygonMesh& mesh() { return mesh_; }

 private:
  PolygonMesh mesh_;
  std::unordered_map<std::array<double, 3>, std::uint32_t, PlaceHash> numbers_;
};

PolygonMesh read_binary(std::string_view bytes, std::size_t count) {
  CornerMerger merger;
  bytes = bytes.substr(kHeaderSize + 4, count * kFacetSize);
  while (!bytes.empty()) {
    std::string_view facet = bytes.substr(12, kFacetSize - 14);  // without the normal and the attributes
    bytes.remove_prefix(kFacetSize);
    while (!facet.empty()) {
      Eigen::Vector3d corner;
      for (int axis = 0; axis < 3; ++axis) corner[axis] = take_number<float>(facet);
      merger.add(corner);
    }
    merger.mesh().end_polygon();
  }
  return std::move(merger.mesh());
}

/// Coordinates are read as doubles: a text may have more digits than a single holds.
PolygonMesh read_ascii(std::string_view text, const std::filesystem::path& path) {
  CornerMerger merger;
  TextLines lines(text, path);
  bool complete = false;
  bool in_loop = false;
  while (lines.next()) {
    const std::string keyword = lower_case(std::string(lines.words()[0].substr(0, 100)));
    complete = keyword == "endsolid" || keyword == "end";
    if (keyword == "vertex") {
      if (!in_loop) lines.fail("a vertex is outside of a facet's loop");
      merger.add(lines.position(1));
      continue;
    }
    if (in_loop) {
      if (merger.open_corners() < 3) lines.fail("the facet has fewer than three corners");
      merger.mesh().end_polygon();
    }
    in_loop = keyword == "outer";
    if (!in_loop && !complete && keyword != "solid" && keyword != "facet" && keyword != "endloop" &&
        keyword != "endfacet") {
      lines.fail(fmt::format("'{}' is unknown in an ASCII STL file", keyword));
    }
  }
  if (!complete) bad_mesh(path, "is truncated: it ends without endsolid; export it again");
  return std::move(merger.mesh());
}

bool begins_as_text(std::string_view bytes) {
  if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return lower_case(std::string(bytes.substr(0, 5))) == "solid" && bytes.find('\0') == std::string_view::npos;
}

/// Whether the number of triangles in the header has bytes that no text has.
bool has_binary_count(std::string_view bytes) {
  const std::string_view count = bytes.substr(kHeaderSize, 4);
  return std::any_of(count.begin(), count.end(), [](char c) { return c < '\t' || c > '~'; });
}

/// A binary file whose size does not agree with the number of triangles in its header.
PolygonMesh read_binary_of_other_size(std::string_view bytes, std::size_t announced,
                                      const std::filesystem::path& path) {
  const std::size_t held = (bytes.size() - kHeaderSize - 4) / kFacetSize;
  const std::size_t trailing = bytes.size() - kHeaderSize - 4 - std::min(announced, held) * kFacetSize;
  // A program that writes triangles before it knows their number may leave it at 0 or at the largest number.
  const bool unset = announced == 0 || announced == std::numeric_limits<std::uint32_t>::max();
  const bool whole = bytes.size() == kHeaderSize + 4 + held * kFacetSize;
  if (unset && whole && held > 0) {
    PolygonMesh mesh = read_binary(bytes, held);
    mesh.notes.push_back(
        fmt::format("its header counts {} triangles, but its size is that of {}; these were read", announced, held));
    return mesh;
  }
  if (announced > held) {
    not_of_format(
        path, bytes, "a whole STL file",
        fmt::format("it is truncated, as its header counts {} triangles and there is room for {}", announced, held));
  }
  if (whole) {
    bad_mesh(path, fmt::format("its header counts {} triangles, but its size is that of {}; export it again", announced,
                               held));
  }
  PolygonMesh mesh = read_binary(bytes, announced);
  mesh.notes.push_back(fmt::format("{} byte{} after its last triangle {} left out", trailing, trailing == 1 ? "" : "s",
                                   trailing == 1 ? "was" : "were"));
  return mesh;
}

}  // namespace

PolygonMesh read_stl(const std::filesystem::path& path) {
  const std::string file = read_bytes(path);
  const std::string_view bytes = file;
  const bool text = begins_as_text(bytes);
  if (bytes.size() >= kHeaderSize + 4) {
    std::string_view count = bytes.substr(kHeaderSize, 4);
    const std::size_t announced = take_number<std::uint32_t>(count);
    // The size decides, not the first word: many binary files begin with "solid".
    if (bytes.size() == kHeaderSize + 4 + announced * kFacetSize) return read_binary(bytes, announced);
    if (!text && has_binary_count(bytes)) return read_binary_of_other_size(bytes, announced, path);
  }
  if (text) return read_ascii(bytes, path);
  not_of_format(path, bytes, "an STL file", "it is not binary and does not start with the word solid");
}

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string bytes = "binary STL, lengths in mm" + (mesh.space.empty() ? "" : ", " + space_mark(mesh));
  bytes.resize(kHeaderSize, ' ');
  put_number(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const Eigen::Vector3d normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    for (const Eigen::Vector3d& point : {normal, a, mesh.vertices[t[1]], mesh.vertices[t[2]]}) {
      for (int axis = 0; axis < 3; ++axis) put_number(bytes, static_cast<float>(point[axis]));
    }
    put_number(bytes, std::uint16_t{0});
  }
  write_text(path, bytes);
}

}  // namespace isobench
