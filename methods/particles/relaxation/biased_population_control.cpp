#include "isobench/methods/particles/relaxation/biased_population_control.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "isobench/foundation/random.h"
#include "isobench/methods/particles/relaxation/potential.h"

namespace isobench::particles {

namespace {

constexpr double split_threshold = -0.35;
constexpr double delete_threshold = 0.75;
constexpr double least_distance = 0.5;  // from a new particle to any other, times the spacing

/// The random numbers of one round.
class Bias {
 public:
  Bias(std::uint64_t seed, std::uint64_t round) : seed_(split_mix_64(seed) ^ round) {}
  /// U(0, 1) · (E − E_ideal)/E_ideal of particle i.
  double of(std::size_t i, double energy) const {
    return uniform_random(seed_, i, 0) * (energy - ideal_energy) / ideal_energy;
  }
  /// The n-th number of particle i for its jitter, in [−1, 1).
  double jitter(std::size_t i, std::uint64_t n) const { return 2.0 * uniform_random(seed_, i, 1 + n) - 1.0; }

 private:
  std::uint64_t seed_;
};

std::vector<char> choose_deleted(const Particles& particles, const NeighbourLists& near, std::vector<double> energy,
                                 const Bias& bias) {
  using Entry = std::pair<double, std::uint32_t>;
  // Largest bias first; among equal ones the particle with the lower index first.
  const auto later = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  for (std::uint32_t i = 0; i < particles.size(); ++i) {
    const double own = bias.of(i, energy[i]);
    if (own > delete_threshold) queue.emplace(own, i);
  }
  std::vector<char> deleted(particles.size(), 0);
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    const double now = bias.of(i, energy[i]);
    if (now < value) {  // neighbours have been deleted in the meantime
      if (now > delete_threshold) queue.emplace(now, i);
      continue;
    }
    deleted[i] = 1;
    for (const std::uint32_t j : near.of(i)) energy[j] -= pair_energy(particles, i, j);
  }
  return deleted;
}

/// The positions of the children of particle i, whether or not there is room for them.
std::vector<Eigen::Vector3d> children(const Isosurface& surface, const Particles& particles,
                                      const std::vector<std::uint32_t>& neighbours, std::size_t i, const Bias& bias) {
  const Eigen::Vector3d& n = particles.normals[i];
  const Eigen::Vector3d gap = widest_gap(particles, neighbours, i);
  const int count = neighbours.empty() ? 3 : 1;
  std::vector<Eigen::Vector3d> result;
  for (int c = 0; c < count; ++c) {
    const auto draw = static_cast<std::uint64_t>(c);
    const double turn = 2.0 * std::numbers::pi * c / count + std::numbers::pi / 12.0 * bias.jitter(i, 2 * draw);
    const double distance = particles.spacing[i] * (1.0 + 0.1 * bias.jitter(i, 2 * draw + 1));
    const auto child =
        surface.project(particles.points[i] + distance * (std::cos(turn) * gap + std::sin(turn) * n.cross(gap)));
    if (child) result.push_back(*child);
  }
  return result;
}

/// Removes particles with an index of at least `first` that are too near to a particle with a lower index that stays.
/// Returns how many of them stay.
std::size_t remove_crowded(Particles& particles, std::size_t first) {
  std::vector<double> reach(particles.size());
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = least_distance * particles.spacing[i];
  const NeighbourLists near = find_neighbours(particles.points, reach);
  std::vector<char> removed(particles.size(), 0);
  for (std::size_t i = first; i < particles.size(); ++i) {
    const auto is_too_near = [&](std::uint32_t j) {
      return j < i && removed[j] == 0 && particles.normals[i].dot(particles.normals[j]) > 0.0;
    };
    const auto others = near.of(i);
    removed[i] = std::any_of(others.begin(), others.end(), is_too_near) ? 1 : 0;
  }
  particles.erase(removed);
  return particles.size() - first;
}

}  // namespace

PopulationChange control_population_by_bias(const SizedSurface& sized, Particles& particles, std::uint64_t seed,
                                            std::uint64_t round) {
  const NeighbourLists near = acting_neighbours(particles);
  const std::vector<double> energy = energies(particles, near);
  const Bias bias(seed, round);
  const std::vector<char> deleted = choose_deleted(particles, near, energy, bias);
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> added;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (deleted[i] != 0) continue;
    points.push_back(particles.points[i]);
    if (energy[i] > 0.0 && bias.of(i, energy[i]) >= split_threshold) continue;
    for (const Eigen::Vector3d& child :
         children(sized.surface(), particles, same_sheet_neighbours(particles, near, i), i, bias)) {
      added.push_back(child);
    }
  }
  PopulationChange change;
  change.deleted = particles.size() - points.size();
  if (change.deleted == 0 && added.empty()) return change;
  const std::size_t parents = points.size();
  points.insert(points.end(), added.begin(), added.end());
  particles = make_particles(sized, std::move(points));
  change.split = remove_crowded(particles, parents);
  return change;
}

}  // namespace isobench::particles
