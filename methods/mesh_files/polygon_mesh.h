// What the readers of mesh files make: polygons, as other programs write them. read_mesh() makes triangles of them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::uint32_t> corners;  ///< of all polygons, one polygon after another
  std::vector<std::size_t> ends;       ///< of each polygon: the place in `corners` behind its last corner
  std::map<std::string, std::vector<double>> vertex_data;   ///< one value per vertex
  std::map<std::string, std::vector<double>> polygon_data;  ///< one value per polygon
  std::vector<std::string> notes;  ///< what the reader left out or decided, one sentence each, without the path

  std::size_t size() const { return ends.size(); }
  std::span<const std::uint32_t> polygon(std::size_t n) const {
    const std::size_t begin = n == 0 ? 0 : ends[n - 1];
    return {corners.data() + begin, ends[n] - begin};
  }
  /// Makes a polygon of the corners that were added since the last one.
  void end_polygon() { ends.push_back(corners.size()); }
  void add_polygon(std::span<const std::uint32_t> its_corners) {
    corners.insert(corners.end(), its_corners.begin(), its_corners.end());
    end_polygon();
  }
  /// Adds a strip's triangles, each turned as the first one, and returns their number. Triangles that name a vertex
  /// twice only lead from one part of a strip to the next: they are left out.
  std::size_t add_strip(std::span<const std::uint32_t> strip);
  /// Notes how many points and lines the file has besides its polygons.
  void note_left_out(std::size_t points, std::size_t lines);
};

/// The most corners of a polygon that to_triangles() takes; its cost grows with their square.
inline constexpr std::size_t most_corners = 10000;

/// Cuts polygons of more than three corners into triangles (polygon_cutter.h) and notes it. Corners that repeat the one
/// before are dropped from such polygons. Triangles stay as they are. Data of a polygon become data of its triangles.
/// Preconditions: corners are vertices that exist, coordinates are finite, no polygon has more than most_corners.
TriangleMesh to_triangles(PolygonMesh polygons, std::vector<std::string>& notes);

}  // namespace isobench
