#include "isobench/methods/particles/sampling/biased_population.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "isobench/methods/particles/sampling/energy.h"
#include "isobench/methods/particles/sampling/random.h"

namespace isobench::particles {

namespace {

constexpr double split_threshold = -0.35;
constexpr double delete_threshold = 0.75;
constexpr double least_distance = 0.5;  // of a new particle from any other, in units of h

/// U(0, 1) of each particle of this round.
class Bias {
 public:
  Bias(std::uint64_t seed, std::uint64_t round) : seed_(hash(seed) ^ round) {}
  double of(std::size_t i, double energy) const {
    return uniform(seed_, i, 0) * (energy - ideal_energy) / ideal_energy;
  }
  /// In [-1, 1), for the n-th jitter of a particle.
  double jitter(std::size_t i, std::uint64_t n) const { return 2.0 * uniform(seed_, i, 1 + n) - 1.0; }

 private:
  std::uint64_t seed_;
};

std::vector<char> choose_deleted(const Particles& particles, const NeighbourLists& near, std::vector<double> energy,
                                 const Bias& bias) {
  using Entry = std::pair<double, std::uint32_t>;
  // The largest bias first, of equal ones the first particle.
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
    if (now < value) {  // neighbours went in the meantime
      if (now > delete_threshold) queue.emplace(now, i);
      continue;
    }
    deleted[i] = 1;
    for (const std::uint32_t j : near.of(i)) energy[j] -= pair_energy(particles, i, j);
  }
  return deleted;
}

/// Where the children of particle i go, before anybody asks whether there is room.
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

/// Gives up the particles from `first` on that stand too near to one that stays. Returns how many stay.
std::size_t keep_apart(Particles& particles, std::size_t first) {
  std::vector<double> reach(particles.size());
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = least_distance * particles.spacing[i];
  const NeighbourLists near = find_neighbours(particles.points, reach);
  std::vector<char> gone(particles.size(), 0);
  for (std::size_t i = first; i < particles.size(); ++i) {
    const auto in_the_way = [&](std::uint32_t j) {
      return j < i && gone[j] == 0 && particles.normals[i].dot(particles.normals[j]) > 0.0;
    };
    const auto others = near.of(i);
    gone[i] = std::any_of(others.begin(), others.end(), in_the_way) ? 1 : 0;
  }
  particles.erase(gone);
  return particles.size() - first;
}

}  // namespace

PopulationChange control_population_by_bias(const Isosurface& surface, const Spacing& spacing, Particles& particles,
                                            std::uint64_t seed, std::uint64_t round) {
  const NeighbourLists near = acting_neighbours(particles);
  const std::vector<double> energy = energies(particles, near);
  const Bias bias(seed, round);
  const std::vector<char> deleted = choose_deleted(particles, near, energy, bias);
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> born;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (deleted[i] != 0) continue;
    points.push_back(particles.points[i]);
    if (energy[i] > 0.0 && bias.of(i, energy[i]) >= split_threshold) continue;
    for (const Eigen::Vector3d& child : children(surface, particles, ring(particles, near, i), i, bias)) {
      born.push_back(child);
    }
  }
  PopulationChange change;
  change.deleted = particles.size() - points.size();
  if (change.deleted == 0 && born.empty()) return change;
  const std::size_t parents = points.size();
  points.insert(points.end(), born.begin(), born.end());
  particles = make_particles(surface, spacing, std::move(points));
  change.split = keep_apart(particles, parents);
  return change;
}

}  // namespace isobench::particles
