#include "isobench/methods/mesh/component_match.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace isobench {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::vector<std::uint32_t> nearest_components(const TriangleMesh& mesh, const Isosurface& surface,
                                              const CertifiedTopology& topology) {
  std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, result.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Eigen::Vector3d foot = surface.project(mesh.vertices[n]).value_or(mesh.vertices[n]);
      result[n] = topology.boxes->component_at(foot).value_or(none);
    }
  });
  return result;
}

/// V − E + F of each piece, at the piece's root.
std::vector<long> euler_of_pieces(const TriangleMesh& mesh, const std::vector<std::uint32_t>& piece,
                                  const std::vector<char>& is_used) {
  std::vector<long> euler(mesh.vertices.size(), 0);
  for (std::size_t n = 0; n < piece.size(); ++n) euler[piece[n]] += is_used[n] != 0 ? 1 : 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    ++euler[piece[t[0]]];
    for (std::size_t side = 0; side < 3; ++side) edges.push_back(std::minmax(t[side], t[(side + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& edge : edges) --euler[piece[edge.first]];
  return euler;
}

}  // namespace

ComponentMatch match_components(const TriangleMesh& mesh, const Isosurface& surface,
                                const CertifiedTopology& topology) {
  ComponentMatch match;
  match.of_vertex = nearest_components(mesh, surface, topology);
  match.shown.assign(topology.components.size(), Shown::lost);
  std::vector<char> is_used(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) is_used[corner] = 1;
  }
  const std::vector<std::uint32_t> piece = component_roots(mesh);
  const std::vector<long> euler = euler_of_pieces(mesh, piece, is_used);
  std::vector<std::uint32_t> component_of_piece(mesh.vertices.size(), none);
  std::vector<std::uint32_t> piece_of_component(topology.components.size(), none);
  const auto joined = [&match](std::uint32_t component) { match.shown[component] = Shown::joined; };
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    const std::uint32_t component = match.of_vertex[n];
    if (is_used[n] == 0 || component == none) continue;
    std::uint32_t& of_piece = component_of_piece[piece[n]];
    std::uint32_t& of_component = piece_of_component[component];
    if (of_piece == none && of_component == none) {
      of_piece = component;
      of_component = piece[n];
      match.shown[component] =
          euler[piece[n]] == topology.components[component].euler ? Shown::right : Shown::different;
      continue;
    }
    if (of_piece != none && of_piece != component) {
      joined(component);
      joined(of_piece);
    }
    if (of_piece == none) of_piece = component;
    if (of_component == none) of_component = piece[n];
    if (of_component != piece[n] && match.shown[component] == Shown::right) match.shown[component] = Shown::different;
  }
  for (std::size_t c = 0; c < topology.components.size(); ++c) {
    if (topology.components[c].is_left_out) match.shown[c] = Shown::left_out;
  }
  return match;
}

void drop_left_out(TriangleMesh& mesh, const Isosurface& surface, const CertifiedTopology& topology) {
  if (topology.kept_components() == topology.components.size()) return;
  const std::vector<std::uint32_t> component = nearest_components(mesh, surface, topology);
  const std::vector<std::uint32_t> piece = component_roots(mesh);
  std::vector<char> is_kept(mesh.vertices.size(), 0);  // at the root of each piece
  for (std::size_t n = 0; n < piece.size(); ++n) {
    if (component[n] == none || !topology.components[component[n]].is_left_out) is_kept[piece[n]] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    if (is_kept[piece[mesh.triangles[n][0]]] == 0) continue;
    for (auto& [name, values] : mesh.triangle_data) values[kept] = values[n];
    mesh.triangles[kept++] = mesh.triangles[n];
  }
  mesh.triangles.resize(kept);
  for (auto& [name, values] : mesh.triangle_data) values.resize(kept);
  drop_unused_vertices(mesh);
}

}  // namespace isobench
