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

constexpr double miss_at_all = 0.2;  // few misses count for more than small ones
constexpr ShapeEnergy tail_shape{2};
constexpr int quick_sweeps = 6;
constexpr int thorough_sweeps = 25;

double triangle_missed(const EditableMesh& mesh, const Triangle& t, const ShapeGoal& goal) {
  const double a = (mesh.points[t[1]] - mesh.points[t[2]]).norm();
  const double b = (mesh.points[t[2]] - mesh.points[t[0]]).norm();
  const double c = (mesh.points[t[0]] - mesh.points[t[1]]).norm();
  const double q = (b + c - a) * (c + a - b) * (a + b - c) / std::max(a * b * c, 1e-300);
  if (q > 0.9) return 0.0;  // no angle can then be outside 41° to 80°
  double low = std::min({a, b, c});
  double high = std::max({a, b, c});
  const double middle = a + b + c - low - high;
  const auto angle = [](double opposite, double left, double right) {
    const double cosine = (left * left + right * right - opposite * opposite) / std::max(2.0 * left * right, 1e-300);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  };
  const double miss = std::max({(goal.radius_ratio - q) / 0.05, (goal.least_angle - angle(low, middle, high)) / 5.0,
                                (angle(high, middle, low) - goal.largest_angle) / 5.0});
  return miss > 0.0 ? miss + miss_at_all : 0.0;
}

double valence_missed(const EditableMesh& mesh, Index v) {
  const double away = std::abs(static_cast<double>(mesh.valence(v)) - 6.0);
  return away > 1.0 ? away - 1.0 : 0.0;
}

double edge_missed(const MeshGround& ground, const EditableMesh& mesh, Index e) {
  if (ground.sizing.uniform()) return 0.0;
  const double over = edge_over_h0(ground, mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]) - 0.999;
  return over > 0.0 ? miss_at_all + 20.0 * over : 0.0;
}

bool once(const EditableMesh& mesh, Index e) {
  return mesh.origin(e) != EditableMesh::none && (mesh.twin(e) == EditableMesh::none || e < mesh.twin(e));
}

struct Change {
  enum class Kind { none, flip, collapse, split, divide } kind = Kind::none;
  Index at = EditableMesh::none;  ///< a half-edge, or a vertex to divide
};

/// A vertex of valence 4 or 8 may be mended by the next change; beyond, nothing good follows.
bool hopeful(const EditableMesh& mesh, std::initializer_list<std::pair<Index, int>> changes) {
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
  if (hopeful(mesh, {{a, -1}, {b, -1}, {c, 1}, {d, 1}}) && mesh.can_flip(e)) changes.push_back({Change::Kind::flip, e});
  if (hopeful(mesh, {{c, 1}, {d, 1}})) changes.push_back({Change::Kind::split, e});
  for (const Index from : {e, f}) {
    const int gained = static_cast<int>(mesh.valence(mesh.origin(from))) - 4;
    if (hopeful(mesh, {{mesh.target(from), gained}, {c, -1}, {d, -1}}) && mesh.can_collapse(from))
      changes.push_back({Change::Kind::collapse, from});
  }
}

std::vector<Change> possible_changes(const EditableMesh& mesh, std::span<const Index> core) {
  std::vector<Change> changes;
  std::vector<std::uint8_t> in_core(mesh.vertex_count(), 0);
  for (const Index v : core) in_core[v] = 1;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (once(mesh, e) && (in_core[mesh.origin(e)] != 0 || in_core[mesh.target(e)] != 0)) edge_changes(mesh, e, changes);
  }
  for (const Index v : core) {
    if (mesh.movable(v) && mesh.valence(v) >= 6) changes.push_back({Change::Kind::divide, v});
  }
  return changes;
}

bool make(const MeshGround& ground, EditableMesh& mesh, const Change& change) {
  constexpr double least_q = 0.05;  // smoothing follows
  switch (change.kind) {
    case Change::Kind::none:
      return true;
    case Change::Kind::flip:
      if (!flip_keeps_shape(ground, mesh, change.at, least_q)) return false;
      mesh.flip(change.at);
      return true;
    case Change::Kind::collapse:
      if (!collapse_keeps_shape(ground, mesh, change.at, least_q)) return false;
      mesh.collapse(change.at);
      return true;
    case Change::Kind::split:
      return split_in_the_middle(ground, mesh, change.at) != EditableMesh::none;
    case Change::Kind::divide:
      return divide(ground, mesh, change.at) != EditableMesh::none;
  }
  return false;
}

