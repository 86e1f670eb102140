#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "isobench/reports/statistics/ranking.h"
#include "isobench/reports/statistics/sample.h"

namespace isobench {
namespace {

constexpr double failure = std::numeric_limits<double>::infinity();

TEST(Statistics, QuantilesAreThoseOfR) {
  // quantile(c(1, 2, 4, 8, 16, 32), c(0, .05, .25, .5, .9, 1)) in R.
  const std::vector<double> values = {1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
  EXPECT_DOUBLE_EQ(quantile(values, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile(values, 0.05), 1.25);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 2.5);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 6.0);
  EXPECT_DOUBLE_EQ(quantile(values, 0.9), 24.0);
  EXPECT_DOUBLE_EQ(quantile(values, 1.0), 32.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, ABoxPlotHasTukeysWhiskersAndOutliers) {
  const BoxPlot box = box_plot({5.0, 3.0, 100.0, 1.0, 2.0, 4.0, -50.0});
  EXPECT_DOUBLE_EQ(box.lower_quartile, 1.5);
  EXPECT_DOUBLE_EQ(box.median, 3.0);
  EXPECT_DOUBLE_EQ(box.upper_quartile, 4.5);
  EXPECT_DOUBLE_EQ(box.low, 1.0);
  EXPECT_DOUBLE_EQ(box.high, 5.0);
  EXPECT_EQ(box.outliers, (std::vector<double>{-50.0, 100.0}));
  const BoxPlot single = box_plot({7.0});
  EXPECT_DOUBLE_EQ(single.low, 7.0);
  EXPECT_DOUBLE_EQ(single.high, 7.0);
  EXPECT_TRUE(single.outliers.empty());
}

TEST(Statistics, CountsIncludeTheBound) {
  const std::vector<double> values = {0.1, 0.2, 0.2, 0.3};
  EXPECT_EQ(count_at_least(values, 0.2), 3U);
  EXPECT_EQ(count_at_most(values, 0.2), 3U);
  EXPECT_EQ(count_at_least(values, 0.31), 0U);
  EXPECT_EQ(count_at_most(values, 0.05), 0U);
}

TEST(Statistics, WilsonsIntervalIsThePublishedOne) {
  // Newcombe, Statistics in Medicine 17, 1998, table I, method 3.
  const Interval usual = wilson_interval(81, 263);
  EXPECT_NEAR(usual.low, 0.2553, 5e-5);
  EXPECT_NEAR(usual.high, 0.3662, 5e-5);
  const Interval none = wilson_interval(0, 20);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.1611, 5e-5);
  const Interval one = wilson_interval(1, 29);
  EXPECT_NEAR(one.low, 0.0061, 5e-5);
  EXPECT_NEAR(one.high, 0.1718, 5e-5);
  const Interval all = wilson_interval(1000, 1000);
  EXPECT_NEAR(all.low, 0.9962, 5e-5);
  EXPECT_EQ(all.high, 1.0);
}

// P(a binomial count of n draws, each with chance p, is at least k).
double binomial_at_least(int n, double p, int k) {
  double sum = 0.0;
  for (int i = k; i <= n; ++i)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) + i * std::log(p) +
                    (n - i) * std::log1p(-p));
  return sum;
}

TEST(Statistics, BootstrappedMediansAreWhereTheirExactDistributionPutsThem) {
  // The median of 101 draws is at most the i-th value if at least 51 draws are: this chance is known without drawing.
  constexpr int n = 101;
  std::vector<double> values;
  for (int i = n; i >= 1; --i) values.push_back(i);
  const auto exact = [](double share) {
    int i = 1;
    while (binomial_at_least(n, static_cast<double>(i) / n, 51) < share) ++i;
    return i;
  };
  const Interval interval = bootstrap_median(values, 1);
  // Of 2000 samples the quantile is off by less than one value in a hundred.
  EXPECT_NEAR(interval.low, exact(0.025), 1.0);
  EXPECT_NEAR(interval.high, exact(0.975), 1.0);
  const Interval again = bootstrap_median(values, 1);
  EXPECT_EQ(interval.low, again.low);
  EXPECT_EQ(interval.high, again.high);
  const Interval same = bootstrap_median({0.5, 0.5, 0.5, 0.5}, 7);
  EXPECT_EQ(same.low, 0.5);
  EXPECT_EQ(same.high, 0.5);
  EXPECT_TRUE(std::isnan(bootstrap_median({}, 1).low));
}

