#include "isobench/experiments/random_runs/mesh_promises.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

// A mesh of fewer vertices cannot always have valences of 5 to 7.
constexpr std::size_t small_component = 50;
constexpr double least_angle = 30.0;  // degrees
constexpr double largest_angle = 100.0;

// The number of vertices with a valence below 5 or above 7 on components that are not small. The mesh is closed.
std::size_t extreme_valences(const TriangleMesh& mesh) {
  std::vector<std::size_t> valence(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) ++valence[corner];
  }
  const std::vector<std::uint32_t> component = component_roots(mesh);
  std::vector<std::size_t> size(mesh.vertices.size(), 0);
  for (const std::uint32_t root : component) ++size[root];
  std::size_t extreme = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (size[component[v]] >= small_component && (valence[v] < 5 || valence[v] > 7)) ++extreme;
  }
  return extreme;
}

void check_topology(const Measurement& measurement, std::vector<std::string>& broken) {
  if (!is_closed_manifold(measurement)) broken.emplace_back("is no closed manifold");
  for (const char* figure : {"euler", "components"}) {
    const double is = measurement.number(figure);
    const double proven = measurement.number(std::string(figure) + "_reference");
    if (is != proven) broken.push_back(fmt::format("{} is {} instead of {}", figure, is, proven));
  }
}

void check_shape(const RunRequest& request, const TriangleMesh& mesh, const Measurement& measurement,
                 std::vector<std::string>& broken) {
  const double crossings = measurement.number("self_intersections");
  if (crossings != 0.0) broken.push_back(fmt::format("has {} self-intersections", crossings));
  const double longest = measurement.number("edge_over_h0_max");
  if (!request.sizing.uniform() && !(longest <= 1.0)) broken.push_back(fmt::format("has an edge of {} h0", longest));
  const double low = measurement.number("angle_min");
  const double high = measurement.number("angle_max");
  if (!(low >= least_angle && high <= largest_angle))
    broken.push_back(fmt::format("has angles of {:.1f}° to {:.1f}°", low, high));
  if (const std::size_t extreme = extreme_valences(mesh); extreme > 0)
    broken.push_back(fmt::format("has {} valences below 5 or above 7", extreme));
}

}  // namespace

bool promises_mesh(const RunRequest& request) { return request.method == "particles" || request.method == "cvt"; }

std::vector<std::string> broken_promises(const RunRequest& request, const TriangleMesh& mesh,
                                         const Measurement& measurement) {
  std::vector<std::string> broken;
  // A surface that leaves the volume is not measured, and nothing is promised of its mesh.
  if (!measurement.figure("euler_reference")) return broken;
  if (promises_mesh(request)) check_topology(measurement, broken);
  if (request.method == "particles") check_shape(request, mesh, measurement, broken);
  return broken;
}

std::string figures_text(const Measurement& measurement) {
  constexpr std::array figures = {
      "vertices",  "euler",     "components",       "euler_reference",       "components_reference",
      "angle_min", "angle_max", "edge_over_h0_max", "valence_extreme_count", "self_intersections"};
  std::string text;
  for (const char* figure : figures) text += fmt::format(" {} {:.4g}", figure, measurement.number(figure));
  return text + (is_closed_manifold(measurement) ? " closed" : " open");
}

}  // namespace isobench
