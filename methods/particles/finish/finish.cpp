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
#include "isobench/methods/particles/finish/easing/easing.h"
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

/// The least cosine of moves with a uniform sizing. There the surface may bend within the length of an edge, and
/// smoothing would move vertices away from tips of the surface. An adaptive sizing is fine enough at tips, and this
/// bound would be too strict at the sharpest ones; so it would be for the searches at single spots.
constexpr double least_cosine_uniform = 0.8;

/// What the searches try to reach first, with a part of the budget; angles in degrees. Projection to F = c, which
/// follows, changes angles by some hundredths.
ShapeGoal strict_goal(const SizingField& sizing) { return {sizing.uniform() ? 0.88 : 0.87, 40.1, 83.9}; }
constexpr double strict_share = 0.1;

/// What eased places must reach. With a uniform sizing there are few of them, and the others are better.
ShapeGoal eased_goal(const SizingField& sizing) {
  return sizing.uniform() ? ShapeGoal{0.895, 42.2, 81.8} : strict_goal(sizing);
}

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
    search_for(strict_goal(context_.sizing));
    budget_.moves += reserved;
    search_for(ShapeGoal{});
    monitor_.add("finish/searched moves", before - budget_.moves);
    monitor_.set("finish/places left", static_cast<double>(count_bad_spots(context_, mesh_, goal_)));
  }

 private:
  void search_for(const ShapeGoal& goal) {
    goal_ = goal;
    for (std::size_t n = 0; n < searches.size() && budget_.moves > 0.0; ++n) {
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

/// Takes away the pairs in which all corners are untouched: those are taken to have intersected before the finish.
void leave_out_untouched(const EditableMesh& edited, const std::vector<std::uint8_t>& untouched,
                         const TriangleMesh& finished, std::vector<TrianglePair>& pairs) {
  if (pairs.empty()) return;
  std::vector<std::uint8_t> is_untouched_vertex;
  for (EditableMesh::Index v = 0; v < edited.vertex_count(); ++v) {
    if (edited.alive(v)) is_untouched_vertex.push_back(v < untouched.size() ? untouched[v] : 0);
  }
  const auto is_untouched = [&](std::uint32_t triangle) {
    const Triangle& corners = finished.triangles[triangle];
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return is_untouched_vertex[c] != 0; });
  };
  std::erase_if(pairs, [&](const TrianglePair& pair) { return is_untouched(pair[0]) && is_untouched(pair[1]); });
}

/// The vertices of a mesh that are new, or not where they were.
std::vector<EditableMesh::Index> moved_vertices(const EditableMesh& before, const EditableMesh& after) {
  std::vector<EditableMesh::Index> moved;
  for (EditableMesh::Index v = 0; v < after.vertex_count(); ++v) {
    if (!after.alive(v)) continue;
    if (v >= before.vertex_count() || after.points[v] != before.points[v]) moved.push_back(v);
  }
  return moved;
}

/// Marks the triangles of after.triangle_mesh() that are new or have a corner that moved.
std::vector<std::uint8_t> changed_triangles(const EditableMesh& before, const EditableMesh& after) {
  std::vector<std::uint8_t> moved(after.vertex_count(), 0);
  for (const EditableMesh::Index v : moved_vertices(before, after)) moved[v] = 1;
  std::vector<std::uint8_t> changed;
  for (EditableMesh::Index t = 0; 3 * t < after.half_edge_count(); ++t) {
    if (!after.triangle_alive(t)) continue;
    const Triangle corners = after.triangle(t);
    const bool is_new = 3 * t >= before.half_edge_count() || before.triangle(t) != corners;
    const bool has_moved = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return moved[c] != 0; });
    changed.push_back(is_new || has_moved ? 1 : 0);
  }
  return changed;
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
  Finishing(const FinishContext& context, const SizedSurface& sized, const TriangleMesh& mesh,
            const FinishOptions& options, Monitor& monitor)
      : context_(context),
        sized_(sized),
        mesh_(mesh),
        options_(options),
        monitor_(monitor),
        untouched_(mesh.vertices.size(), 0) {}

  TriangleMesh run() {
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      EditableMesh edited = editable(context_.surface, mesh_);
      for (EditableMesh::Index v = 0; v < untouched_.size(); ++v) {
        if (untouched_[v] != 0) edited.fix(v);
      }
      improve_everywhere(context_, edited, options_.rounds, monitor_);
      project_all(context_.surface, edited);
      // Before the searches, too: they take most of the time if the mesh is bad.
      if (!is_free_of_new_intersections(edited, nullptr, attempt)) continue;
      const EditableMesh before = edited;
      improve_places(edited, std::exp2(-attempt));
      project(context_.surface, edited, moved_vertices(before, edited));
      if (is_free_of_new_intersections(edited, &before, attempt)) return edited.triangle_mesh();
    }
    return mesh_;
  }

 private:
  /// `share` is that of the usual budgets.
  void improve_places(EditableMesh& edited, double share) {
    constexpr double moves_per_vertex = 2.5;
    constexpr double least_moves = 1e5;
    FinishContext at_places = context_;
    at_places.least_cosine_of_moves = least_cosine;
    Tail(at_places, edited, share, monitor_).improve();
    const auto stage = monitor_.stage("easing");
    SearchBudget budget{options_.easing * share *
                        (least_moves + moves_per_vertex * static_cast<double>(edited.vertex_count()))};
    const std::size_t eased = ease_bounds(at_places, sized_, edited, eased_goal(context_.sizing), budget);
    monitor_.add("finish/bounds raised", static_cast<double>(eased));
  }

  /// If not, marks the vertices near the intersections as untouched. With `before`, a state without new intersections,
  /// only triangles that have changed since are checked.
  bool is_free_of_new_intersections(const EditableMesh& edited, const EditableMesh* before, int attempt) {
    const auto stage = monitor_.stage("intersections");
    const TriangleMesh finished = edited.triangle_mesh();
    std::vector<TrianglePair> intersections = before == nullptr
                                                  ? self_intersections(finished)
                                                  : self_intersections(finished, changed_triangles(*before, edited));
    leave_out_untouched(edited, untouched_, finished, intersections);
    if (intersections.empty()) return true;
    monitor_.add("finish/intersections rolled back", static_cast<double>(intersections.size()));
    std::set<std::uint32_t> triangles;
    for (const TrianglePair& pair : intersections) triangles.insert(pair.begin(), pair.end());
    for (const std::uint32_t triangle : triangles)
      mark_near(mesh_, finished, triangle, std::exp2(attempt) * longest_edge(finished, triangle), untouched_);
    return false;
  }

  const FinishContext context_;
  const SizedSurface& sized_;
  const TriangleMesh& mesh_;
  const FinishOptions options_;
  Monitor& monitor_;
  std::vector<std::uint8_t> untouched_;  // vertices of the given mesh that stay as they are
};

}  // namespace

TriangleMesh finish(const SizedSurface& sized, const TriangleMesh& mesh, const FinishOptions& options,
                    Monitor& monitor) {
  const SizingField& sizing = sized.field();
  const FinishContext context{sized.surface(), sizing, AskedAreas(sized, mesh),
                              finish_energies(sizing, options.area_weight),
                              sizing.uniform() ? least_cosine_uniform : least_cosine};
  return Finishing(context, sized, mesh, options, monitor).run();
}

}  // namespace isobench::particles
