#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_bytes.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;  // normal, three corners, two bytes of attributes

using Corner = std::array<float, 3>;

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const float x : corner) hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 32U);
  }
};

/// STL files have no vertex numbers: corners with the same coordinates become one vertex, numbered in reading order.
class CornerMerger {
 public:
  void add(Corner corner) {
    for (float& x : corner) x += 0.0F;  // −0 becomes 0: they are equal but have different hashes
    const auto [entry, is_new] = numbers_.try_emplace(corner, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.emplace_back(corner[0], corner[1], corner[2]);
    if (corners_ == 0) mesh_.triangles.emplace_back();
    mesh_.triangles.back()[corners_] = entry->second;
    corners_ = (corners_ + 1) % 3;
  }
  bool between_triangles() const { return corners_ == 0; }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  TriangleMesh mesh_;
  std::unordered_map<Corner, std::uint32_t, CornerHash> numbers_;
  std::size_t corners_ = 0;  // of the triangle being read
};

TriangleMesh read_binary(std::string_view bytes) {
  CornerMerger merger;
  bytes.remove_prefix(kHeaderSize + 4);
  while (!bytes.empty()) {
    std::string_view facet = bytes.substr(12, kFacetSize - 14);  // without the normal and the attributes
    bytes.remove_prefix(kFacetSize);
    while (!facet.empty()) {
      Corner corner{};
      for (float& x : corner) x = take_number<float>(facet);
      merger.add(corner);
    }
  }
  return merger.take();
}

TriangleMesh read_ascii(std::string_view text, const std::filesystem::path& path) {
  CornerMerger merger;
  TextLines lines(text, path);
  bool complete = false;
  while (lines.next()) {
    const std::string_view keyword = lines.words()[0];
    complete = keyword == "endsolid";
    if (keyword == "vertex") {
      merger.add({static_cast<float>(lines.number(1)), static_cast<float>(lines.number(2)),
                  static_cast<float>(lines.number(3))});
    } else if (keyword == "outer" || keyword == "endloop") {
      if (!merger.between_triangles()) lines.fail("only triangles can be read");
    } else if (keyword != "solid" && keyword != "facet" && keyword != "endfacet" && !complete) {
      lines.fail(fmt::format("'{}' is unknown in an ASCII STL file", keyword));
    }
  }
  if (!complete) bad_mesh(path, "is truncated: it ends without endsolid");
  if (!merger.between_triangles()) bad_mesh(path, "its last triangle lacks a corner; only triangles can be read");
  return merger.take();
}

}  // namespace

TriangleMesh read_stl(const std::filesystem::path& path) {
  const std::string file = read_bytes(path);
  const std::string_view bytes = file;
  std::size_t announced = 0;
  if (bytes.size() >= kHeaderSize + 4) {
    std::string_view count = bytes.substr(kHeaderSize, 4);
    announced = take_number<std::uint32_t>(count);
    // The size decides, not the first word: many binary files begin with "solid".
    if (bytes.size() == kHeaderSize + 4 + announced * kFacetSize) return read_binary(bytes);
  }
  if (bytes.starts_with("solid") && bytes.find('\0') == std::string_view::npos) return read_ascii(bytes, path);
  bad_mesh(
      path,
      fmt::format("is not an STL file or is truncated: it is not ASCII, and its size does not match its {} triangles",
                  announced));
}

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string bytes = "binary STL, lengths in mm";
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
