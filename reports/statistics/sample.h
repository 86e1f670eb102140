// What a sample of numbers looks like: quantiles, box plots, cumulative shares, and how sure a median or a share is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace isobench {

/// The p-quantile of sorted values, 0 ≤ p ≤ 1, linear between neighbours: with h = (n − 1) p it is
/// x[⌊h⌋] + (h − ⌊h⌋) (x[⌊h⌋ + 1] − x[⌊h⌋]), x counted from 0. Definition 7 of Hyndman and Fan, "Sample Quantiles in
/// Statistical Packages", The American Statistician 50(4), 1996; the default of R and NumPy. NaN without values.
double quantile(std::span<const double> sorted, double p);

/// Tukey, "Exploratory Data Analysis", 1977. The whiskers end at the outermost values that are at most 1.5 times the
/// distance of the quartiles away from the box. Values beyond them are outliers.
struct BoxPlot {
  double low = 0.0;
  double lower_quartile = 0.0;
  double median = 0.0;
  double upper_quartile = 0.0;
  double high = 0.0;
  std::vector<double> outliers;  ///< in increasing order
};
/// Precondition: at least one value, all finite.
BoxPlot box_plot(std::vector<double> values);

/// How many of the sorted values are ≥ x, and how many are ≤ x.
std::size_t count_at_least(std::span<const double> sorted, double x);
std::size_t count_at_most(std::span<const double> sorted, double x);

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The 95 % confidence interval of a share of which `passed` of `all` are known: with p = passed / n, n = all and
/// z = 1.96 it is (p + z²/2n ± z √(p(1 − p)/n + z²/4n²)) / (1 + z²/n). Wilson, "Probable Inference", Journal of the
/// American Statistical Association 22, 1927. Resampling would call 1000 of 1000 certain; this interval does not.
/// From 0 to 1 if `all` is 0.
Interval wilson_interval(std::size_t passed, std::size_t all);

/// The 95 % confidence interval of the median by the bootstrap's percentiles: the medians of 2000 samples drawn with
/// replacement, from their 2.5 % to their 97.5 % quantile. Efron, "Bootstrap Methods", The Annals of Statistics 7(1),
/// 1979. The same seed gives the same interval. NaN without values. Cost: about 10 ms for 1000 values.
Interval bootstrap_median(std::vector<double> values, std::uint64_t seed);

}  // namespace isobench