void smooth_all(const MeshGround& ground, EditableMesh& mesh, int sweeps) {
  std::vector<Index> all(mesh.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  smooth(ground, mesh, tail_shape, sweeps, all);
}

struct State {
  EditableMesh mesh;
  double missed = 0.0;
};

void keep_best(std::vector<State>& states, std::size_t count) {
  std::stable_sort(states.begin(), states.end(), [](const State& a, const State& b) { return a.missed < b.missed; });
  if (states.size() > count) states.resize(count);
}

/// All that one more change can make of a state, smoothed a little.
void expand(const MeshGround& ground, const State& from, std::span<const Index> core, const ShapeGoal& goal,
            std::vector<State>& to, std::size_t keep) {
  for (const Change& change : possible_changes(from.mesh, core)) {
    State next{from.mesh, 0.0};
    if (!make(ground, next.mesh, change)) continue;
    flip_for_valence(ground, next.mesh);
    smooth_all(ground, next.mesh, quick_sweeps);
    next.missed = missed(ground, next.mesh, goal);
    to.push_back(std::move(next));
    if (to.size() > 4 * keep) keep_best(to, keep);
  }
  keep_best(to, keep);
}

/// Vertices at which something is bad, each with what belongs to it.
std::vector<std::vector<Index>> bad_places(const MeshGround& ground, const EditableMesh& mesh, const ShapeGoal& goal) {
  const std::size_t triangles = mesh.half_edge_count() / 3;
  std::vector<std::uint8_t> bad(triangles, 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto t = static_cast<Index>(n);
      if (!mesh.triangle_alive(t)) continue;
      bool found = triangle_missed(mesh, mesh.triangle(t), goal) > 0.0;
      for (Index e = 3 * t; e < 3 * t + 3 && !found; ++e) found = once(mesh, e) && edge_missed(ground, mesh, e) > 0.0;
      bad[n] = found ? 1 : 0;
    }
  });
  std::vector<std::vector<Index>> places;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.movable(v) && valence_missed(mesh, v) > 0.0) places.push_back({v});
  }
  for (Index t = 0; t < triangles; ++t) {
    if (bad[t] == 0) continue;
    const Triangle corners = mesh.triangle(t);
    std::vector<Index> place;
    for (const Index v : corners) {
      if (mesh.movable(v)) place.push_back(v);
    }
    if (!place.empty()) places.push_back(std::move(place));
  }
  return places;
}

}  // namespace

double missed(const MeshGround& ground, const EditableMesh& mesh, const ShapeGoal& goal) {
  double sum = 0.0;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (mesh.origin(e) == EditableMesh::none) continue;
    if (e % 3 == 0) sum += triangle_missed(mesh, mesh.triangle(e / 3), goal);
    if (once(mesh, e)) sum += edge_missed(ground, mesh, e);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.alive(v)) sum += valence_missed(mesh, v);
  }
  return sum;
}

Submesh cut_out(const EditableMesh& mesh, std::span<const Index> centres, int rings) {
  Submesh patch;
  std::unordered_map<Index, Index> place;
  const auto reach = [&](Index v) {
    const auto [found, fresh] = place.try_emplace(v, static_cast<Index>(patch.vertices.size()));
    if (fresh) patch.vertices.push_back(v);
    return found->second;
  };
  for (const Index v : centres) reach(v);
  std::size_t inner = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = patch.vertices.size();
    for (std::size_t n = inner; n < end; ++n) {
      const Index v = patch.vertices[n];
      if (!mesh.movable(v)) continue;
      Index e = mesh.out(v);
      do {
        patch.triangles.push_back(e / 3);
        reach(mesh.target(e));
        e = mesh.turn(e);
      } while (e != mesh.out(v));
    }
    inner = end;
    if (ring == 0) {
      for (Index n = 0; n < patch.vertices.size(); ++n) patch.core.push_back(n);
    }
  }
  std::sort(patch.triangles.begin(), patch.triangles.end());
  patch.triangles.erase(std::unique(patch.triangles.begin(), patch.triangles.end()), patch.triangles.end());
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  for (const Index v : patch.vertices) {
    points.push_back(mesh.points[v]);
    normals.push_back(mesh.normals[v]);
  }
  std::vector<Triangle> triangles;
  for (const Index t : patch.triangles) {
    const Triangle corners = mesh.triangle(t);
    triangles.push_back({place.at(corners[0]), place.at(corners[1]), place.at(corners[2])});
  }
  patch.mesh = EditableMesh(std::move(points), std::move(normals), triangles);
  for (Index n = 0; n < patch.vertices.size(); ++n) patch.mesh.set_valence(n, mesh.valence(patch.vertices[n]));
  return patch;
}

