#include "isobench/methods/particles/relaxation/population_control.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "isobench/methods/particles/relaxation/potential.h"

namespace isobench::particles {

std::vector<std::uint32_t> same_sheet_neighbours(const Particles& particles, const NeighbourLists& near,
                                                 std::size_t i) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t j : near.of(i)) {
    if (particles.normals[i].dot(particles.normals[j]) > 0.0) result.push_back(j);
  }
  return result;
}

Eigen::Vector3d widest_gap(const Particles& particles, const std::vector<std::uint32_t>& neighbours, std::size_t i) {
  const Eigen::Vector3d& n = particles.normals[i];
  Eigen::Vector3d u = n.unitOrthogonal();
  const Eigen::Vector3d v = n.cross(u);
  std::vector<double> angles;
  for (const std::uint32_t j : neighbours) {
    const Eigen::Vector3d to = particles.points[j] - particles.points[i];
    angles.push_back(std::atan2(v.dot(to), u.dot(to)));
  }
  if (angles.empty()) return u;
  std::sort(angles.begin(), angles.end());
  double middle = 0.0;
  double widest = -1.0;
  for (std::size_t a = 0; a < angles.size(); ++a) {
    const double next = a + 1 < angles.size() ? angles[a + 1] : angles[0] + 2.0 * std::numbers::pi;
    if (next - angles[a] > widest) {
      widest = next - angles[a];
      middle = angles[a] + 0.5 * widest;
    }
  }
  return std::cos(middle) * u + std::sin(middle) * v;
}

namespace {

bool crowded(const Eigen::Vector3d& x, double h, const Particles& particles,
             const std::vector<std::uint32_t>& neighbours) {
  return std::any_of(neighbours.begin(), neighbours.end(),
                     [&](std::uint32_t j) { return (particles.points[j] - x).norm() < 0.5 * h; });
}

/// Chooses particles with an energy above the limit, highest first, of which no two are neighbours.
std::vector<char> choose_deleted(const Particles& particles, const NeighbourLists& near,
                                 const std::vector<double>& energy, double limit, const std::vector<char>& fixed) {
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t i = 0; i < energy.size(); ++i) {
    if (energy[i] > limit && fixed[i] == 0) candidates.push_back(i);
  }
  std::sort(candidates.begin(), candidates.end(),
            [&](std::uint32_t a, std::uint32_t b) { return energy[a] != energy[b] ? energy[a] > energy[b] : a < b; });
  std::vector<char> deleted(particles.size(), 0);
  std::vector<char> beside_deleted(particles.size(), 0);
  for (const std::uint32_t i : candidates) {
    if (beside_deleted[i] != 0) continue;
    deleted[i] = 1;
    for (const std::uint32_t j : near.of(i)) beside_deleted[j] = 1;
  }
  return deleted;
}

}  // namespace

PopulationChange control_population(const SizedSurface& sized, Particles& particles, const PopulationLimits& limits,
                                    std::vector<char>* fixed) {
  const std::vector<char> is_fixed = fixed != nullptr ? *fixed : std::vector<char>(particles.size(), 0);
  const NeighbourLists near = acting_neighbours(particles);
  const std::vector<double> energy = energies(particles, near);
  const std::vector<char> deleted =
      choose_deleted(particles, near, energy, limits.delete_above * ideal_energy, is_fixed);
  std::vector<char> split_beside(particles.size(), 0);
  PopulationChange change;
  std::vector<Eigen::Vector3d> points;
  points.reserve(particles.size());
  std::vector<char> fixed_after;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (deleted[i] != 0) {
      ++change.deleted;
      continue;
    }
    points.push_back(particles.points[i]);
    fixed_after.push_back(is_fixed[i]);
    if (is_fixed[i] != 0) continue;
    // Two neighbouring particles at one gap would both fill it; only the first splits.
    if (energy[i] >= limits.split_below * ideal_energy || split_beside[i] != 0) continue;
    const std::vector<std::uint32_t> neighbours = same_sheet_neighbours(particles, near, i);
    const double h = particles.spacing[i];
    const auto child = sized.surface().project(particles.points[i] + h * widest_gap(particles, neighbours, i));
    if (!child || (*child - particles.points[i]).norm() < 0.5 * h || crowded(*child, h, particles, neighbours))
      continue;
    points.push_back(*child);
    fixed_after.push_back(0);
    ++change.split;
    for (const std::uint32_t j : neighbours) split_beside[j] = 1;
  }
  if (change.split + change.deleted > 0) particles = make_particles(sized, std::move(points));
  if (fixed != nullptr) *fixed = std::move(fixed_after);
  return change;
}

}  // namespace isobench::particles
