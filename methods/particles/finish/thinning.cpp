#include "isobench/methods/particles/finish/thinning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "isobench/methods/particles/mesh_edits/bad_spots.h"
#include "isobench/methods/particles/mesh_edits/smoothing.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

constexpr int quick_sweeps = 4;
constexpr int thorough_sweeps = 25;
// Each bad triangle adds about 1 to the shortfall. Searches mend a few, not a place that has become too coarse.
constexpr double hopeless = 6.0;
constexpr std::array<SearchEffort, 4> narrow_searches{{{3, 1, 1}, {3, 1, 1}, {4, 2, 3}, {4, 2, 3}}};

void smooth_all(const FinishContext& context, EditableMesh& mesh, int sweeps, SearchBudget& budget) {
  std::vector<Index> all(mesh.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  budget.moves -= static_cast<double>(smooth(context, mesh, context.energies.rounds, sweeps, all));
}

struct Small {
  Index vertex = 0;
  double share = 1.0;
};

/// The vertices with small areas, smallest first, and how many vertices are too many where larger areas are asked for
/// than before. Elsewhere the vertices are as many as they should be, and counting them would hide the surplus.
struct Surplus {
  std::vector<Small> small;
  double vertices = 0.0;

  Surplus(const FinishContext& context, const AskedAreas& before, const EditableMesh& mesh) {
    constexpr double small_share = 0.85;
    constexpr double larger = 1.02;
    const std::vector<double> shares = area_shares(mesh, context.areas);
    const std::vector<double> asked = context.areas.at_vertices(mesh);
    const std::vector<double> asked_before = before.at_vertices(mesh);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.movable(v)) continue;
      if (asked[v] > larger * asked_before[v]) vertices += 1.0 - shares[v];
      if (shares[v] < small_share) small.push_back({v, shares[v]});
    }
    std::stable_sort(small.begin(), small.end(), [](const Small& a, const Small& b) { return a.share < b.share; });
  }
};

void mark_neighbours(const EditableMesh& mesh, Index v, std::vector<std::uint8_t>& marks) {
  Index e = mesh.out(v);
  do {
    marks[mesh.target(e)] = 1;
    e = mesh.turn(e);
  } while (e != mesh.out(v));
}

/// Collapses vertices that are no neighbours, at most a quarter of those that are too many. Returns how many.
std::size_t collapse_some(const FinishContext& context, const AskedAreas& before, EditableMesh& mesh) {
  constexpr double least_surplus = 0.6;
  constexpr double least_q = 0.1;  // low, because smoothing follows
  const Surplus surplus(context, before, mesh);
  if (surplus.vertices < least_surplus) return 0;
  const auto most = static_cast<std::size_t>(std::max(1.0, 0.25 * surplus.vertices));
  std::vector<std::uint8_t> touched(mesh.vertex_count(), 0);
  std::size_t count = 0;
  for (const Small& small : surplus.small) {
    if (count == most) break;
    if (touched[small.vertex] != 0) continue;
    const Index e = best_collapse(context, mesh, small.vertex, least_q);
    if (e == EditableMesh::none) continue;
    mark_neighbours(mesh, small.vertex, touched);
    mesh.collapse(e);
    ++count;
  }
  return count;
}

bool collapse_surplus(const FinishContext& context, const AskedAreas& before, EditableMesh& mesh,
                      SearchBudget& budget) {
  constexpr int rounds = 30;
  bool collapsed = false;
  for (int round = 0; round < rounds && budget.moves > 0.0 && collapse_some(context, before, mesh) > 0; ++round) {
    collapsed = true;
    flip_for_valence(context, mesh);
    smooth_all(context, mesh, quick_sweeps, budget);
  }
  return collapsed;
}

}  // namespace

bool thin_out(const FinishContext& context, const AskedAreas& before, const ShapeGoal& goal, EditableMesh& mesh,
              SearchBudget& budget) {
  const ShapeGoal usual;
  const double short_before = shortfall(context, mesh, goal);
  const double usual_before = shortfall(context, mesh, usual);
  if (!collapse_surplus(context, before, mesh, budget)) return false;
  smooth_all(context, mesh, thorough_sweeps, budget);
  flip_for_shape(context, mesh);
  smooth_all(context, mesh, thorough_sweeps, budget);
  for (const SearchEffort& effort : narrow_searches) {
    const double now = shortfall(context, mesh, goal);
    if (!(budget.moves > 0.0) || now <= short_before) break;
    if (now > short_before + hopeless) return false;
    improve_bad_spots(context, mesh, goal, effort, budget);
  }
  project_all(context.surface, mesh);
  return shortfall(context, mesh, goal) <= short_before && shortfall(context, mesh, usual) <= usual_before;
}

}  // namespace isobench::particles
