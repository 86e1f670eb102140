// Histograms of equal bins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench {

struct Histogram {
  double low = 0.0;
  double high = 1.0;
  /// How many values fell into each bin; values outside [low, high] count in the first and last bin.
  std::vector<std::uint32_t> counts;

  Histogram() = default;
  Histogram(double from, double to, std::size_t bins) : low(from), high(to), counts(bins, 0) {}
  void add(double value);
};

}  // namespace isobench
