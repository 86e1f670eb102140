// A Delaunay triangulation as plain arrays, for algorithms that go from cell to cell.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench {

/// Cells are tetrahedra. A cell outside the convex hull has `infinite` as one of its vertices. Facet i of a cell is
/// opposite its vertex i; neighbour i is the cell beyond facet i.
struct DelaunayCells {
  static constexpr std::uint32_t infinite = ~std::uint32_t{0};

  std::vector<std::array<std::uint32_t, 4>> vertices;    ///< indices into the points
  std::vector<std::array<std::uint32_t, 4>> neighbours;  ///< indices of cells
  std::vector<Eigen::Vector3d> centres;                  ///< circumcentres; undefined for cells outside the hull
  std::vector<std::vector<std::uint32_t>> around;        ///< for each point, the cells at it

  std::size_t size() const { return vertices.size(); }
  bool is_infinite(std::size_t cell) const {
    const auto& v = vertices[cell];
    return v[0] == infinite || v[1] == infinite || v[2] == infinite || v[3] == infinite;
  }
  /// The index of a point among the cell's vertices. Precondition: it is one of them.
  std::size_t index_of(std::size_t cell, std::uint32_t point) const;
  /// The index of the facet in the neighbour beyond it.
  std::size_t mirror(std::size_t cell, std::size_t facet) const;
  /// The facet's vertices, counter-clockwise as seen from beyond it.
  std::array<std::uint32_t, 3> facet(std::size_t cell, std::size_t facet) const;
};

/// What is said of points that span no tetrahedron.
inline constexpr const char* too_flat =
    "the points to triangulate lie in one plane, and a closed surface needs points outside it; ask for shorter edges";

/// Triangulates distinct points (mm). Throws Error if they span no tetrahedron. The same points in the same order give
/// the same cells. Cost: one Delaunay triangulation on one thread, about 10 µs a point; 600 bytes a point.
DelaunayCells delaunay_cells(const std::vector<Eigen::Vector3d>& points);

}  // namespace isobench
