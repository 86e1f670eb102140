#include "methods/particles/finish.h"

#include <tbb/parallel_for.h>

#include <array>

#include "methods/particles/patch.h"
#include "methods/particles/smoothing.h"
#include "methods/particles/valence_edits.h"

namespace isobench::particles {

namespace {

EditableMesh editable(const Isosurface& surface, const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size());
  tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t v) {
    normals[v] = outward_normal(surface.value_gradient(mesh.vertices[v]).gradient);
  });
  return {mesh.vertices, std::move(normals), mesh.triangles};
}

constexpr ShapeEnergy average_shape{0};
constexpr int sweeps_a_round = 2;
constexpr int last_sweeps = 4;

/// Searches wider where narrower did not help: the last ones are dear, but there is hardly ever a place left for them.
constexpr std::array<PatchSearch, 10> searches{
    {{3, 1, 1}, {3, 1, 1}, {4, 2, 3}, {4, 2, 3}, {5, 3, 4}, {5, 3, 4}, {6, 4, 4}, {6, 4, 4}, {7, 6, 8}, {8, 8, 12}}};

void improve_tail(const MeshGround& ground, EditableMesh& mesh, Monitor& monitor) {
  for (const PatchSearch& search : searches) {
    monitor.check();
    const std::size_t improved = improve_bad_places(ground, mesh, ShapeGoal{}, search);
    monitor.trace("finish/places improved", static_cast<double>(improved));
  }
  monitor.set("finish/places left", static_cast<double>(count_bad_places(ground, mesh, ShapeGoal{})));
}

}  // namespace

TriangleMesh finish(const Isosurface& surface, const SizingField& sizing, const TriangleMesh& mesh, int rounds,
                    Monitor& monitor) {
  const MeshGround ground{surface, sizing};
  EditableMesh edited = editable(surface, mesh);
  for (int round = 0; round < rounds; ++round) {
    monitor.progress(static_cast<double>(round) / static_cast<double>(rounds + 2));
    {
      const auto stage = monitor.stage("connectivity");
      monitor.add("finish/collapsed", static_cast<double>(collapse_low_valence(ground, edited)));
      monitor.add("finish/divided", static_cast<double>(split_high_valence(ground, edited)));
      monitor.add("finish/flipped", static_cast<double>(flip_for_valence(ground, edited)));
    }
    const auto stage = monitor.stage("shape");
    smooth(ground, edited, average_shape, sweeps_a_round);
  }
  {
    const auto stage = monitor.stage("shape");
    smooth(ground, edited, average_shape, last_sweeps);
    monitor.add("finish/flipped", static_cast<double>(flip_for_shape(ground, edited)));
    smooth(ground, edited, ShapeEnergy{1}, last_sweeps);
  }
  {
    const auto stage = monitor.stage("tail");
    improve_tail(ground, edited, monitor);
  }
  project_all(surface, edited);
  return edited.triangle_mesh();
}

}  // namespace isobench::particles
