// A Delaunay triangulation as plain arrays, for algorithms that walk over its cells.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench {

/// Cells are tetrahedra; those outside the convex hull have the vertex `infinite` at their apex. Facet i of a cell is
/// the one opposite its vertex i, and neighbour i lies beyond it.
struct DelaunayCells {
  static constexpr std::uint32_t infinite = ~std::uint32_t{0};

  std::vector<std::array<std::uint32_t, 4>> vertices;    ///< indices into the points
  std::vector<std::array<std::uint32_t, 4>> neighbours;  ///< indices of cells
  std::vector<Eigen::Vector3d> centres;                  ///< circumcentres; of cells outside the hull without meaning
  std::vector<std::vector<std::uint32_t>> around;        ///< of each point: the cells that it is a vertex of

  std::size_t size() const { return vertices.size(); }
  bool is_infinite(std::size_t cell) const {
    const auto& v = vertices[cell];
    return v[0] == infinite || v[1] == infinite || v[2] == infinite || v[3] == infinite;
  }
  /// Which of the cell's vertices a point is; it must be one.
  std::size_t index_of(std::size_t cell, std::uint32_t point) const;
  /// The facet's number as seen from its other side: index i of the neighbour whose neighbour i is this cell.
  std::size_t mirror(std::size_t cell, std::size_t facet) const;
  /// The facet's vertices, counter-clockwise as seen from beyond it.
  std::array<std::uint32_t, 3> facet(std::size_t cell, std::size_t facet) const;
};

/// `points` in mm, distinct. Throws Error if they span no tetrahedron. Cost: one Delaunay triangulation on one thread,
/// about 10 µs a point, and 600 bytes a point. The same points in the same order give the same cells.
DelaunayCells delaunay_cells(const std::vector<Eigen::Vector3d>& points);

}  // namespace isobench
