// Equal-width histograms, kept with their numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench {

struct Histogram {
  double low = 0.0;
  double high = 1.0;
  /// Equal bins over [low, high]; values outside fall into the outermost ones.
  std::vector<std::uint32_t> counts;

  Histogram() = default;
  Histogram(double from, double to, std::size_t bins) : low(from), high(to), counts(bins, 0) {}
  void add(double value);
};

}  // namespace isobench
