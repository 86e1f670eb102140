#include "isobench/methods/particles/mesh_edits/local_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "isobench/methods/particles/mesh_edits/shape_energy.h"
#include "isobench/methods/particles/mesh_edits/smoothing.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

constexpr int quick_sweeps = 6;
constexpr int thorough_sweeps = 25;

struct Change {
  enum class Kind { none, flip, collapse, split, divide } kind = Kind::none;
  Index at = EditableMesh::none;  ///< a half-edge; with `divide` a vertex
};

/// Whether the valences can still become good after the changes, which are pairs of vertex and difference. A valence of
/// 4 or 8 can be corrected by the next change; a valence farther off must at least come nearer to 6.
bool keeps_valences_mendable(const EditableMesh& mesh, std::initializer_list<std::pair<Index, int>> changes) {
  return std::all_of(changes.begin(), changes.end(), [&](const auto& change) {
    const int before = static_cast<int>(mesh.valence(change.first));
    const int after = before + change.second;
    return (after >= 4 && after <= 8) || std::abs(after - 6) < std::abs(before - 6);
  });
}

void edge_changes(const EditableMesh& mesh, Index e, std::vector<Change>& changes) {
  const Index f = mesh.twin(e);
  if (f == EditableMesh::none) return;
  const Index a = mesh.origin(e);
  const Index b = mesh.target(e);
  const Index c = mesh.apex(e);
  const Index d = mesh.apex(f);
  if (keeps_valences_mendable(mesh, {{a, -1}, {b, -1}, {c, 1}, {d, 1}}) && mesh.can_flip(e))
    changes.push_back({Change::Kind::flip, e});
  if (keeps_valences_mendable(mesh, {{c, 1}, {d, 1}})) changes.push_back({Change::Kind::split, e});
  for (const Index from : {e, f}) {
    const int gained = static_cast<int>(mesh.valence(mesh.origin(from))) - 4;
    if (keeps_valences_mendable(mesh, {{mesh.target(from), gained}, {c, -1}, {d, -1}}) && mesh.can_collapse(from))
      changes.push_back({Change::Kind::collapse, from});
  }
}

std::vector<Change> possible_changes(const EditableMesh& mesh, std::span<const Index> core) {
  std::vector<Change> changes;
  std::vector<std::uint8_t> in_core(mesh.vertex_count(), 0);
  for (const Index v : core) in_core[v] = 1;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (is_first_of_edge(mesh, e) && (in_core[mesh.origin(e)] != 0 || in_core[mesh.target(e)] != 0))
      edge_changes(mesh, e, changes);
  }
  for (const Index v : core) {
    if (mesh.movable(v) && mesh.valence(v) >= 6) changes.push_back({Change::Kind::divide, v});
  }
  return changes;
}

/// Changes the mesh, or returns false if the shapes do not allow it.
bool apply(const FinishContext& context, EditableMesh& mesh, const Change& change) {
  constexpr double least_q = 0.05;  // low, because smoothing follows
  switch (change.kind) {
    case Change::Kind::none:
      return true;
    case Change::Kind::flip:
      if (!flip_keeps_shape(context, mesh, change.at, least_q)) return false;
      mesh.flip(change.at);
      return true;
    case Change::Kind::collapse:
      if (!collapse_keeps_shape(context, mesh, change.at, least_q)) return false;
      mesh.collapse(change.at);
      return true;
    case Change::Kind::split:
      return split_edge_at_middle(context, mesh, change.at) != EditableMesh::none;
    case Change::Kind::divide:
      return divide_vertex(context, mesh, change.at) != EditableMesh::none;
  }
  return false;
}

/// Returns how often it tried to move a vertex.
double smooth_all(const FinishContext& context, EditableMesh& mesh, int sweeps) {
  std::vector<Index> all(mesh.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  return static_cast<double>(smooth(context, mesh, context.energies.rounds, sweeps, all));
}

struct State {
  EditableMesh mesh;
  double shortfall = 0.0;
};

void keep_best(std::vector<State>& states, std::size_t count) {
  std::stable_sort(states.begin(), states.end(),
                   [](const State& a, const State& b) { return a.shortfall < b.shortfall; });
  if (states.size() > count) states.resize(count);
}

/// Tries each possible change on a state, smooths the result briefly and adds it to `to`. Keeps the best `keep` states.
/// Takes the moves off the budget, and stops when it is used up.
void expand(const FinishContext& context, const State& from, std::span<const Index> core, const ShapeGoal& goal,
            std::vector<State>& to, std::size_t keep, SearchBudget& budget) {
  for (const Change& change : possible_changes(from.mesh, core)) {
    if (!(budget.moves > 0.0)) break;
    State next{from.mesh, 0.0};
    if (!apply(context, next.mesh, change)) continue;
    flip_for_valence(context, next.mesh);
    budget.moves -= smooth_all(context, next.mesh, quick_sweeps);
    next.shortfall = shortfall(context, next.mesh, goal);
    to.push_back(std::move(next));
    if (to.size() > 4 * keep) keep_best(to, keep);
  }
  keep_best(to, keep);
}

}  // namespace

Searched improve(const FinishContext& context, Submesh& submesh, const ShapeGoal& goal, const SearchEffort& search,
                 const SearchBudget& budget) {
  const double before = shortfall(context, submesh.mesh, goal);
  if (!(before > 0.0)) return {};
  SearchBudget left = budget;
  State best{submesh.mesh, before};
  const auto smooth_and_compare = [&](State& state) {
    left.moves -= smooth_all(context, state.mesh, thorough_sweeps);
    state.shortfall = shortfall(context, state.mesh, goal);
    if (state.shortfall < best.shortfall) best = state;
  };
  std::vector<State> beam{{submesh.mesh, before}};
  smooth_and_compare(beam.front());
  const auto width = static_cast<std::size_t>(search.beam);
  for (int depth = 0; depth < search.depth && best.shortfall > 0.0; ++depth) {
    std::vector<State> next;
    for (const State& state : beam) expand(context, state, submesh.core, goal, next, width + 2, left);
    for (State& state : next) {
      smooth_and_compare(state);
      if (best.shortfall == 0.0) break;
    }
    keep_best(next, width);
    beam = std::move(next);
  }
  const bool improved = best.shortfall <= 0.99 * before;
  if (improved) submesh.mesh = std::move(best.mesh);
  return {improved, budget.moves - left.moves};
}

double expected_moves(const Submesh& submesh, const SearchEffort& search) {
  const auto changes = static_cast<double>(possible_changes(submesh.mesh, submesh.core).size());
  const double expanded = 1.0 + (search.depth - 1.0) * search.beam;
  const double smoothed = 1.0 + search.depth * (search.beam + 2.0);
  return static_cast<double>(submesh.vertices.size()) *
         (expanded * changes * quick_sweeps + smoothed * thorough_sweeps);
}

}  // namespace isobench::particles
