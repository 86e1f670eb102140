#include "isobench/methods/particles/finish/local_search.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "isobench/methods/particles/finish/shape_energy.h"
#include "isobench/methods/particles/finish/smoothing.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

// Added to the shortfall of every bad triangle or edge, so that few large ones are better than many small ones.
constexpr double base_shortfall = 0.2;
constexpr ShapeEnergy tail_shape{2};
constexpr int quick_sweeps = 6;
constexpr int thorough_sweeps = 25;

double triangle_shortfall(const EditableMesh& mesh, const Triangle& t, const ShapeGoal& goal) {
  const double a = (mesh.points[t[1]] - mesh.points[t[2]]).norm();
  const double b = (mesh.points[t[2]] - mesh.points[t[0]]).norm();
  const double c = (mesh.points[t[0]] - mesh.points[t[1]]).norm();
  const double q = (b + c - a) * (c + a - b) * (a + b - c) / std::max(a * b * c, 1e-300);
  if (q > 0.9) return 0.0;  // all angles are then within 39° to 83°
  double low = std::min({a, b, c});
  double high = std::max({a, b, c});
  const double middle = a + b + c - low - high;
  const auto angle = [](double opposite, double left, double right) {
    const double cosine = (left * left + right * right - opposite * opposite) / std::max(2.0 * left * right, 1e-300);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  };
  const double miss = std::max({(goal.radius_ratio - q) / 0.05, (goal.least_angle - angle(low, middle, high)) / 5.0,
                                (angle(high, middle, low) - goal.largest_angle) / 5.0});
  return miss > 0.0 ? miss + base_shortfall : 0.0;
}

double valence_shortfall(const EditableMesh& mesh, Index v) {
  const double away = std::abs(static_cast<double>(mesh.valence(v)) - 6.0);
  return away > 1.0 ? away - 1.0 : 0.0;
}

double edge_shortfall(const FinishContext& context, const EditableMesh& mesh, Index e) {
  if (context.sizing.uniform()) return 0.0;
  const double over = edge_over_h0(context, mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]) - 0.999;
  return over > 0.0 ? base_shortfall + 20.0 * over : 0.0;
}

/// True for one half-edge of each edge.
bool is_first_of_edge(const EditableMesh& mesh, Index e) {
  return mesh.origin(e) != EditableMesh::none && (mesh.twin(e) == EditableMesh::none || e < mesh.twin(e));
}

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

void smooth_all(const FinishContext& context, EditableMesh& mesh, int sweeps) {
  std::vector<Index> all(mesh.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  smooth(context, mesh, tail_shape, sweeps, all);
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
void expand(const FinishContext& context, const State& from, std::span<const Index> core, const ShapeGoal& goal,
            std::vector<State>& to, std::size_t keep) {
  for (const Change& change : possible_changes(from.mesh, core)) {
    State next{from.mesh, 0.0};
    if (!apply(context, next.mesh, change)) continue;
    flip_for_valence(context, next.mesh);
    smooth_all(context, next.mesh, quick_sweeps);
    next.shortfall = shortfall(context, next.mesh, goal);
    to.push_back(std::move(next));
    if (to.size() > 4 * keep) keep_best(to, keep);
  }
  keep_best(to, keep);
}

/// The movable vertices of each bad spot: a vertex with a bad valence, or the corners of a bad triangle.
std::vector<std::vector<Index>> bad_spots(const FinishContext& context, const EditableMesh& mesh,
                                          const ShapeGoal& goal) {
  const std::size_t triangles = mesh.half_edge_count() / 3;
  std::vector<std::uint8_t> bad(triangles, 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto t = static_cast<Index>(n);
      if (!mesh.triangle_alive(t)) continue;
      bool found = triangle_shortfall(mesh, mesh.triangle(t), goal) > 0.0;
      for (Index e = 3 * t; e < 3 * t + 3 && !found; ++e)
        found = is_first_of_edge(mesh, e) && edge_shortfall(context, mesh, e) > 0.0;
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

}  // namespace

double shortfall(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal) {
  double sum = 0.0;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (mesh.origin(e) == EditableMesh::none) continue;
    if (e % 3 == 0) sum += triangle_shortfall(mesh, mesh.triangle(e / 3), goal);
    if (is_first_of_edge(mesh, e)) sum += edge_shortfall(context, mesh, e);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.alive(v)) sum += valence_shortfall(mesh, v);
  }
  return sum;
}

Submesh extract_submesh(const EditableMesh& mesh, std::span<const Index> centres, int rings) {
  Submesh submesh;
  std::unordered_map<Index, Index> index_in_submesh;
  const auto add_vertex = [&](Index v) {
    const bool is_new = index_in_submesh.try_emplace(v, static_cast<Index>(submesh.vertices.size())).second;
    if (is_new) submesh.vertices.push_back(v);
  };
  for (const Index v : centres) add_vertex(v);
  std::size_t inner = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = submesh.vertices.size();
    for (std::size_t n = inner; n < end; ++n) {
      const Index v = submesh.vertices[n];
      if (!mesh.movable(v)) continue;
      Index e = mesh.out(v);
      do {
        submesh.triangles.push_back(e / 3);
        add_vertex(mesh.target(e));
        e = mesh.turn(e);
      } while (e != mesh.out(v));
    }
    inner = end;
    if (ring == 0) {
      for (Index n = 0; n < submesh.vertices.size(); ++n) submesh.core.push_back(n);
    }
  }
  std::sort(submesh.triangles.begin(), submesh.triangles.end());
  submesh.triangles.erase(std::unique(submesh.triangles.begin(), submesh.triangles.end()), submesh.triangles.end());
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  for (const Index v : submesh.vertices) {
    points.push_back(mesh.points[v]);
    normals.push_back(mesh.normals[v]);
  }
  std::vector<Triangle> triangles;
  for (const Index t : submesh.triangles) {
    const Triangle corners = mesh.triangle(t);
    triangles.push_back(
        {index_in_submesh.at(corners[0]), index_in_submesh.at(corners[1]), index_in_submesh.at(corners[2])});
  }
  submesh.mesh = EditableMesh(std::move(points), std::move(normals), triangles);
  for (Index n = 0; n < submesh.vertices.size(); ++n) submesh.mesh.set_valence(n, mesh.valence(submesh.vertices[n]));
  return submesh;
}

