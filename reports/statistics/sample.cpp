#include "isobench/reports/statistics/sample.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/foundation/random.h"

namespace isobench {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

// The index of the k-th smallest of the drawn values; `drawn` counts how often each sorted value was drawn.
std::size_t drawn_index(const std::vector<std::uint32_t>& drawn, std::size_t k) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    seen += drawn[i];
    if (seen > k) return i;
  }
  return drawn.size() - 1;
}

double resampled_median(const std::vector<double>& sorted, std::uint64_t seed, std::uint64_t sample,
                        std::vector<std::uint32_t>& drawn) {
  const std::size_t n = sorted.size();
  std::fill(drawn.begin(), drawn.end(), 0U);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(uniform_random(seed, sample, i) * static_cast<double>(n));
    ++drawn[std::min(at, n - 1)];
  }
  const double upper = sorted[drawn_index(drawn, n / 2)];
  return n % 2 == 1 ? upper : 0.5 * (sorted[drawn_index(drawn, n / 2 - 1)] + upper);
}

}  // namespace

double quantile(std::span<const double> sorted, double p) {
  if (sorted.empty()) return no_value;
  const double h = static_cast<double>(sorted.size() - 1) * p;
  const auto below = static_cast<std::size_t>(std::floor(h));
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (h - std::floor(h)) * (sorted[below + 1] - sorted[below]);
}

BoxPlot box_plot(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  BoxPlot box;
  box.lower_quartile = quantile(values, 0.25);
  box.median = quantile(values, 0.5);
  box.upper_quartile = quantile(values, 0.75);
  const double reach = 1.5 * (box.upper_quartile - box.lower_quartile);
  // The box itself bounds the whiskers, because a quartile may lie between two values of which the outer is too far.
  box.low = box.lower_quartile;
  box.high = box.upper_quartile;
  for (const double value : values) {
    if (value < box.lower_quartile - reach || value > box.upper_quartile + reach) {
      box.outliers.push_back(value);
      continue;
    }
    box.low = std::min(box.low, value);
    box.high = std::max(box.high, value);
  }
  return box;
}

std::size_t count_at_least(std::span<const double> sorted, double x) {
  return static_cast<std::size_t>(sorted.end() - std::lower_bound(sorted.begin(), sorted.end(), x));
}

std::size_t count_at_most(std::span<const double> sorted, double x) {
  return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), x) - sorted.begin());
}

Interval wilson_interval(std::size_t passed, std::size_t all) {
  if (all == 0) return {0.0, 1.0};
  constexpr double z = 1.959963984540054;  // the 97.5 % quantile of the normal distribution
  const auto n = static_cast<double>(all);
  const double p = static_cast<double>(passed) / n;
  const double middle = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 + z * z / n;
  // Rounding must not take the ends away from 0 and 1 where they are exactly there.
  return {passed == 0 ? 0.0 : (middle - half) / scale, passed == all ? 1.0 : (middle + half) / scale};
}

Interval bootstrap_median(std::vector<double> values, std::uint64_t seed) {
  if (values.empty()) return {no_value, no_value};
  constexpr std::uint64_t samples = 2000;
  std::sort(values.begin(), values.end());
  std::vector<std::uint32_t> drawn(values.size());
  std::vector<double> medians;
  for (std::uint64_t sample = 0; sample < samples; ++sample)
    medians.push_back(resampled_median(values, seed, sample, drawn));
  std::sort(medians.begin(), medians.end());
  return {quantile(medians, 0.025), quantile(medians, 0.975)};
}

}  // namespace isobench
