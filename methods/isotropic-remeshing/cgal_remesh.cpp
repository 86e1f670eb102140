#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "isobench/foundation/union_find.h"
#include "isobench/methods/cgal_failure.h"
#include "isobench/methods/isotropic-remeshing/remesh.h"

namespace isobench::isotropic_remeshing {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace pmp = CGAL::Polygon_mesh_processing;

// Gives the ends of very short edges the same coordinates. Marching cubes puts several vertices next to a node whose
// sample is the isovalue but for rounding, and CGAL's relaxation crashes at a vertex that has only flat triangles
// (CGAL's issue 7345).
void join_close_points(const TriangleMesh& mesh, double distance, std::vector<Point>& points) {
  UnionFind joined(points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {c, a}}) {
      if ((mesh.vertices[u] - mesh.vertices[v]).norm() < distance) joined.unite(u, v);
    }
  }
  for (std::uint32_t n = 0; n < points.size(); ++n) points[n] = points[joined.find(n)];
}

Mesh to_cgal(const TriangleMesh& mesh, double smallest_distance) {
  std::vector<Point> points;
  points.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& x : mesh.vertices) points.emplace_back(x[0], x[1], x[2]);
  std::vector<std::vector<std::size_t>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.push_back({t[0], t[1], t[2]});
  join_close_points(mesh, smallest_distance, points);
  pmp::merge_duplicate_points_in_polygon_soup(points, triangles);
  std::erase_if(triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  pmp::orient_polygon_soup(points, triangles);
  Mesh result;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, result);
  return result;
}

TriangleMesh from_cgal(Mesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh result;
  result.vertices.reserve(mesh.number_of_vertices());
  for (const auto vertex : mesh.vertices()) {
    const Point& p = mesh.point(vertex);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  result.triangles.reserve(mesh.number_of_faces());
  for (const auto face : mesh.faces()) {
    Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      triangle[corner++] = static_cast<std::uint32_t>(vertex);
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace

TriangleMesh remesh(const TriangleMesh& mesh, double edge_length, int iterations) {
  constexpr double negligible = 1e-7;
  Mesh work = to_cgal(mesh, negligible * edge_length);
  with_cgal("isotropic-remeshing", [&] {
    pmp::isotropic_remeshing(work.faces(), edge_length, work,
                             CGAL::parameters::number_of_iterations(static_cast<unsigned>(iterations)));
  });
  TriangleMesh result = from_cgal(work);
  drop_unused_vertices(result);
  return result;
}

}  // namespace isobench::isotropic_remeshing