void put_back_submesh(EditableMesh& mesh, const Submesh& submesh) {
  std::vector<Index> index_in_mesh = submesh.vertices;
  for (Index n = 0; n < submesh.mesh.vertex_count(); ++n) {
    if (n >= index_in_mesh.size()) {
      index_in_mesh.push_back(mesh.add_vertex(submesh.mesh.points[n], submesh.mesh.normals[n]));
    } else if (submesh.mesh.movable(n)) {
      mesh.points[index_in_mesh[n]] = submesh.mesh.points[n];
      mesh.normals[index_in_mesh[n]] = submesh.mesh.normals[n];
    }
  }
  std::vector<Triangle> fresh;
  for (Index t = 0; 3 * t < submesh.mesh.half_edge_count(); ++t) {
    if (!submesh.mesh.triangle_alive(t)) continue;
    const Triangle corners = submesh.mesh.triangle(t);
    fresh.push_back({index_in_mesh[corners[0]], index_in_mesh[corners[1]], index_in_mesh[corners[2]]});
  }
  mesh.replace(submesh.triangles, fresh);
}

bool improve(const FinishContext& context, Submesh& submesh, const ShapeGoal& goal, const SearchEffort& search) {
  const double before = shortfall(context, submesh.mesh, goal);
  if (!(before > 0.0)) return false;
  State best{submesh.mesh, before};
  const auto smooth_and_compare = [&](State& state) {
    smooth_all(context, state.mesh, thorough_sweeps);
    state.shortfall = shortfall(context, state.mesh, goal);
    if (state.shortfall < best.shortfall) best = state;
  };
  std::vector<State> beam{{submesh.mesh, before}};
  smooth_and_compare(beam.front());
  const auto width = static_cast<std::size_t>(search.beam);
  for (int depth = 0; depth < search.depth && best.shortfall > 0.0; ++depth) {
    std::vector<State> next;
    for (const State& state : beam) expand(context, state, submesh.core, goal, next, width + 2);
    for (State& state : next) {
      smooth_and_compare(state);
      if (best.shortfall == 0.0) break;
    }
    keep_best(next, width);
    beam = std::move(next);
  }
  if (best.shortfall > 0.99 * before) return false;
  submesh.mesh = std::move(best.mesh);
  return true;
}

std::size_t improve_bad_spots(const FinishContext& context, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search) {
  std::vector<Submesh> submeshes;
  std::vector<std::uint8_t> taken(mesh.vertex_count(), 0);
  for (const auto& spot : bad_spots(context, mesh, goal)) {
    if (std::any_of(spot.begin(), spot.end(), [&](Index v) { return taken[v] != 0; })) continue;
    Submesh submesh = extract_submesh(mesh, spot, search.rings);
    if (std::any_of(submesh.vertices.begin(), submesh.vertices.end(), [&](Index v) { return taken[v] != 0; })) continue;
    for (const Index v : submesh.vertices) taken[v] = 1;
    submeshes.push_back(std::move(submesh));
  }
  std::vector<std::uint8_t> better(submeshes.size(), 0);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, submeshes.size(), 1),
      [&](const auto& range) {
        for (std::size_t n = range.begin(); n < range.end(); ++n)
          better[n] = improve(context, submeshes[n], goal, search) ? 1 : 0;
      },
      tbb::simple_partitioner());
  std::size_t improved = 0;
  for (std::size_t n = 0; n < submeshes.size(); ++n) {
    if (better[n] == 0) continue;
    put_back_submesh(mesh, submeshes[n]);
    ++improved;
  }
  return improved;
}

std::size_t count_bad_spots(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal) {
  return bad_spots(context, mesh, goal).size();
}

}  // namespace isobench::particles
