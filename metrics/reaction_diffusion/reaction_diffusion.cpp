#include "isobench/metrics/reaction_diffusion/reaction_diffusion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace isobench {

namespace {

constexpr double feed_u = 0.1;
constexpr double feed_v = 0.9;
constexpr double diffusion_ratio = 20.0;
// Of small waves with the eigenvalue λ of −Δ, J − D λ diag(1, 20) says how they grow, J = (0.8, 1; −1.8, −1) being the
// reaction's derivatives. At this D λ its largest eigenvalue is largest: 5/19.
constexpr double fastest_wave = 9.0 / 38.0;
constexpr double reaction_rate = 16.0;
constexpr double blown_up = 100.0;
constexpr Eigen::Index rows_of_block = 1024;  // some 5 µs of work: enough blocks for many cores on a small mesh

/// Where the largest concentration of a block is.
struct Peak {
  double value = 0.0;
  Eigen::Index row = 0;
};

/// Of two absolute values; what is no number any more counts as infinite.
double larger_of(double u, double v) {
  return std::isnan(u + v) ? std::numeric_limits<double>::infinity() : std::max(std::abs(u), std::abs(v));
}

class Stepper {
 public:
  Stepper(const FiniteElements& elements, const SpotPattern& pattern, double step)
      : spread_((step * pattern.diffusion() * elements.lumped_mass.cwiseInverse()).asDiagonal() * elements.stiffness),
        step_(step),
        peaks_(static_cast<std::size_t>((spread_.rows() + rows_of_block - 1) / rows_of_block)) {
    spread_.makeCompressed();
  }

  /// `after` has the size of `before`. Returns the largest absolute concentration, the first of several.
  Peak step(const Concentrations& before, Concentrations& after) {
    tbb::parallel_for(std::size_t{0}, peaks_.size(), [&](std::size_t b) {
      const Eigen::Index first = static_cast<Eigen::Index>(b) * rows_of_block;
      peaks_[b] = rows(first, std::min(first + rows_of_block, spread_.rows()), before, after);
    });
    return *std::max_element(peaks_.begin(), peaks_.end(),
                             [](const Peak& a, const Peak& b) { return a.value < b.value; });
  }

 private:
  Peak rows(Eigen::Index first, Eigen::Index end, const Concentrations& before, Concentrations& after) const {
    Peak peak{-1.0, first};
    const std::int32_t* starts = spread_.outerIndexPtr();
    for (Eigen::Index i = first; i < end; ++i) {
      Eigen::Array2d flux(0.0, 0.0);
      for (std::int32_t n = starts[i]; n < starts[i + 1]; ++n) {
        flux += spread_.valuePtr()[n] * before.col(spread_.innerIndexPtr()[n]).array();
      }
      const double u = before(0, i);
      const double v = before(1, i);
      const double turned = u * u * v;
      after(0, i) = u - flux[0] + step_ * (feed_u - u + turned);
      after(1, i) = v - diffusion_ratio * flux[1] + step_ * (feed_v - turned);
      const double largest = larger_of(after(0, i), after(1, i));
      if (largest > peak.value) peak = {largest, i};
    }
    return peak;
  }

  SparseMatrix spread_;  ///< τ D M⁻¹K
  double step_;
  std::vector<Peak> peaks_;  ///< one for each block
};

}  // namespace

double SpotPattern::diffusion() const {
  const double wave_number = 2.0 * std::numbers::pi / wavelength;
  return fastest_wave / (wave_number * wave_number);
}

double SpotPattern::largest_step(double largest_eigenvalue) const {
  return 2.0 / (diffusion_ratio * diffusion() * largest_eigenvalue + reaction_rate);
}

Concentrations first_concentrations(const std::vector<Eigen::Vector3d>& points, const SpotPattern& pattern) {
  constexpr Eigen::Index waves = 24;
  // A surface sees a wave of space a little longer, because most waves do not run along it.
  const double wave_number = 1.2 * 2.0 * std::numbers::pi / pattern.wavelength;
  Eigen::Matrix<double, waves, 3> directions;
  const Eigen::VectorXd random = random_vector(4 * waves, 1952);
  for (Eigen::Index w = 0; w < waves; ++w) directions.row(w) = random.segment<3>(3 * w).normalized();
  const Eigen::Array<double, waves, 1> phases = std::numbers::pi * random.tail<waves>().array();
  Concentrations result(2, static_cast<Eigen::Index>(points.size()));
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t n) {
    const double noise = ((wave_number * (directions * points[n])).array() + phases).cos().sum();
    result.col(static_cast<Eigen::Index>(n)) << feed_u + feed_v + 0.2 * noise / std::sqrt(0.5 * waves), feed_v;
  });
  return result;
}

March march(const FiniteElements& elements, const SpotPattern& pattern, Concentrations first, double step,
            std::size_t steps, Monitor& monitor) {
  Stepper stepper(elements, pattern, step);
  March result{std::move(first)};
  Concentrations next(2, result.concentrations.cols());
  while (result.steps < steps && !result.blew_up) {
    if (result.steps % 64 == 0) monitor.progress(static_cast<double>(result.steps) / static_cast<double>(steps));
    const Peak peak = stepper.step(result.concentrations, next);
    result.concentrations.swap(next);
    ++result.steps;
    result.blew_up = !(peak.value <= blown_up);
    result.worst = peak.row;
  }
  return result;
}

}  // namespace isobench
