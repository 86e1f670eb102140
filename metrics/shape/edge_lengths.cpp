#include "isobench/metrics/shape/edge_lengths.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "isobench/metrics/shape/mesh_edges.h"

namespace isobench {

namespace {

std::vector<double> lengths_over_h0(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<double>& h0) {
  std::vector<double> ratios(edges.ends.size());
  tbb::parallel_for(std::size_t{0}, ratios.size(), [&](std::size_t e) {
    const auto [a, b] = edges.ends[e];
    const double bound = 0.5 * (h0[a] + h0[b]);
    const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
    ratios[e] = bound > 0.0 ? length / bound : std::numeric_limits<double>::infinity();
  });
  return ratios;
}

double percent(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::size_t count_above_one(const std::vector<double>& ratios) {
  return static_cast<std::size_t>(std::count_if(ratios.begin(), ratios.end(), [](double r) { return r > 1.0; }));
}

double triangles_above_one_percent(const MeshEdges& edges, const std::vector<double>& ratios) {
  const auto exceeds = [&](std::uint32_t edge) { return edge != MeshEdges::none && ratios[edge] > 1.0; };
  const auto triangles = std::count_if(edges.of_triangle.begin(), edges.of_triangle.end(),
                                       [&](const auto& of) { return std::any_of(of.begin(), of.end(), exceeds); });
  return percent(static_cast<std::size_t>(triangles), edges.of_triangle.size());
}

void measure_against_own(const TriangleMesh& mesh, const MeshEdges& edges, EdgeLengthFigures& figures) {
  figures.over_own_h0_max = figures.over_h0_max;
  figures.own_exceed_percent = figures.exceed_percent;
  figures.own_exceed_triangle_percent = figures.exceed_triangle_percent;
  const auto own = mesh.vertex_data.find(own_h0);
  if (own == mesh.vertex_data.end()) return;
  const std::vector<double> ratios = lengths_over_h0(mesh, edges, own->second);
  figures.over_own_h0_max = ratios.empty() ? 0.0 : *std::max_element(ratios.begin(), ratios.end());
  figures.own_exceed_percent = percent(count_above_one(ratios), ratios.size());
  figures.own_exceed_triangle_percent = triangles_above_one_percent(edges, ratios);
}

double floor_area_percent(const TriangleMesh& mesh, const std::vector<double>& h0, double floor) {
  if (floor <= 0.0) return 0.0;
  // The field is stored in single precision, so a node on the floor is within half an ulp of it.
  const double on_floor = floor * (1.0 + 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()));
  double area_sum = 0.0;
  double floor_sum = 0.0;
  for (const Triangle& c : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[c[0]];
    const double area = 0.5 * (mesh.vertices[c[1]] - a).cross(mesh.vertices[c[2]] - a).norm();
    const auto corners = std::count_if(c.begin(), c.end(), [&](std::uint32_t v) { return h0[v] <= on_floor; });
    area_sum += area;
    floor_sum += area * static_cast<double>(corners) / 3.0;
  }
  return area_sum > 0.0 ? 100.0 * floor_sum / area_sum : 0.0;
}

}  // namespace

EdgeLengthFigures measure_edge_lengths(const TriangleMesh& mesh, const SizingField& sizing,
                                       std::vector<double>* h0_at_vertices) {
  std::vector<double> h0(mesh.vertices.size());
  tbb::parallel_for(std::size_t{0}, h0.size(), [&](std::size_t v) { h0[v] = sizing.h0(mesh.vertices[v]); });
  const MeshEdges edges = mesh_edges(mesh);
  const std::vector<double> ratios = lengths_over_h0(mesh, edges, h0);

  EdgeLengthFigures figures;
  double sum = 0.0;
  for (const double ratio : ratios) {
    sum += ratio;
    figures.over_h0_max = std::max(figures.over_h0_max, ratio);
    figures.histogram.add(ratio);
  }
  if (!ratios.empty()) figures.over_h0_mean = sum / static_cast<double>(ratios.size());
  figures.exceed_count = count_above_one(ratios);
  figures.exceed_percent = percent(figures.exceed_count, ratios.size());
  figures.exceed_triangle_percent = triangles_above_one_percent(edges, ratios);
  measure_against_own(mesh, edges, figures);
  figures.floor_area_percent = floor_area_percent(mesh, h0, sizing.floor_length());
  if (h0_at_vertices != nullptr) *h0_at_vertices = std::move(h0);
  return figures;
}

}  // namespace isobench
