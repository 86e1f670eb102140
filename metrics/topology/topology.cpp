#include "isobench/metrics/topology/topology.h"

#include <algorithm>

#include "isobench/foundation/union_find.h"
#include "isobench/methods/mesh/self_intersections.h"

namespace isobench {

namespace {

/// The corner of a triangle at vertex `v`; the corners of triangle t are 3t, 3t + 1 and 3t + 2.
std::uint32_t corner_at(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t v) {
  const Triangle& t = mesh.triangles[triangle];
  return 3 * triangle + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
}

/// Joins the triangles that meet at an edge and, at an edge of two triangles, their corners there. Counts the edges by
/// kind; returns how many there are.
std::size_t join_at_edges(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides, UnionFind& triangles,
                          UnionFind& corners, TopologyFigures& figures) {
  std::size_t edges = 0;
  for (std::size_t begin = 0; begin < sides.size(); ++edges) {
    const std::size_t end = edge_end(sides, begin);
    const HalfEdge& first = sides[begin];
    for (std::size_t s = begin + 1; s < end; ++s) triangles.unite(first.triangle, sides[s].triangle);
    if (end - begin == 1) ++figures.boundary_edges;
    if (end - begin > 2) ++figures.nonmanifold_edges;
    if (end - begin == 2) {
      const HalfEdge& second = sides[begin + 1];
      if (first.forward == second.forward) ++figures.misoriented_edges;
      for (const std::uint32_t v : {first.low, first.high}) {
        corners.unite(corner_at(mesh, first.triangle, v), corner_at(mesh, second.triangle, v));
      }
    }
    begin = end;
  }
  return edges;
}

}  // namespace

TopologyFigures measure_connectivity(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides) {
  TopologyFigures figures;
  UnionFind triangles(mesh.triangles.size());
  UnionFind corners(3 * mesh.triangles.size());
  const std::size_t edges = join_at_edges(mesh, sides, triangles, corners, figures);

  // A fan is a set of corners joined over edges of two triangles; an edge of more ends the fans that reach it.
  std::vector<std::uint32_t> fans(mesh.vertices.size(), 0);
  std::size_t faces = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_collapsed(mesh.triangles[t])) continue;
    ++faces;
    if (triangles.is_root(t)) ++figures.components;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (corners.is_root(3 * t + i)) ++fans[mesh.triangles[t][i]];
    }
  }
  const auto several = [](std::uint32_t n) { return n > 1; };
  figures.nonmanifold_vertices = static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), several));
  const auto unused = static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 0U));
  figures.euler = static_cast<long>(fans.size() - unused) - static_cast<long>(edges) + static_cast<long>(faces);
  return figures;
}

TopologyFigures measure_topology(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides) {
  TopologyFigures figures = measure_connectivity(mesh, sides);
  figures.self_intersections = count_self_intersections(mesh);
  return figures;
}

TopologyFigures measure_topology(const TriangleMesh& mesh) { return measure_topology(mesh, sorted_half_edges(mesh)); }

TopologyFigures measure_connectivity(const TriangleMesh& mesh) {
  return measure_connectivity(mesh, sorted_half_edges(mesh));
}

bool is_closed_manifold(const Measurement& measurement) {
  double defects = 0.0;
  for (const char* figure : {"boundary_edges", "nonmanifold_edges", "misoriented_edges", "nonmanifold_vertices"}) {
    defects += measurement.number(figure);
  }
  return defects == 0.0;  // false where one was not measured
}

}  // namespace isobench
