#include "isobench/methods/closing/labelled_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "isobench/foundation/error.h"
#include "isobench/methods/closing/delaunay_cells.h"

namespace isobench {

namespace {

using Kernel3 = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel3>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<bool, Kernel3, CGAL::Delaunay_triangulation_cell_base_3<Kernel3>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel3, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Cell = Delaunay::Cell_handle;

Eigen::Vector3d to_eigen(const Kernel3::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Eigen::Vector3d circumcentre(const Cell& cell) {
  return to_eigen(CGAL::circumcenter(cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
                                     cell->vertex(3)->point()));
}

// Once a point has been removed, the order of CGAL's cells depends on addresses. Sorting makes the results
// deterministic.
Triangle corners_of(const Triangle& triangle) { return triangle; }
Triangle corners_of(const LabelledDelaunay::Facet& facet) { return facet.corners; }

template <class Item>
void sort_by_corners(std::vector<Item>& items) {
  tbb::parallel_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return corners_of(a) < corners_of(b); });
}

// The circumcentre of a flat cell may be anywhere, or not a number. A cell whose circumcentre is not within the volume
// is outside.
bool within(const Eigen::Vector3d& x, const Isosurface& surface) {
  return (x.array() >= 0.0).all() && (x.array() <= surface.extent().array()).all();
}

bool inside_object(const Cell& cell, const Isosurface& surface) {
  const Eigen::Vector3d centre = circumcentre(cell);
  return within(centre, surface) && surface.value(centre) > 0.0;
}

std::vector<std::pair<Kernel3::Point_3, std::uint32_t>> numbered(const std::vector<Eigen::Vector3d>& points,
                                                                 std::size_t first) {
  std::vector<std::pair<Kernel3::Point_3, std::uint32_t>> result;
  result.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    result.emplace_back(Kernel3::Point_3(points[n][0], points[n][1], points[n][2]),
                        static_cast<std::uint32_t>(first + n));
  }
  return result;
}

}  // namespace

struct LabelledDelaunay::Triangulation {
  Triangulation(const std::vector<Eigen::Vector3d>& the_points, const Isosurface& the_surface)
      : surface(the_surface), points(the_points) {
    const auto input = numbered(the_points, 0);
    delaunay.insert(input.begin(), input.end());
  }

  // The end of the dual edge of a facet of the hull, far enough out to be outside the object.
  Eigen::Vector3d beyond_hull(const Triangle& corners, const Eigen::Vector3d& from) const {
    const Eigen::Vector3d a = points[corners[0]];
    const Eigen::Vector3d normal = (points[corners[1]] - a).cross(points[corners[2]] - a).normalized();
    return from + (2.0 * (from - a).norm() + surface.voxel()) * normal;
  }

  // The corners of the facet opposite vertex i of an inside cell.
  Triangle corners(const Cell& cell, int i) const {
    // vertex_triple_index gives counter-clockwise order seen from vertex i, which is inside.
    const auto corner = [&](int n) { return cell->vertex(Delaunay::vertex_triple_index(i, n))->info(); };
    Triangle result{corner(0), corner(2), corner(1)};
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  }

  Facet facet(const Cell& cell, int i, const Triangle& corners) const {
    const Eigen::Vector3d inside = circumcentre(cell);
    const Cell other = cell->neighbor(i);
    return {corners, inside, delaunay.is_infinite(other) ? beyond_hull(corners, inside) : circumcentre(other)};
  }

  template <class Visitor>
  void visit_facets(Visitor&& visit) const {
    for (const Cell cell : delaunay.finite_cell_handles()) {
      if (!cell->info()) continue;
      for (int i = 0; i < 4; ++i) {
        if (!cell->neighbor(i)->info()) visit(cell, i, corners(cell, i));
      }
    }
  }

  // Must be called before remove().
  void insert(const std::vector<Eigen::Vector3d>& added, const std::vector<std::uint32_t>& removed);
  // Renumbers the points that stay. Returns for each of them whether a removed point was beside it, which changed its
  // cells.
  std::vector<char> remove(const std::vector<std::uint32_t>& removed);
  void label(const std::vector<Cell>& cells);

  const Isosurface& surface;
  Delaunay delaunay;
  std::vector<Eigen::Vector3d> points;
  std::vector<Delaunay::Vertex_handle> vertices;  // of each point
};

