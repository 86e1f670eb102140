#include "isobench/metrics/histogram.h"

#include <algorithm>
#include <cmath>

namespace isobench {

void Histogram::add(double value) {
  if (counts.empty()) return;
  const double last = static_cast<double>(counts.size() - 1);
  const double bin = std::floor((value - low) / (high - low) * static_cast<double>(counts.size()));
  // max(0, NaN) is 0: NaN counts in the first bin.
  ++counts[static_cast<std::size_t>(std::min(std::max(0.0, bin), last))];
}

}  // namespace isobench