TEST(Statistics, RanksAndFriedmansTestAreDemsars) {
  // Demšar 2006, table 6: AUC of C4.5, C4.5+m, C4.5+cf and C4.5+m+cf on 14 data sets.
  const std::vector<std::vector<double>> quality = {
      {.763, .599, .954, .628, .882, .936, .661, .583, .775, 1.000, .940, .619, .972, .957},
      {.768, .591, .971, .661, .888, .931, .668, .583, .838, 1.000, .962, .666, .981, .978},
      // Both values of the 13th data set print as .975, but their ranks in the table differ.
      {.771, .590, .968, .654, .886, .916, .609, .563, .866, 1.000, .965, .614, .9751, .946},
      {.798, .569, .967, .657, .898, .931, .685, .625, .875, 1.000, .962, .669, .975, .970}};
  Costs costs = quality;
  for (std::vector<double>& method : costs) {
    for (double& value : method) value = 1.0 / value;
  }
  const std::vector<double> ranks = average_ranks(costs);
  EXPECT_NEAR(ranks[0], 3.143, 5e-4);
  EXPECT_NEAR(ranks[1], 2.000, 5e-4);
  EXPECT_NEAR(ranks[2], 2.893, 5e-4);
  EXPECT_NEAR(ranks[3], 1.964, 5e-4);
  // Demšar leaves ties out of account. Here they take 6.5 of the ranks' 70 squared deviations away.
  const double without_ties = friedman_test(costs).chi_square * 63.5 / 70.0;
  EXPECT_NEAR(without_ties, 9.28, 5e-3);
  EXPECT_NEAR(13.0 * without_ties / (14.0 * 3.0 - without_ties), 3.69, 5e-3);
  EXPECT_NEAR(critical_difference(4, 14), 1.25, 0.005);
}

TEST(Statistics, FriedmansPValueIsThatOfF) {
  // Without ties, 3 methods and 4 problems with rank sums 5, 8 and 11: χ² = 4.5, F(2, 6) = 3.857.
  const Costs costs = {{1.0, 1.0, 1.0, 2.0}, {2.0, 2.0, 3.0, 1.0}, {3.0, 3.0, 2.0, 3.0}};
  const FriedmanTest test = friedman_test(costs);
  EXPECT_DOUBLE_EQ(test.chi_square, 4.5);
  EXPECT_NEAR(test.f, 27.0 / 7.0, 1e-12);
  // With 2 degrees of freedom above, P(F > f) = (1 + 2 f / 6)^(−3).
  EXPECT_NEAR(test.p, std::pow(1.0 + 2.0 * test.f / 6.0, -3.0), 1e-12);
  const FriedmanTest agree = friedman_test({{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}});
  EXPECT_EQ(agree.f, failure);
  EXPECT_EQ(agree.p, 0.0);
  EXPECT_EQ(friedman_test({{1.0, 1.0}, {1.0, 1.0}}).p, 1.0);
}

TEST(Statistics, FailuresShareTheLastRanks) {
  EXPECT_EQ(average_ranks({{failure}, {2.0}, {failure}, {1.0}}), (std::vector<double>{3.5, 2.0, 3.5, 1.0}));
}

TEST(Statistics, NemenyisQuantilesAreDemsars) {
  // Demšar 2006, table 5(a).
  const std::vector<double> printed = {1.960, 2.343, 2.569, 2.728, 2.850, 2.949, 3.031, 3.102, 3.164};
  // The table divides quantiles that have three decimals by √2.
  for (std::size_t k = 2; k <= 10; ++k) EXPECT_NEAR(nemenyi_quantile(k), printed[k - 2], 1.1e-3) << k;
  EXPECT_NEAR(nemenyi_quantile(20), 5.01 / std::sqrt(2.0), 5e-3);  // the studentized range of 20 values is 5.01
}

TEST(Statistics, PerformanceRatiosAreThoseOfDolanAndMore) {
  const Costs ratios = performance_ratios({{1.0, 4.0, failure, failure}, {2.0, 2.0, 3.0, failure}});
  EXPECT_EQ(ratios[0], (std::vector<double>{1.0, 2.0, failure, failure}));
  EXPECT_EQ(ratios[1], (std::vector<double>{1.0, 1.0, 2.0, failure}));
}

TEST(Statistics, TheParetoFrontHasWhatNothingBeats) {
  const std::vector<ParetoPoint> points = {{5.0, 0.9}, {1.0, 0.1}, {2.0, 0.8}, {3.0, 0.8}, {4.0, 0.7}, {1.0, 0.1}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 5, 2, 0}));
}

TEST(Statistics, KendallsTauCountsPairs) {
  const std::vector<double> x = {1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_DOUBLE_EQ(kendall_tau(x, std::vector<double>{10.0, 20.0, 30.0, 40.0, 50.0}), 1.0);
  EXPECT_DOUBLE_EQ(kendall_tau(x, std::vector<double>{5.0, 4.0, 3.0, 2.0, 1.0}), -1.0);
  EXPECT_DOUBLE_EQ(kendall_tau(x, std::vector<double>{1.0, 3.0, 2.0, 5.0, 4.0}), 0.6);  // 8 pairs agree, 2 do not
  // One pair of equal x, one of equal y: (8 − 0)/√(9·9).
  EXPECT_DOUBLE_EQ(
      kendall_tau(std::vector<double>{1.0, 1.0, 2.0, 3.0, 4.0}, std::vector<double>{1.0, 2.0, 3.0, 4.0, 4.0}),
      8.0 / 9.0);
  EXPECT_TRUE(std::isnan(kendall_tau(x, std::vector<double>(5, 1.0))));
}

}  // namespace
}  // namespace isobench