LabelledDelaunay::LabelledDelaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface,
                                   Monitor& monitor)
    : triangulation_(std::make_unique<Triangulation>(points, surface)) {
  Delaunay& delaunay = triangulation_->delaunay;
  monitor.progress(0.8);
  if (delaunay.dimension() < 3) throw Error(too_flat);

  triangulation_->vertices.resize(points.size());
  for (const auto vertex : delaunay.finite_vertex_handles()) triangulation_->vertices[vertex->info()] = vertex;
  std::vector<Cell> cells;
  cells.reserve(delaunay.number_of_finite_cells());
  for (const Cell cell : delaunay.finite_cell_handles()) cells.push_back(cell);
  for (const Cell cell : delaunay.all_cell_handles()) cell->info() = false;
  triangulation_->label(cells);
}

LabelledDelaunay::~LabelledDelaunay() = default;
LabelledDelaunay::LabelledDelaunay(LabelledDelaunay&&) noexcept = default;

std::vector<LabelledDelaunay::Facet> LabelledDelaunay::facets() const {
  const Triangulation& t = *triangulation_;
  std::vector<Facet> result;
  result.reserve(2 * t.points.size());
  t.visit_facets(
      [&](const Cell& cell, int i, const Triangle& corners) { result.push_back(t.facet(cell, i, corners)); });
  sort_by_corners(result);
  return result;
}

std::vector<Triangle> LabelledDelaunay::triangles() const {
  std::vector<Triangle> result;
  result.reserve(2 * triangulation_->points.size());
  triangulation_->visit_facets([&](const Cell&, int, const Triangle& corners) { result.push_back(corners); });
  sort_by_corners(result);
  return result;
}

std::vector<LabelledDelaunay::Facet> LabelledDelaunay::facets_at(const std::vector<std::uint32_t>& points) const {
  const Triangulation& t = *triangulation_;
  std::vector<char> asked(t.points.size(), 0);
  for (const std::uint32_t point : points) asked[point] = 1;
  std::vector<Facet> result;
  std::vector<Cell> around;
  for (const std::uint32_t point : points) {
    around.clear();
    t.delaunay.finite_incident_cells(t.vertices[point], std::back_inserter(around));
    for (const Cell& cell : around) {
      if (!cell->info()) continue;
      for (int i = 0; i < 4; ++i) {
        if (cell->neighbor(i)->info() || cell->vertex(i)->info() == point) continue;
        const Triangle corners = t.corners(cell, i);
        // Takes each facet once, at its asked corner with the lowest index.
        const bool is_taken = std::any_of(corners.begin(), corners.end(),
                                          [&](std::uint32_t corner) { return corner < point && asked[corner] != 0; });
        if (!is_taken) result.push_back(t.facet(cell, i, corners));
      }
    }
  }
  sort_by_corners(result);
  return result;
}

void LabelledDelaunay::Triangulation::insert(const std::vector<Eigen::Vector3d>& added,
                                             const std::vector<std::uint32_t>& removed) {
  for (const Eigen::Vector3d& x : added) {
    const std::size_t before = delaunay.number_of_vertices();
    // Points that are added together are mostly close to each other, so the search starts at the last one.
    const auto vertex = delaunay.insert(Kernel3::Point_3(x[0], x[1], x[2]), vertices.back());
    // If the point coincides with one to be removed, it takes over that point's vertex.
    if (delaunay.number_of_vertices() == before) {
      if (!std::binary_search(removed.begin(), removed.end(), vertex->info()))
        throw Error("a point that is added to the triangulation coincides with one of its points");
      vertices[vertex->info()] = Delaunay::Vertex_handle();
    }
    vertex->info() = static_cast<std::uint32_t>(points.size());
    points.push_back(x);
    vertices.push_back(vertex);
  }
}

