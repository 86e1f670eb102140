// CGAL 6 renamed two of these headers and warns of the old names, but CGAL 5 has only those.
#define CGAL_NO_DEPRECATION_WARNINGS 1
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/metrics/distance_from_surface/distance_from_surface.h"

namespace isobench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;  // inexact: no decision depends on the last bits of a distance
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 point(const Eigen::Vector3d& x) { return {x[0], x[1], x[2]}; }

/// The triangles with area.
Triangles triangles_of(const TriangleMesh& mesh) {
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if ((b - a).cross(c - a).squaredNorm() > 0.0) triangles.emplace_back(point(a), point(b), point(c));
  }
  return triangles;
}

/// Points on F = c, and the area that each stands for.
struct Places {
  std::vector<Eigen::Vector3d> x;
  std::vector<double> area;
};

Places places_on(const Isosurface& surface, Monitor& monitor) {
  constexpr std::size_t most = 1000000;
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  const std::size_t stride = (lattice_mesh.triangles.size() + most - 1) / most;
  Places places{lattice_mesh.vertices, std::vector<double>(lattice_mesh.vertices.size(), 0.0)};
  std::vector<std::uint8_t> used(lattice_mesh.vertices.size(), 0);
  for (std::size_t n = 0; n < lattice_mesh.triangles.size(); n += stride) {
    const Triangle& t = lattice_mesh.triangles[n];
    const Eigen::Vector3d &a = places.x[t[0]], &b = places.x[t[1]], &c = places.x[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    for (const std::uint32_t v : t) {
      places.area[v] += area / 12.0;
      used[v] = 1;
    }
    const Eigen::Vector3d centroid = (a + b + c) / 3.0;
    places.x.push_back(centroid);
    places.area.push_back(0.75 * area);
  }
  tbb::parallel_for(used.size(), places.x.size(), [&](std::size_t n) {
    if (const auto foot = surface.project(places.x[n])) places.x[n] = *foot;
  });
  std::size_t kept = 0;
  for (std::size_t n = 0; n < places.x.size(); ++n) {
    if (n < used.size() && used[n] == 0) continue;
    places.x[kept] = places.x[n];
    places.area[kept++] = places.area[n];
  }
  places.x.resize(kept);
  places.area.resize(kept);
  return places;
}

}  // namespace

DistanceFromSurface measure_distance_from_surface(const TriangleMesh& mesh, const Isosurface& surface,
                                                  Monitor& monitor) {
  const Triangles triangles = triangles_of(mesh);
  if (triangles.empty()) return {surface.extent().norm(), surface.extent().norm()};
  Tree tree(triangles.begin(), triangles.end());
  tree.build();
  tree.accelerate_distance_queries();  // now, because many threads would make the first query at once
  const Places places = places_on(surface, monitor);
  std::vector<double> distance(places.x.size());
  tbb::parallel_for(std::size_t{0}, places.x.size(), [&](std::size_t n) {
    monitor.check();
    distance[n] = std::sqrt(tree.squared_distance(point(places.x[n])));
  });
  DistanceFromSurface figures;
  double area = 0.0;
  for (std::size_t n = 0; n < distance.size(); ++n) {
    figures.mean += places.area[n] * distance[n];
    figures.max = std::max(figures.max, distance[n]);
    area += places.area[n];
  }
  figures.mean = area > 0.0 ? figures.mean / area : 0.0;
  return figures;
}

}  // namespace isobench
