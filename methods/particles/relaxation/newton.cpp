#include "isobench/methods/particles/relaxation/newton.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "isobench/methods/particles/relaxation/pair_forces.h"
#include "isobench/methods/particles/relaxation/potential.h"

namespace isobench::particles {

namespace {

// Momentum lets defects of the packing move until they meet and heal. Forty sweeps with 0.8 give more vertices of
// valence 6 than eighty with 0.6 and half the step. With more momentum or longer steps the particles keep oscillating.
constexpr double momentum = 0.8;
constexpr double damping = 1.0;       // factor on the Newton step
constexpr double largest_step = 0.3;  // times the spacing
constexpr double skin = 0.2;          // share by which neighbour lists reach beyond the potential, to last some sweeps
constexpr double stray_share = 0.01;  // lists are made anew when this share of particles has moved by half the skin

class NewtonRelaxation {
 public:
  NewtonRelaxation(const SizedSurface& sized, Particles& particles, const std::vector<char>& fixed)
      : sized_(sized), fixed_(fixed), now_(particles), next_(particles) {
    velocity_.assign(particles.size(), Eigen::Vector3d::Zero());
    energy_.assign(particles.size(), 0.0);
  }

  /// Returns the mean energy before the sweep; a fixed particle counts as 0.
  double sweep() {
    // Old lists miss at worst pairs near d = 1, where the potential and its derivative vanish.
    if (anchor_.empty() || static_cast<double>(strays_) > stray_share * static_cast<double>(now_.size())) {
      near_ = acting_neighbours(now_, skin);
      anchor_ = now_.points;
    }
    using Range = tbb::blocked_range<std::size_t>;
    strays_ = tbb::parallel_reduce(
        Range(0, now_.size(), 512), std::size_t{0},
        [&](const Range& range, std::size_t count) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (!fixed_.empty() && fixed_[i] != 0) continue;  // it has the same place in now_ and next_
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
    const PairForces forces = forces_on(now_, near_, i);
    energy_[i] = forces.energy;
    // The bound, about the stiffness in the ideal packing, keeps steps short where a particle has hardly any neighbour.
    const double stiffness = std::max(forces.stiffness, 1.0);
    Eigen::Vector3d move = momentum * velocity_[i] - damping / stiffness * forces.gradient;
    move -= n * n.dot(move);
    const double length = move.norm();
    if (length > largest_step * h) move *= largest_step * h / length;

    Eigen::Vector3d to = (x + move).cwiseMax(0.0).cwiseMin(sized_.surface().extent());
    const Jet jet = sized_.surface().value_gradient(to);
    const double slope = jet.gradient.norm();
    const double off = slope > 0.0 ? jet.value / slope : 0.0;
    // The step does not lead back to F = c if F bends too much or its gradient vanishes. The particle then stays.
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
    next_.spacing[i] = sized_.spacing(to);
  }

  const SizedSurface& sized_;
  const std::vector<char>& fixed_;
  Particles& now_;
  Particles next_;
  NeighbourLists near_;
  std::vector<Eigen::Vector3d> velocity_;
  std::vector<double> energy_;
  std::vector<Eigen::Vector3d> anchor_;  // positions when the neighbour lists were made
  std::size_t strays_ = 0;
};

}  // namespace

void relax_by_newton(const SizedSurface& sized, Particles& particles, int sweeps, Monitor& monitor,
                     const std::vector<char>& fixed) {
  const std::vector<Eigen::Vector3d> start = particles.points;
  NewtonRelaxation relaxation(sized, particles, fixed);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    monitor.progress(static_cast<double>(sweep) / static_cast<double>(sweeps));
    monitor.trace("energy", relaxation.sweep());
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      if (!fixed.empty() && fixed[n] != 0) continue;
      const auto foot = sized.surface().project(particles.points[n]);
      particles.points[n] = foot.value_or(start[n]);
      if (foot) continue;
      particles.normals[n] = outward_normal(sized.surface().value_gradient(start[n]).gradient);
      particles.spacing[n] = sized.spacing(start[n]);
    }
  });
}

}  // namespace isobench::particles
