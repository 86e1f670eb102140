#include "isobench/metrics/histogram.h"

#include <gtest/gtest.h>

#include <limits>

namespace isobench {

namespace {

TEST(Histogram, CountsByBinAndKeepsWhatIsOutside) {
  Histogram histogram(0.0, 2.0, 4);
  for (const double value : {0.0, 0.49, 0.5, 1.99, 2.0, -3.0, 1e300, std::numeric_limits<double>::infinity()}) {
    histogram.add(value);
  }
  EXPECT_EQ(histogram.counts, (std::vector<std::uint32_t>{3, 1, 0, 4}));
}

}  // namespace

}  // namespace isobench
