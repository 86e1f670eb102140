// Particles on F = c, their neighbours and their energies.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/methods/particles/sampling/neighbours.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// Removes the items whose mark is not 0; the others keep their order. There is one mark per item.
template <class Item>
void erase_marked(std::vector<Item>& items, const std::vector<char>& marks) {
  std::size_t kept = 0;
  for (std::size_t n = 0; n < items.size(); ++n) {
    if (marks[n] == 0) items[kept++] = items[n];
  }
  items.resize(kept);
}

/// One entry per particle (lattice frame, mm).
struct Particles {
  std::vector<Eigen::Vector3d> points;   ///< on F = c
  std::vector<Eigen::Vector3d> normals;  ///< outward, unit
  std::vector<double> spacing;           ///< SizedSurface::spacing() at the particle

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

/// Particles at points on F = c.
Particles make_particles(const SizedSurface& sized, std::vector<Eigen::Vector3d> points);

/// Removes the particles that lie where one before them lies, because a triangulation has one point at one place.
/// Projections may end at the same point where derivatives are not those of the values (Kernel::catmull_rom).
void drop_doubles(Particles& particles);

/// Neighbours within the potential's reach, √3 times the spacing, enlarged by the share `extra`.
NeighbourLists acting_neighbours(const Particles& particles, double extra = 0.0);

/// The potential energy of each particle: the sum of E over its neighbours. Particles with opposed normals, which are
/// on another sheet of the surface, do not act on each other. `neighbours` covers at least the potential's reach.
std::vector<double> energies(const Particles& particles, const NeighbourLists& neighbours);

/// E between particles i and j: 0 beyond the potential's reach and where their normals are opposed.
double pair_energy(const Particles& particles, std::size_t i, std::size_t j);

}  // namespace isobench::particles
