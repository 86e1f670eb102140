#include "isobench/methods/particles/sampling/relaxation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "isobench/methods/particles/sampling/energy.h"

namespace isobench::particles {

namespace {

// Momentum is what lets the packing's faults wander and meet: with 0.8, forty sweeps come to more valences of 6 than
// eighty with 0.6 and half the step. With longer steps than Newton's, or more momentum, the particles keep swinging.
constexpr double momentum = 0.8;
constexpr double damping = 1.0;       // of the Newton step
constexpr double largest_step = 0.3;  // in units of h
constexpr double skin = 0.2;          // lists reach this much farther than the potential, so that they last some sweeps
constexpr double stray_share = 0.01;  // lists are made anew when this share of particles has used up half the skin

/// Gradient and stiffness of Σ h² E(d), h the smaller of a pair. The weight h² makes the force along a line the same
/// wherever particles are packed alike: without it fine regions push particles into coarse ones, and the packing drifts
/// away from the sizing for as long as one relaxes.
struct Pull {
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double stiffness = 0.0;
  double energy = 0.0;
};

Pull pull_on(const Particles& particles, const NeighbourLists& near, std::size_t i) {
  const PotentialTable& potential = PotentialTable::instance();
  Pull pull;
  for (const std::uint32_t j : near.of(i)) {
    const Eigen::Vector3d apart = particles.points[i] - particles.points[j];
    const double scale = beta / std::min(particles.spacing[i], particles.spacing[j]);
    const double square = apart.squaredNorm() * scale * scale;
    if (square >= 1.0 || particles.normals[i].dot(particles.normals[j]) <= 0.0) continue;
    const double d = std::sqrt(square);
    const PotentialTable::Entry entry = potential.at(d);
    pull.gradient += apart * (beta * beta * entry.first / std::max(d, 1e-6));
    pull.stiffness += beta * beta * entry.stiffness;
    pull.energy += entry.energy;
  }
  return pull;
}

class Relaxation {
 public:
  Relaxation(const Isosurface& surface, const Spacing& spacing, Particles& particles, const std::vector<char>& fixed)
      : surface_(surface), spacing_(spacing), fixed_(fixed), now_(particles), next_(particles) {
    velocity_.assign(particles.size(), Eigen::Vector3d::Zero());
    energy_.assign(particles.size(), 0.0);
  }

  /// The mean energy before the sweep.
  double sweep() {
    // A stray misses at worst pairs near d = 1, where the potential and its slope vanish, until the lists are made
    // anew.
    if (anchor_.empty() || static_cast<double>(strays_) > stray_share * static_cast<double>(now_.size())) {
      near_ = acting_neighbours(now_, skin);
      anchor_ = now_.points;
    }
    using Range = tbb::blocked_range<std::size_t>;
    // A count is the same in any order.
    strays_ = tbb::parallel_reduce(
        Range(0, now_.size(), 512), std::size_t{0},
        [&](const Range& range, std::size_t count) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (!fixed_.empty() && fixed_[i] != 0) continue;  // where it is in both
            step(i);
            const double away = (next_.points[i] - anchor_[i]).norm();
            count += away > 0.5 * skin / beta * next_.spacing[i] ? 1 : 0;
          }
          return count;
        },
        std::plus<>());
    std::swap(now_.points, next_.points);
    std::swap(now_.normals, next_.normals);
    std::swap(now_.spacing, next_.spacing);
    double sum = 0.0;
    for (const double e : energy_) sum += e;
    return sum / static_cast<double>(energy_.size());
  }

 private:
  /// Moves particle i from now_ to next_.
  void step(std::size_t i) {
    const Eigen::Vector3d& x = now_.points[i];
    const Eigen::Vector3d& n = now_.normals[i];
    const double h = now_.spacing[i];
    const Pull pull = pull_on(now_, near_, i);
    energy_[i] = pull.energy;
    // A particle with hardly any neighbour has no curvature to divide by; the ideal packing's is the scale.
    const double stiffness = std::max(pull.stiffness, 1.0);
    Eigen::Vector3d move = momentum * velocity_[i] - damping / stiffness * pull.gradient;
    move -= n * n.dot(move);
    const double length = move.norm();
    if (length > largest_step * h) move *= largest_step * h / length;

    Eigen::Vector3d to = (x + move).cwiseMax(0.0).cwiseMin(surface_.extent());
    const Jet jet = surface_.value_gradient(to);
    const double slope = jet.gradient.norm();
    const double off = slope > 0.0 ? jet.value / slope : 0.0;
    // Where F bends more than the step allows, or its gradient fades, the particle waits for its neighbours.
    if (!(slope > 0.0) || std::abs(off) > 0.5 * h) {
      velocity_[i].setZero();
      next_.points[i] = x;
      next_.normals[i] = n;
      next_.spacing[i] = h;
      return;
    }
    to -= jet.gradient * (off / slope);
    velocity_[i] = to - x;
    next_.points[i] = to;
    next_.normals[i] = outward_normal(jet.gradient);
    next_.spacing[i] = spacing_(to);
  }

  const Isosurface& surface_;
  const Spacing& spacing_;
  const std::vector<char>& fixed_;
  Particles& now_;
  Particles next_;
  NeighbourLists near_;
  std::vector<Eigen::Vector3d> velocity_;
  std::vector<double> energy_;
  std::vector<Eigen::Vector3d> anchor_;  // where the particles were when the lists were made
  std::size_t strays_ = 0;
};

}  // namespace

Particles make_particles(const Isosurface& surface, const Spacing& spacing, std::vector<Eigen::Vector3d> points) {
  Particles particles;
  particles.points = std::move(points);
  particles.normals.resize(particles.points.size());
  particles.spacing.resize(particles.points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      particles.normals[n] = outward_normal(surface.value_gradient(particles.points[n]).gradient);
      particles.spacing[n] = spacing(particles.points[n]);
    }
  });
  return particles;
}

NeighbourLists acting_neighbours(const Particles& particles, double extra) {
  std::vector<double> reach(particles.size());
  for (std::size_t n = 0; n < reach.size(); ++n) reach[n] = particles.spacing[n] / beta * (1.0 + extra);
  return find_neighbours(particles.points, reach);
}

std::vector<double> energies(const Particles& particles, const NeighbourLists& neighbours) {
  std::vector<double> result(particles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) result[n] = pull_on(particles, neighbours, n).energy;
  });
  return result;
}

double pair_energy(const Particles& particles, std::size_t i, std::size_t j) {
  const double distance = (particles.points[i] - particles.points[j]).norm();
  const double d = beta * distance / std::min(particles.spacing[i], particles.spacing[j]);
  if (d >= 1.0 || particles.normals[i].dot(particles.normals[j]) <= 0.0) return 0.0;
  return PotentialTable::instance().at(d).energy;
}

void relax(const Isosurface& surface, const Spacing& spacing, Particles& particles, int sweeps, Monitor& monitor,
           const std::vector<char>& fixed) {
  Relaxation relaxation(surface, spacing, particles, fixed);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    monitor.progress(static_cast<double>(sweep) / static_cast<double>(sweeps));
    monitor.trace("energy", relaxation.sweep());
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      if (!fixed.empty() && fixed[n] != 0) continue;
      const auto foot = surface.project(particles.points[n]);
      if (foot) particles.points[n] = *foot;
    }
  });
}

}  // namespace isobench::particles
