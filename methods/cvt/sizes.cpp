#include "methods/cvt/sizes.h"

#include <algorithm>
#include <cmath>

#include "methods/particles/random.h"

namespace isobench::cvt {

namespace {

constexpr double shrink = 0.7;
constexpr double around = 1.2;
constexpr double slope = 0.3;

}  // namespace

std::size_t Sizes::CellHash::operator()(const Cell& cell) const {
  std::uint64_t result = 0;
  for (const std::int32_t at : cell) result = particles::hash(result ^ static_cast<std::uint32_t>(at));
  return result;
}

Sizes::Cell Sizes::cell_of(const Eigen::Vector3d& x) const {
  const Eigen::Array3d at = (x.array() / width_).floor();
  return {static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]), static_cast<std::int32_t>(at[2])};
}

double Sizes::operator()(const Eigen::Vector3d& x) const {
  double size = spacing_(x);
  if (balls_.empty()) return size;
  const auto found = near_.find(cell_of(x));
  if (found == near_.end()) return size;
  for (const std::uint32_t n : found->second) {
    const Ball& ball = balls_[n];
    size = std::min(size, ball.size + slope * std::max(0.0, (x - ball.centre).norm() - ball.radius));
  }
  return size;
}

void Sizes::refine(const std::vector<Eigen::Vector3d>& centres) {
  if (centres.empty()) return;
  std::vector<Ball> fresh;
  for (const Eigen::Vector3d& centre : centres) {
    const double now = (*this)(centre);
    // Where the field itself grows away from the centre, what stays below it is farther off.
    constexpr double growth = 2.0;
    fresh.push_back(
        {centre, around * now, shrink * now, around * now + growth * (spacing_(centre) - shrink * now) / slope});
  }
  balls_.insert(balls_.end(), fresh.begin(), fresh.end());
  std::vector<double> reaches;
  for (const Ball& ball : balls_) reaches.push_back(ball.reach);
  const auto median = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
  std::nth_element(reaches.begin(), median, reaches.end());
  width_ = *median;
  near_.clear();
  for (std::uint32_t n = 0; n < balls_.size(); ++n) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(balls_[n].reach);
    const Cell low = cell_of(balls_[n].centre - reach), high = cell_of(balls_[n].centre + reach);
    for (std::int32_t i = low[0]; i <= high[0]; ++i) {
      for (std::int32_t j = low[1]; j <= high[1]; ++j) {
        for (std::int32_t k = low[2]; k <= high[2]; ++k) near_[{i, j, k}].push_back(n);
      }
    }
  }
}

}  // namespace isobench::cvt
