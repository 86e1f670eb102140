#include "methods/labelled_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "datasets/error.h"

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

// A flat cell's circumcentre may lie anywhere or be no number: not within the volume means outside.
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

  // Where the dual edge of a facet ends beyond the hull, far enough out to have left the object.
  Eigen::Vector3d beyond_hull(const Triangle& corners, const Eigen::Vector3d& from) const {
    const Eigen::Vector3d a = points[corners[0]];
    const Eigen::Vector3d normal = (points[corners[1]] - a).cross(points[corners[2]] - a).normalized();
    return from + (2.0 * (from - a).norm() + surface.voxel()) * normal;
  }

  template <class Visitor>
  void visit_facets(Visitor&& visit) const {
    for (const Cell cell : delaunay.finite_cell_handles()) {
      if (!cell->info()) continue;
      for (int i = 0; i < 4; ++i) {
        if (cell->neighbor(i)->info()) continue;
        // vertex_triple_index orders the facet opposite vertex i counter-clockwise seen from that vertex, which is
        // inside.
        const auto corner = [&](int n) { return cell->vertex(Delaunay::vertex_triple_index(i, n))->info(); };
        visit(cell, i, Triangle{corner(0), corner(2), corner(1)});
      }
    }
  }

  const Isosurface& surface;
  Delaunay delaunay;
  std::vector<Eigen::Vector3d> points;
  std::vector<Delaunay::Vertex_handle> vertices;  // by index of their point
};

LabelledDelaunay::LabelledDelaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface,
                                   Monitor& monitor)
    : triangulation_(std::make_unique<Triangulation>(points, surface)) {
  Delaunay& delaunay = triangulation_->delaunay;
  monitor.progress(0.8);
  if (delaunay.dimension() < 3) {
    throw Error("the points to triangulate lie in a plane; a closed surface needs more of them");
  }

  triangulation_->vertices.resize(points.size());
  for (const auto vertex : delaunay.finite_vertex_handles()) triangulation_->vertices[vertex->info()] = vertex;
  std::vector<Cell> cells;
  cells.reserve(delaunay.number_of_finite_cells());
  for (const Cell cell : delaunay.finite_cell_handles()) cells.push_back(cell);
  for (const Cell cell : delaunay.all_cell_handles()) cell->info() = false;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) cells[n]->info() = inside_object(cells[n], surface);
  });
}

LabelledDelaunay::~LabelledDelaunay() = default;
LabelledDelaunay::LabelledDelaunay(LabelledDelaunay&&) noexcept = default;

std::vector<LabelledDelaunay::Facet> LabelledDelaunay::facets() const {
  const Triangulation& t = *triangulation_;
  std::vector<Facet> result;
  result.reserve(2 * t.points.size());
  t.visit_facets([&](const Cell& cell, int i, const Triangle& corners) {
    const Eigen::Vector3d inside = circumcentre(cell);
    const Cell other = cell->neighbor(i);
    const bool hull = t.delaunay.is_infinite(other);
    result.push_back({corners, inside, hull ? t.beyond_hull(corners, inside) : circumcentre(other)});
  });
  return result;
}

std::vector<Triangle> LabelledDelaunay::triangles() const {
  std::vector<Triangle> result;
  result.reserve(2 * triangulation_->points.size());
  triangulation_->visit_facets([&](const Cell&, int, const Triangle& corners) { result.push_back(corners); });
  return result;
}

std::vector<std::uint32_t> LabelledDelaunay::insert(const std::vector<Eigen::Vector3d>& points) {
  Triangulation& t = *triangulation_;
  std::vector<std::uint32_t> changed;
  std::vector<Cell> around;
  for (const Eigen::Vector3d& x : points) {
    const auto vertex = t.delaunay.insert(Kernel3::Point_3(x[0], x[1], x[2]));
    vertex->info() = static_cast<std::uint32_t>(t.points.size());
    t.points.push_back(x);
    t.vertices.push_back(vertex);
    around.clear();
    t.delaunay.incident_cells(vertex, std::back_inserter(around));
    for (const Cell& cell : around) {
      const bool hull = t.delaunay.is_infinite(cell);
      cell->info() = !hull && inside_object(cell, t.surface);
      for (int i = 0; i < 4; ++i) {
        if (!t.delaunay.is_infinite(cell->vertex(i))) changed.push_back(cell->vertex(i)->info());
      }
    }
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

bool LabelledDelaunay::flip_label_at(std::uint32_t point) {
  Triangulation& t = *triangulation_;
  std::vector<Cell> around;
  t.delaunay.finite_incident_cells(t.vertices[point], std::back_inserter(around));
  Cell nearest;
  double least = 0.5 * t.surface.voxel();
  for (const Cell& cell : around) {
    const Eigen::Vector3d centre = circumcentre(cell);
    if (!within(centre, t.surface)) continue;
    const Jet jet = t.surface.value_gradient(centre);
    const double distance = std::abs(jet.value) / jet.gradient.norm();
    if (distance < least) {
      least = distance;
      nearest = cell;
    }
  }
  if (nearest == Cell()) return false;
  nearest->info() = !nearest->info();
  return true;
}

}  // namespace isobench
