// Moving particles on the surface to lower energy.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/particles/sampling/neighbours.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::particles {

/// Takes away the items whose mark is not 0; the others close ranks. One mark an item.
template <class Item>
void erase_marked(std::vector<Item>& items, const std::vector<char>& marks) {
  std::size_t kept = 0;
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (marks[n] == 0) items[kept++] = items[n];
  }
  items.resize(kept);
}

/// Particles on F = c, one entry each (lattice frame, mm).
struct Particles {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;  ///< outward, unit
  std::vector<double> spacing;           ///< h/g where the particle is

  std::size_t size() const { return points.size(); }
  void add(const Particles& other, std::size_t n) {
    points.push_back(other.points[n]);
    normals.push_back(other.normals[n]);
    spacing.push_back(other.spacing[n]);
  }
  void erase(const std::vector<char>& marks) {
    erase_marked(points, marks);
    erase_marked(normals, marks);
    erase_marked(spacing, marks);
  }
};

/// Particles at points of the surface.
Particles make_particles(const Isosurface& surface, const Spacing& spacing, std::vector<Eigen::Vector3d> points);

/// `sweeps` sweeps in which every particle takes one damped Newton step with momentum (the positive part of the pair
/// potential's Hessian, step ≤ 0.3 h) in its tangent plane and one Newton step back to F = c. All particles step from
/// the same positions (Jacobi), so the result does not depend on the number of threads. At the end all are projected to
/// 1e-6 voxel. Where `fixed` is given (one entry a particle), particles with an entry other than 0 act on others but
/// stay. Traces "energy", the mean a particle, once a sweep.
void relax(const Isosurface& surface, const Spacing& spacing, Particles& particles, int sweeps, Monitor& monitor,
           const std::vector<char>& fixed = {});

/// Neighbours within the potential's reach, √3 h, and `extra` times as much again.
NeighbourLists acting_neighbours(const Particles& particles, double extra = 0.0);

/// The energy of each particle; those whose normals are opposed (another sheet) do not act on it.
std::vector<double> energies(const Particles& particles, const NeighbourLists& neighbours);

/// What i and j have between them: 0 out of each other's reach or where their normals are opposed.
double pair_energy(const Particles& particles, std::size_t i, std::size_t j);

}  // namespace isobench::particles