std::vector<char> LabelledDelaunay::Triangulation::remove(const std::vector<std::uint32_t>& removed) {
  std::vector<char> beside(points.size(), 0);
  std::vector<Cell> fresh;
  for (const std::uint32_t point : removed) {
    if (vertices[point] == Delaunay::Vertex_handle()) continue;
    fresh.clear();
    delaunay.remove_and_give_new_cells(vertices[point], std::back_inserter(fresh));
    if (delaunay.dimension() < 3) throw Error(too_flat);
    vertices[point] = Delaunay::Vertex_handle();
    for (const Cell& cell : fresh) {
      cell->info() = false;
      for (int i = 0; i < 4; ++i) {
        if (!delaunay.is_infinite(cell->vertex(i))) beside[cell->vertex(i)->info()] = 1;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (vertices[n] == Delaunay::Vertex_handle()) continue;
    points[kept] = points[n];
    vertices[kept] = vertices[n];
    vertices[kept]->info() = static_cast<std::uint32_t>(kept);
    beside[kept] = beside[n];
    ++kept;
  }
  points.resize(kept);
  vertices.resize(kept);
  beside.resize(kept);
  return beside;
}

void LabelledDelaunay::Triangulation::label(const std::vector<Cell>& cells) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) cells[n]->info() = inside_object(cells[n], surface);
  });
}

std::vector<std::uint32_t> LabelledDelaunay::replace(const std::vector<std::uint32_t>& removed,
                                                     const std::vector<Eigen::Vector3d>& points) {
  Triangulation& t = *triangulation_;
  const std::size_t kept = t.points.size() - removed.size();
  // Insert before removing: otherwise long cells bridge the hole from sheet to sheet, and each removal is slow.
  t.insert(points, removed);
  const std::vector<char> beside = t.remove(removed);

  // A new cell has a new corner, or all its corners are new or beside removed points.
  const auto is_new = [kept](std::uint32_t corner) { return corner >= kept; };
  const auto is_affected = [&](std::uint32_t corner) { return is_new(corner) || beside[corner] != 0; };
  std::vector<char> changed = beside;
  std::vector<Cell> fresh;
  std::vector<Cell> around;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t point = 0; point < changed.size(); ++point) {
    if (!is_affected(point)) continue;
    around.clear();
    t.delaunay.incident_cells(t.vertices[point], std::back_inserter(around));
    for (const Cell& cell : around) {
      corners.clear();
      for (int i = 0; i < 4; ++i) {
        if (!t.delaunay.is_infinite(cell->vertex(i))) corners.push_back(cell->vertex(i)->info());
      }
      // Takes each cell once, at its affected corner with the lowest index.
      if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return c < point && is_affected(c); }))
        continue;
      if (!std::any_of(corners.begin(), corners.end(), is_new) &&
          !std::all_of(corners.begin(), corners.end(), is_affected))
        continue;
      for (const std::uint32_t corner : corners) changed[corner] = 1;
      if (corners.size() == 4)
        fresh.push_back(cell);
      else
        cell->info() = false;
    }
  }
  t.label(fresh);
  std::vector<std::uint32_t> result;
  for (std::uint32_t point = 0; point < changed.size(); ++point) {
    if (changed[point] != 0) result.push_back(point);
  }
  return result;
}

std::uint32_t LabelledDelaunay::nearest(const Eigen::Vector3d& x, std::uint32_t near) const {
  const Triangulation& t = *triangulation_;
  return t.delaunay.nearest_vertex(Kernel3::Point_3(x[0], x[1], x[2]), t.vertices[near]->cell())->info();
}

std::optional<LabelledDelaunay::Corners> LabelledDelaunay::flip_label_at(std::uint32_t point, std::size_t rank) {
  const Triangulation& t = *triangulation_;
  std::vector<Cell> around;
  t.delaunay.finite_incident_cells(t.vertices[point], std::back_inserter(around));
  std::vector<std::pair<double, Cell>> near;
  for (const Cell& cell : around) {
    const Eigen::Vector3d centre = circumcentre(cell);
    if (!within(centre, t.surface)) continue;
    const Jet jet = t.surface.value_gradient(centre);
    const double distance = std::abs(jet.value) / jet.gradient.norm();
    if (distance < 0.5 * t.surface.voxel()) near.emplace_back(distance, cell);
  }
  if (rank >= near.size()) return {};
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const Cell cell = near[rank].second;
  cell->info() = !cell->info();
  Corners corners{};
  for (int i = 0; i < 4; ++i) corners[static_cast<std::size_t>(i)] = cell->vertex(i)->info();
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace isobench
