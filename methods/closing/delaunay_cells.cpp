#include "isobench/methods/closing/delaunay_cells.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <utility>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

using Kernel3 = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel3>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel3,
                                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel3>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel3, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

}  // namespace

DelaunayCells delaunay_cells(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::pair<Kernel3::Point_3, std::uint32_t>> input;
  input.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    input.emplace_back(Kernel3::Point_3(points[n][0], points[n][1], points[n][2]), static_cast<std::uint32_t>(n));
  }
  Delaunay delaunay(input.begin(), input.end());
  if (delaunay.dimension() < 3) throw Error(too_flat);
  delaunay.infinite_vertex()->info() = DelaunayCells::infinite;
  std::uint32_t count = 0;
  for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) cell->info() = count++;

  DelaunayCells cells;
  cells.vertices.resize(count);
  cells.neighbours.resize(count);
  cells.centres.resize(count, Eigen::Vector3d::Zero());
  cells.around.resize(points.size());
  for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
    const std::size_t n = cell->info();
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      cells.vertices[n][at] = cell->vertex(i)->info();
      cells.neighbours[n][at] = cell->neighbor(i)->info();
      if (cells.vertices[n][at] != DelaunayCells::infinite) {
        cells.around[cells.vertices[n][at]].push_back(static_cast<std::uint32_t>(n));
      }
    }
    if (delaunay.is_infinite(cell)) continue;
    const Kernel3::Point_3 c = CGAL::circumcenter(cell->vertex(0)->point(), cell->vertex(1)->point(),
                                                  cell->vertex(2)->point(), cell->vertex(3)->point());
    cells.centres[n] = {c.x(), c.y(), c.z()};
  }
  return cells;
}

std::size_t DelaunayCells::index_of(std::size_t cell, std::uint32_t point) const {
  std::size_t i = 0;
  while (vertices[cell][i] != point) ++i;
  return i;
}

std::size_t DelaunayCells::mirror(std::size_t cell, std::size_t facet) const {
  const std::size_t beyond = neighbours[cell][facet];
  std::size_t i = 0;
  while (neighbours[beyond][i] != cell) ++i;
  return i;
}

std::array<std::uint32_t, 3> DelaunayCells::facet(std::size_t cell, std::size_t facet) const {
  // Cells are positively oriented: vertex 3 sees vertices 0, 1 and 2 counter-clockwise.
  static constexpr std::array<std::array<std::size_t, 3>, 4> kOrder{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const auto& v = vertices[cell];
  const auto& order = kOrder[facet];
  return {v[order[0]], v[order[1]], v[order[2]]};
}

}  // namespace isobench
