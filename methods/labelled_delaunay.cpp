#include "methods/labelled_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <utility>

#include "datasets/error.h"

namespace isobench {

namespace {

using Kernel3 = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel3>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<bool, Kernel3, CGAL::Delaunay_triangulation_cell_base_3<Kernel3>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel3, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

bool inside_object(const Delaunay::Cell_handle& cell, const Isosurface& surface) {
  const Kernel3::Point_3 c = CGAL::circumcenter(cell->vertex(0)->point(), cell->vertex(1)->point(),
                                                cell->vertex(2)->point(), cell->vertex(3)->point());
  const Eigen::Vector3d centre(c.x(), c.y(), c.z());
  // A flat cell's circumcentre may lie anywhere or be no number: not within the volume means outside.
  if (!((centre.array() >= 0.0).all() && (centre.array() <= surface.extent().array()).all())) return false;
  return surface.value(centre) > 0.0;
}

}  // namespace

LabelledDelaunay labelled_delaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface,
                                   Monitor& monitor) {
  std::vector<std::pair<Kernel3::Point_3, std::uint32_t>> input;
  input.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    input.emplace_back(Kernel3::Point_3(points[n][0], points[n][1], points[n][2]), static_cast<std::uint32_t>(n));
  }
  const Delaunay delaunay(input.begin(), input.end());
  monitor.progress(0.8);
  if (delaunay.dimension() < 3) {
    throw Error("the points to triangulate lie in a plane; a closed surface needs more of them");
  }

  std::vector<Delaunay::Cell_handle> cells;
  cells.reserve(delaunay.number_of_finite_cells());
  for (const Delaunay::Cell_handle cell : delaunay.finite_cell_handles()) cells.push_back(cell);
  for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) cell->info() = false;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) cells[n]->info() = inside_object(cells[n], surface);
  });

  LabelledDelaunay result;
  result.cells = cells.size();
  result.triangles.reserve(2 * points.size());
  for (const Delaunay::Cell_handle cell : cells) {
    if (!cell->info()) continue;
    for (int i = 0; i < 4; ++i) {
      if (cell->neighbor(i)->info()) continue;
      // vertex_triple_index orders the facet opposite vertex i counter-clockwise seen from that vertex, which is
      // inside.
      const auto corner = [&](int n) { return cell->vertex(Delaunay::vertex_triple_index(i, n))->info(); };
      result.triangles.push_back({corner(0), corner(2), corner(1)});
    }
  }
  return result;
}

}  // namespace isobench
