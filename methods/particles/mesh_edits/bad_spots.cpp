#include "isobench/methods/particles/mesh_edits/bad_spots.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

/// h0 at every vertex, because each ends about six edges; empty if the sizing is uniform.
std::vector<double> h0_at_vertices(const FinishContext& context, const EditableMesh& mesh) {
  if (context.sizing.uniform()) return {};
  std::vector<double> h0(mesh.vertex_count(), 0.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, h0.size(), 1024), [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v) {
      if (mesh.alive(static_cast<Index>(v))) h0[v] = context.sizing.h0(mesh.points[v]);
    }
  });
  return h0;
}

/// The movable vertices of each bad spot: a vertex with a bad valence, or the corners of a bad triangle.
std::vector<std::vector<Index>> bad_spots(const FinishContext& context, const EditableMesh& mesh,
                                          const ShapeGoal& goal) {
  const std::vector<double> h0 = h0_at_vertices(context, mesh);
  const auto is_too_long = [&](Index e) {
    const Index a = mesh.origin(e);
    const Index b = mesh.target(e);
    return edge_shortfall((mesh.points[a] - mesh.points[b]).norm() * 2.0 / (h0[a] + h0[b])) > 0.0;
  };
  const std::size_t triangles = mesh.half_edge_count() / 3;
  std::vector<std::uint8_t> bad(triangles, 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto t = static_cast<Index>(n);
      if (!mesh.triangle_alive(t)) continue;
      bool found = triangle_shortfall(mesh, mesh.triangle(t), goal) > 0.0;
      for (Index e = 3 * t; e < 3 * t + 3 && !found && !h0.empty(); ++e)
        found = is_first_of_edge(mesh, e) && is_too_long(e);
      bad[n] = found ? 1 : 0;
    }
  });
  std::vector<std::vector<Index>> spots;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.movable(v) && valence_shortfall(mesh, v) > 0.0) spots.push_back({v});
  }
  for (Index t = 0; t < triangles; ++t) {
    if (bad[t] == 0) continue;
    const Triangle corners = mesh.triangle(t);
    std::vector<Index> spot;
    for (const Index v : corners) {
      if (mesh.movable(v)) spot.push_back(v);
    }
    if (!spot.empty()) spots.push_back(std::move(spot));
  }
  return spots;
}

/// The submeshes around bad spots that do not overlap.
std::vector<Submesh> separate_submeshes(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal,
                                        int rings) {
  std::vector<Submesh> submeshes;
  std::vector<std::uint8_t> taken(mesh.vertex_count(), 0);
  const auto is_taken = [&taken](Index v) { return taken[v] != 0; };
  for (const auto& spot : bad_spots(context, mesh, goal)) {
    if (std::any_of(spot.begin(), spot.end(), is_taken)) continue;
    Submesh submesh = extract_submesh(mesh, spot, rings);
    if (std::any_of(submesh.vertices.begin(), submesh.vertices.end(), is_taken)) continue;
    for (const Index v : submesh.vertices) taken[v] = 1;
    submeshes.push_back(std::move(submesh));
  }
  return submeshes;
}

/// The order in which to search: as they come, or the worst first if the budget may be too small for all.
std::vector<std::size_t> search_order(const FinishContext& context, const std::vector<Submesh>& submeshes,
                                      const ShapeGoal& goal, const std::vector<double>& expected,
                                      const SearchBudget& budget) {
  std::vector<std::size_t> order(submeshes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (std::accumulate(expected.begin(), expected.end(), 0.0) <= budget.moves) return order;
  std::vector<double> missing;
  for (const Submesh& submesh : submeshes) missing.push_back(shortfall(context, submesh.mesh, goal));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return missing[a] > missing[b]; });
  return order;
}

/// Searches on all submeshes, as far as the budget goes. Returns for each whether it has improved. The batches depend
/// on what was expected and spent, not on threads.
std::vector<std::uint8_t> search_all(const FinishContext& context, std::vector<Submesh>& submeshes,
                                     const ShapeGoal& goal, const SearchEffort& search, SearchBudget& budget) {
  std::vector<double> expected;
  for (const Submesh& submesh : submeshes) expected.push_back(expected_moves(submesh, search));
  const std::vector<std::size_t> order = search_order(context, submeshes, goal, expected, budget);
  std::vector<Searched> searched(submeshes.size());
  for (std::size_t begin = 0; begin < order.size() && budget.moves > 0.0;) {
    std::size_t end = begin;
    for (double sum = 0.0; end < order.size(); ++end) {
      sum += expected[order[end]];
      if (end > begin && sum > budget.moves) break;
    }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(begin, end, 1),
        [&](const auto& range) {
          for (std::size_t n = range.begin(); n < range.end(); ++n)
            searched[order[n]] = improve(context, submeshes[order[n]], goal, search, budget);
        },
        tbb::simple_partitioner());
    for (; begin < end; ++begin) budget.moves -= searched[order[begin]].moves;
  }
  std::vector<std::uint8_t> better;
  for (const Searched& one : searched) better.push_back(one.improved ? 1 : 0);
  return better;
}

}  // namespace

std::size_t improve_bad_spots(const FinishContext& context, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search, SearchBudget& budget) {
  std::vector<Submesh> submeshes = separate_submeshes(context, mesh, goal, search.rings);
  const std::vector<std::uint8_t> better = search_all(context, submeshes, goal, search, budget);
  std::size_t improved = 0;
  for (std::size_t n = 0; n < submeshes.size(); ++n) {
    if (better[n] == 0) continue;
    put_back_submesh(mesh, submeshes[n]);
    ++improved;
  }
  return improved;
}

double expected_moves(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal,
                      const SearchEffort& search) {
  double moves = 0.0;
  for (const Submesh& submesh : separate_submeshes(context, mesh, goal, search.rings))
    moves += expected_moves(submesh, search);
  return moves;
}

std::size_t count_bad_spots(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal) {
  return bad_spots(context, mesh, goal).size();
}

}  // namespace isobench::particles
