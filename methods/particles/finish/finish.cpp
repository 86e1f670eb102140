#include "isobench/methods/particles/finish/finish.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "isobench/methods/mesh/self_intersections.h"
#include "isobench/methods/particles/finish/changes.h"
#include "isobench/methods/particles/finish/easing.h"
#include "isobench/methods/particles/finish/tail.h"
#include "isobench/methods/particles/mesh_edits/smoothing.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

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

/// The least cosine of moves with a uniform sizing. There the surface may bend within the length of an edge, and
/// smoothing would move vertices away from tips of the surface. An adaptive sizing is fine enough at tips, and this
/// bound would be too strict at the sharpest ones; so it would be for the searches at single spots.
constexpr double least_cosine_uniform = 0.8;

/// What eased places must reach. With a uniform sizing there are few of them, and the others are better.
ShapeGoal eased_goal(const SizingField& sizing) {
  return sizing.uniform() ? ShapeGoal{0.895, 42.2, 81.8} : strict_goal(sizing);
}

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
      FinishContext at_places = context_;
      at_places.least_cosine_of_moves = least_cosine;
      improve_tail(at_places, edited, std::exp2(-attempt), monitor_);
      project(context_.surface, edited, moved_vertices(before, edited));
      if (is_free_of_new_intersections(edited, &before, attempt))
        return eased(at_places, std::move(edited)).triangle_mesh();
    }
    return mesh_;
  }

 private:
  /// The mesh after easing. Where sheets would intersect, vertices stay as they are, and the easing is done again.
  EditableMesh eased(const FinishContext& context, EditableMesh mesh) {
    constexpr int attempts = 3;
    constexpr double moves_per_vertex = 2.5;
    constexpr double least_moves = 1e5;
    const auto stage = monitor_.stage("easing");
    const double moves = least_moves + moves_per_vertex * static_cast<double>(mesh.vertex_count());
    for (int attempt = 0; attempt < attempts && options_.easing > 0.0; ++attempt) {
      EditableMesh result = mesh;
      SearchBudget budget{options_.easing * moves};
      const std::size_t raised = ease_bounds(context, sized_, result, eased_goal(context_.sizing), budget);
      project(context_.surface, result, moved_vertices(mesh, result));
      const TriangleMesh finished = result.triangle_mesh();
      const std::vector<TrianglePair> intersections = new_intersections(result, &mesh, finished);
      if (intersections.empty()) {
        monitor_.add("finish/bounds raised", static_cast<double>(raised));
        return result;
      }
      for (const std::uint32_t v : points_near(mesh.points, finished, intersections, attempt)) mesh.fix(v);
    }
    return mesh;
  }

  /// With `before`, a state without new intersections, only triangles that have changed since are checked.
  std::vector<TrianglePair> new_intersections(const EditableMesh& edited, const EditableMesh* before,
                                              const TriangleMesh& finished) const {
    std::vector<TrianglePair> pairs = before == nullptr
                                          ? self_intersections(finished)
                                          : self_intersections(finished, changed_triangles(*before, edited));
    leave_out_untouched(edited, untouched_, finished, pairs);
    return pairs;
  }

  /// If not, marks the vertices near the intersections as untouched.
  bool is_free_of_new_intersections(const EditableMesh& edited, const EditableMesh* before, int attempt) {
    const auto stage = monitor_.stage("intersections");
    const TriangleMesh finished = edited.triangle_mesh();
    const std::vector<TrianglePair> intersections = new_intersections(edited, before, finished);
    if (intersections.empty()) return true;
    monitor_.add("finish/intersections rolled back", static_cast<double>(intersections.size()));
    for (const std::uint32_t v : points_near(mesh_.vertices, finished, intersections, attempt)) untouched_[v] = 1;
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
