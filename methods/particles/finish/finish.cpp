#include "isobench/methods/particles/finish/finish.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "isobench/methods/mesh/self_intersections.h"
#include "isobench/methods/particles/finish/bad_spots.h"
#include "isobench/methods/particles/finish/smoothing.h"
#include "isobench/methods/particles/finish/valence_edits.h"

namespace isobench::particles {

namespace {

EditableMesh editable(const Isosurface& surface, const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size());
  tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t v) {
    normals[v] = outward_normal(surface.value_gradient(mesh.vertices[v]).gradient);
  });
  return {mesh.vertices, std::move(normals), mesh.triangles};
}

constexpr int sweeps_per_round = 2;
constexpr int last_sweeps = 4;

/// The searches become wider. The last ones are slow, but few spots are left for them.
constexpr std::array<SearchEffort, 10> searches{
    {{3, 1, 1}, {3, 1, 1}, {4, 2, 3}, {4, 2, 3}, {5, 3, 4}, {5, 3, 4}, {6, 4, 4}, {6, 4, 4}, {7, 6, 8}, {8, 8, 12}}};

/// What the narrower searches try to reach first. Wide searches for it would take more time than it is worth.
ShapeGoal strict_goal(const SizingField& sizing) { return {sizing.uniform() ? 0.88 : 0.87, 40.0, 84.0}; }
constexpr std::size_t strict_searches = 6;
constexpr double strict_share = 0.1;  // of the budget, at most

/// The local searches at bad spots. Where edges are long against the features, bad spots crowd, and wide searches at
/// all of them would take minutes. The budget bounds what is spent; other meshes need a small part of it.
class Tail {
 public:
  Tail(const FinishContext& context, EditableMesh& mesh, double share, Monitor& monitor)
      : context_(context), mesh_(mesh), monitor_(monitor) {
    constexpr double moves_per_vertex = 1000.0;
    constexpr double least_moves = 2e6;
    budget_.moves = share * (least_moves + moves_per_vertex * static_cast<double>(mesh.vertex_count()));
  }

  void improve() {
    const auto stage = monitor_.stage("tail");
    const double before = budget_.moves;
    const double reserved = (1.0 - strict_share) * before;
    budget_.moves -= reserved;
    search_for(strict_goal(context_.sizing), strict_searches);
    budget_.moves += reserved;
    search_for(ShapeGoal{}, searches.size());
    monitor_.add("finish/searched moves", before - budget_.moves);
    monitor_.set("finish/places left", static_cast<double>(count_bad_spots(context_, mesh_, goal_)));
  }

 private:
  void search_for(const ShapeGoal& goal, std::size_t count) {
    goal_ = goal;
    for (std::size_t n = 0; n < count && budget_.moves > 0.0; ++n) {
      if (count_bad_spots(context_, mesh_, goal_) == 0) return;
      if (n > 0 && searches[n].rings > searches[n - 1].rings) repeat_while_dear(searches[n - 1], searches[n]);
      search(searches[n]);
    }
  }

  /// A search may spend half of the budget, so that something is left for wider searches at the worst spots.
  std::size_t search(const SearchEffort& effort) {
    monitor_.check();
    SearchBudget half{0.5 * budget_.moves};
    budget_.moves -= half.moves;
    const std::size_t improved = improve_bad_spots(context_, mesh_, goal_, effort, half);
    budget_.moves += half.moves;
    monitor_.trace("finish/places improved", static_cast<double>(improved));
    return improved;
  }

  /// Crowded spots are treated one after another, because their submeshes overlap. The narrower search mends many of
  /// them at a small part of the cost.
  void repeat_while_dear(const SearchEffort& effort, const SearchEffort& wider) {
    constexpr int most_repeats = 20;
    for (int repeat = 0; repeat < most_repeats; ++repeat) {
      if (expected_moves(context_, mesh_, goal_, wider) <= 0.25 * budget_.moves) return;
      if (search(effort) == 0) return;
    }
  }

  const FinishContext& context_;
  EditableMesh& mesh_;
  Monitor& monitor_;
  ShapeGoal goal_;
  SearchBudget budget_;
};

void improve_everywhere(const FinishContext& context, EditableMesh& edited, int rounds, Monitor& monitor) {
  for (int round = 0; round < rounds; ++round) {
    monitor.progress(static_cast<double>(round) / static_cast<double>(rounds + 2));
    {
      const auto stage = monitor.stage("connectivity");
      monitor.add("finish/collapsed", static_cast<double>(collapse_low_valence(context, edited)));
      monitor.add("finish/divided", static_cast<double>(split_high_valence(context, edited)));
      monitor.add("finish/flipped", static_cast<double>(flip_for_valence(context, edited)));
    }
    const auto stage = monitor.stage("shape");
    smooth(context, edited, context.energies.rounds, sweeps_per_round);
  }
  const auto stage = monitor.stage("shape");
  smooth(context, edited, context.energies.rounds, last_sweeps);
  monitor.add("finish/flipped", static_cast<double>(flip_for_shape(context, edited)));
  smooth(context, edited, context.energies.last, last_sweeps);
}

