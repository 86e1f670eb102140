#include "isobench/methods/particles/relaxation/particles.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/methods/particles/relaxation/pair_forces.h"
#include "isobench/methods/particles/relaxation/potential.h"

namespace isobench::particles {

PairForces forces_on(const Particles& particles, const NeighbourLists& near, std::size_t i) {
  const PotentialTable& potential = PotentialTable::instance();
  PairForces forces;
  for (const std::uint32_t j : near.of(i)) {
    const Eigen::Vector3d apart = particles.points[i] - particles.points[j];
    const double scale = beta / std::min(particles.spacing[i], particles.spacing[j]);
    const double square = apart.squaredNorm() * scale * scale;
    if (square >= 1.0 || particles.normals[i].dot(particles.normals[j]) <= 0.0) continue;
    const double d = std::sqrt(square);
    const PotentialTable::Entry entry = potential.at(d);
    forces.gradient += apart * (beta * beta * entry.derivative / std::max(d, 1e-6));
    forces.stiffness += beta * beta * entry.stiffness;
    forces.energy += entry.energy;
  }
  return forces;
}

Particles make_particles(const SizedSurface& sized, std::vector<Eigen::Vector3d> points) {
  Particles particles;
  particles.points = std::move(points);
  particles.normals.resize(particles.points.size());
  particles.spacing.resize(particles.points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      particles.normals[n] = outward_normal(sized.surface().value_gradient(particles.points[n]).gradient);
      particles.spacing[n] = sized.spacing(particles.points[n]);
    }
  });
  return particles;
}

void drop_doubles(Particles& particles) {
  const auto comes_before = [&](std::size_t a, std::size_t b) {
    const Eigen::Vector3d& x = particles.points[a];
    const Eigen::Vector3d& y = particles.points[b];
    return std::lexicographical_compare(x.data(), x.data() + 3, y.data(), y.data() + 3);
  };
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), comes_before);
  std::vector<char> is_double(particles.size(), 0);
  for (std::size_t n = 1; n < order.size(); ++n) is_double[order[n]] = comes_before(order[n - 1], order[n]) ? 0 : 1;
  particles.erase(is_double);
}

NeighbourLists acting_neighbours(const Particles& particles, double extra) {
  std::vector<double> reach(particles.size());
  for (std::size_t n = 0; n < reach.size(); ++n) reach[n] = particles.spacing[n] / beta * (1.0 + extra);
  return find_neighbours(particles.points, reach);
}

std::vector<double> energies(const Particles& particles, const NeighbourLists& neighbours) {
  std::vector<double> result(particles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) result[n] = forces_on(particles, neighbours, n).energy;
  });
  return result;
}

double pair_energy(const Particles& particles, std::size_t i, std::size_t j) {
  const double distance = (particles.points[i] - particles.points[j]).norm();
  const double d = beta * distance / std::min(particles.spacing[i], particles.spacing[j]);
  if (d >= 1.0 || particles.normals[i].dot(particles.normals[j]) <= 0.0) return 0.0;
  return PotentialTable::instance().at(d).energy;
}

}  // namespace isobench::particles