void put_back(EditableMesh& mesh, const Submesh& patch) {
  std::vector<Index> place = patch.vertices;
  for (Index n = 0; n < patch.mesh.vertex_count(); ++n) {
    if (n >= place.size()) {
      place.push_back(mesh.add_vertex(patch.mesh.points[n], patch.mesh.normals[n]));
    } else if (patch.mesh.movable(n)) {
      mesh.points[place[n]] = patch.mesh.points[n];
      mesh.normals[place[n]] = patch.mesh.normals[n];
    }
  }
  std::vector<Triangle> fresh;
  for (Index t = 0; 3 * t < patch.mesh.half_edge_count(); ++t) {
    if (!patch.mesh.triangle_alive(t)) continue;
    const Triangle corners = patch.mesh.triangle(t);
    fresh.push_back({place[corners[0]], place[corners[1]], place[corners[2]]});
  }
  mesh.replace(patch.triangles, fresh);
}

bool improve(const MeshGround& ground, Submesh& patch, const ShapeGoal& goal, const SearchEffort& search) {
  const double before = missed(ground, patch.mesh, goal);
  if (!(before > 0.0)) return false;
  State best{patch.mesh, before};
  const auto take = [&](State& state) {
    smooth_all(ground, state.mesh, thorough_sweeps);
    state.missed = missed(ground, state.mesh, goal);
    if (state.missed < best.missed) best = state;
  };
  std::vector<State> beam{{patch.mesh, before}};
  take(beam.front());
  const auto width = static_cast<std::size_t>(search.beam);
  for (int depth = 0; depth < search.depth && best.missed > 0.0; ++depth) {
    std::vector<State> next;
    for (const State& state : beam) expand(ground, state, patch.core, goal, next, width + 2);
    for (State& state : next) {
      take(state);
      if (best.missed == 0.0) break;
    }
    keep_best(next, width);
    beam = std::move(next);
  }
  if (best.missed > 0.99 * before) return false;
  patch.mesh = std::move(best.mesh);
  return true;
}

std::size_t improve_bad_spots(const MeshGround& ground, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search) {
  std::vector<Submesh> patches;
  std::vector<std::uint8_t> taken(mesh.vertex_count(), 0);
  for (const auto& place : bad_places(ground, mesh, goal)) {
    if (std::any_of(place.begin(), place.end(), [&](Index v) { return taken[v] != 0; })) continue;
    Submesh patch = cut_out(mesh, place, search.rings);
    if (std::any_of(patch.vertices.begin(), patch.vertices.end(), [&](Index v) { return taken[v] != 0; })) continue;
    for (const Index v : patch.vertices) taken[v] = 1;
    patches.push_back(std::move(patch));
  }
  std::vector<std::uint8_t> better(patches.size(), 0);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, patches.size(), 1),
      [&](const auto& range) {
        for (std::size_t n = range.begin(); n < range.end(); ++n)
          better[n] = improve(ground, patches[n], goal, search) ? 1 : 0;
      },
      tbb::simple_partitioner());
  std::size_t improved = 0;
  for (std::size_t n = 0; n < patches.size(); ++n) {
    if (better[n] == 0) continue;
    put_back(mesh, patches[n]);
    ++improved;
  }
  return improved;
}

std::size_t count_bad_spots(const MeshGround& ground, const EditableMesh& mesh, const ShapeGoal& goal) {
  return bad_places(ground, mesh, goal).size();
}

}  // namespace isobench::particles