using TrianglePair = std::array<std::uint32_t, 2>;

/// The intersecting pairs of triangles, without pairs in which all corners are untouched: those are taken to have
/// intersected before the finish.
std::vector<TrianglePair> new_intersections(const EditableMesh& edited, const std::vector<std::uint8_t>& untouched,
                                            const TriangleMesh& finished) {
  std::vector<TrianglePair> pairs = self_intersections(finished);
  if (pairs.empty()) return pairs;
  std::vector<std::uint8_t> is_untouched_vertex;
  for (EditableMesh::Index v = 0; v < edited.vertex_count(); ++v) {
    if (edited.alive(v)) is_untouched_vertex.push_back(v < untouched.size() ? untouched[v] : 0);
  }
  const auto is_untouched = [&](std::uint32_t triangle) {
    const Triangle& corners = finished.triangles[triangle];
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return is_untouched_vertex[c] != 0; });
  };
  std::erase_if(pairs, [&](const TrianglePair& pair) { return is_untouched(pair[0]) && is_untouched(pair[1]); });
  return pairs;
}

/// Marks the vertices of `mesh` within `reach` of the bounding box of a triangle of `other`.
void mark_near(const TriangleMesh& mesh, const TriangleMesh& other, std::uint32_t triangle, double reach,
               std::vector<std::uint8_t>& marks) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t corner : other.triangles[triangle]) box.extend(other.vertices[corner]);
  for (std::size_t v = 0; v < marks.size(); ++v) {
    if (box.squaredExteriorDistance(mesh.vertices[v]) <= reach * reach) marks[v] = 1;
  }
}

double longest_edge(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const auto length = [&](std::uint32_t u, std::uint32_t v) { return (mesh.vertices[u] - mesh.vertices[v]).norm(); };
  return std::max({length(a, b), length(b, c), length(c, a)});
}

/// The finish of one mesh. Attempts that end with new intersections are repeated from the start.
class Finishing {
 public:
  Finishing(const FinishContext& context, const TriangleMesh& mesh, int rounds, Monitor& monitor)
      : context_(context), mesh_(mesh), rounds_(rounds), monitor_(monitor), untouched_(mesh.vertices.size(), 0) {}

  TriangleMesh run() {
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      EditableMesh edited = editable(context_.surface, mesh_);
      for (EditableMesh::Index v = 0; v < untouched_.size(); ++v) {
        if (untouched_[v] != 0) edited.fix(v);
      }
      improve_everywhere(context_, edited, rounds_, monitor_);
      // Before the tail, too: it takes most of the time if the mesh is bad.
      if (!is_free_of_new_intersections(edited, edited.triangle_mesh(), attempt)) continue;
      Tail(context_, edited, std::exp2(-attempt), monitor_).improve();
      project_all(context_.surface, edited);
      TriangleMesh finished = edited.triangle_mesh();
      if (is_free_of_new_intersections(edited, finished, attempt)) return finished;
    }
    return mesh_;
  }

 private:
  /// If not, marks the vertices near the intersections as untouched.
  bool is_free_of_new_intersections(const EditableMesh& edited, const TriangleMesh& finished, int attempt) {
    const auto stage = monitor_.stage("intersections");
    const std::vector<TrianglePair> intersections = new_intersections(edited, untouched_, finished);
    if (intersections.empty()) return true;
    monitor_.add("finish/intersections rolled back", static_cast<double>(intersections.size()));
    std::set<std::uint32_t> triangles;
    for (const TrianglePair& pair : intersections) triangles.insert(pair.begin(), pair.end());
    for (const std::uint32_t triangle : triangles)
      mark_near(mesh_, finished, triangle, std::exp2(attempt) * longest_edge(finished, triangle), untouched_);
    return false;
  }

  const FinishContext context_;
  const TriangleMesh& mesh_;
  const int rounds_;
  Monitor& monitor_;
  std::vector<std::uint8_t> untouched_;  // vertices of the given mesh that stay as they are
};

}  // namespace

TriangleMesh finish(const SizedSurface& sized, const TriangleMesh& mesh, const FinishOptions& options,
                    Monitor& monitor) {
  const SizingField& sizing = sized.field();
  const FinishContext context{sized.surface(), sizing, AskedAreas(sized, mesh),
                              finish_energies(sizing, options.area_weight)};
  return Finishing(context, mesh, options.rounds, monitor).run();
}

}  // namespace isobench::particles
