#include "isobench/metrics/edge_lengths/edge_lengths.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

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

}  // namespace

EdgeLengthFigures measure_edge_lengths(const TriangleMesh& mesh, const MeshEdges& edges,
                                       const std::vector<double>& h0) {
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
  return figures;
}

}  // namespace isobench
