#include "isobench/methods/particles/mesh_edits/smoothing.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

// In units of the mean distance to the neighbours.
constexpr double at_rest = 5e-3;
constexpr double largest_move = 0.3;

}  // namespace

bool gather_ring(const EditableMesh& mesh, const std::vector<double>& areas, Index v, Ring& ring) {
  ring.area = areas[v];
  ring.size = 0;
  Index e = mesh.out(v);
  do {
    if (ring.size == Ring::most) return false;
    const Index to = mesh.target(e);
    ring.points[ring.size] = mesh.points[to];
    ring.normals[ring.size] = mesh.normals[to];
    ring.areas[ring.size] = areas[to];
    ++ring.size;
    e = mesh.turn(e);
  } while (e != mesh.out(v));
  ring.points[ring.size] = ring.points[0];
  ring.normals[ring.size] = ring.normals[0];
  ring.areas[ring.size] = ring.areas[0];
  return true;
}

double improve_vertex(const FinishContext& context, EditableMesh& mesh, const std::vector<double>& areas, Index v,
                      const ShapeEnergy& energy) {
  Ring ring;
  if (!gather_ring(mesh, areas, v, ring)) return 0.0;
  const Eigen::Vector3d x = mesh.points[v];
  const Eigen::Vector3d n = mesh.normals[v];
  const Eigen::Vector3d u = n.unitOrthogonal();
  const Eigen::Vector3d w = n.cross(u);
  const EnergyJet jet = shape_energy(energy, ring, x, u, w);
  Eigen::Vector2d step = newton_step(jet);
  double scale = 0.0;
  for (std::size_t k = 0; k < ring.size; ++k) scale += (ring.points[k] - x).norm();
  scale /= static_cast<double>(ring.size);
  double length = step.norm();
  if (!std::isfinite(length) || length < 1e-5 * scale) return 0.0;
  if (length > largest_move * scale) step *= largest_move * scale / length;

  const FanState before = fan_state(energy, ring, x, n);
  const double least = std::min(context.least_cosine_of_moves, before.least_cosine);
  for (int attempt = 0; attempt < 4; ++attempt, step *= 0.35) {
    Eigen::Vector3d to = (x + step[0] * u + step[1] * w).cwiseMax(0.0).cwiseMin(context.surface.extent());
    const Jet at = context.surface.value_gradient(to);
    const double slope = at.gradient.norm();
    const double off = slope > 0.0 ? at.value / slope : 0.0;
    if (!(slope > 0.0) || std::abs(off) > largest_move * scale) continue;
    to -= at.gradient * (off / slope);
    const Eigen::Vector3d normal = -at.gradient / slope;
    const FanState after = fan_state(energy, ring, to, normal);
    if (after.energy >= before.energy || after.least_cosine < least) continue;
    mesh.points[v] = to;
    mesh.normals[v] = normal;
    return (to - x).norm() / scale;
  }
  return 0.0;
}

std::vector<std::vector<Index>> colour(const EditableMesh& mesh) {
  std::vector<std::vector<Index>> classes;
  constexpr std::uint8_t unset = 255;
  std::vector<std::uint8_t> colour_of(mesh.vertex_count(), unset);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.movable(v)) continue;
    std::uint64_t taken = 0;
    Index e = mesh.out(v);
    do {
      const std::uint8_t other = colour_of[mesh.target(e)];
      if (other != unset) taken |= std::uint64_t{1} << other;
      e = mesh.turn(e);
    } while (e != mesh.out(v));
    std::uint8_t mine = 0;
    while (mine < 64 && (taken >> mine & 1U) != 0) ++mine;
    if (mine == 64) continue;  // neighbours have all 64 colours; the vertex stays where it is
    colour_of[v] = mine;
    if (classes.size() <= mine) classes.resize(mine + std::size_t{1});
    classes[mine].push_back(v);
  }
  return classes;
}

namespace {

/// Whether the vertex or a neighbour has moved in its last turn.
bool has_moved_nearby(const EditableMesh& mesh, const std::vector<std::uint8_t>& moved, Index v) {
  if (moved[v] != 0) return true;
  Index e = mesh.out(v);
  do {
    if (moved[mesh.target(e)] != 0) return true;
    e = mesh.turn(e);
  } while (e != mesh.out(v));
  return false;
}

}  // namespace

void smooth(const FinishContext& context, EditableMesh& mesh, const ShapeEnergy& energy, int sweeps) {
  const auto classes = colour(mesh);
  const std::vector<double> areas = context.areas.at_vertices(mesh);
  std::vector<std::uint8_t> moved(mesh.vertex_count(), 1);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const auto& independent : classes) {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, independent.size(), 256), [&](const auto& range) {
        for (std::size_t n = range.begin(); n < range.end(); ++n) {
          const Index v = independent[n];
          if (has_moved_nearby(mesh, moved, v))
            moved[v] = improve_vertex(context, mesh, areas, v, energy) > at_rest ? 1 : 0;
        }
      });
    }
  }
}

std::size_t smooth(const FinishContext& context, EditableMesh& mesh, const ShapeEnergy& energy, int sweeps,
                   std::span<const Index> vertices) {
  const std::vector<double> areas = context.areas.at_vertices(mesh);
  std::vector<std::uint8_t> moved(mesh.vertex_count(), 1);
  std::size_t tried = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::size_t moving = 0;
    for (const Index v : vertices) {
      if (!mesh.movable(v) || !has_moved_nearby(mesh, moved, v)) continue;
      moved[v] = improve_vertex(context, mesh, areas, v, energy) > at_rest ? 1 : 0;
      moving += moved[v];
      ++tried;
    }
    if (moving == 0) break;
  }
  return tried;
}

void project_all(const Isosurface& surface, EditableMesh& mesh) {
  std::vector<Index> all(mesh.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  project(surface, mesh, all);
}

void project(const Isosurface& surface, EditableMesh& mesh, std::span<const Index> vertices) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertices.size(), 512), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Index v = vertices[n];
      if (!mesh.movable(v)) continue;
      const auto foot = surface.project(mesh.points[v]);
      if (foot) mesh.points[v] = *foot;
    }
  });
}

}  // namespace isobench::particles
