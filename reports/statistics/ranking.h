// Comparing methods over many problems: average ranks, performance profiles, the Pareto front.
//
// Costs are smaller if better. An infinite cost is a failure. `costs[m][p]` is the cost of method m on problem p; all
// methods have the same problems.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isobench {

using Costs = std::vector<std::vector<double>>;

/// The rank of each method, 1 for the best, averaged over the problems. Methods with equal cost share the mean of
/// their ranks. Demšar, "Statistical Comparisons of Classifiers over Multiple Data Sets", Journal of Machine Learning
/// Research 7, 2006, section 3.2.2.
std::vector<double> average_ranks(const Costs& costs);

/// Friedman's test: could the ranks differ this much if all methods were alike?
struct FriedmanTest {
  double chi_square = 0.0;  ///< (k − 1) Σ_m (R_m − N (k+1)/2)² / (Σ r² − N k (k+1)²/4), R_m the rank sums; counts ties
  double f = 0.0;  ///< Iman and Davenport: (N − 1) χ² / (N (k − 1) − χ²); infinite if all problems agree
  double p = 1.0;  ///< P(F > f) with k − 1 and (k − 1)(N − 1) degrees of freedom
};
/// For k methods and N problems. Friedman, Journal of the American Statistical Association 32, 1937; with ties as in
/// Conover, "Practical Nonparametric Statistics", 1999, section 5.8; Iman and Davenport, Communications in Statistics
/// A 9(6), 1980. p is 1 if there are fewer than two methods or problems, or only ties.
FriedmanTest friedman_test(const Costs& costs);

/// Average ranks of two of k methods over N problems that differ by more than this differ significantly (α = 0.05):
/// q √(k (k + 1) / (6 N)), q the 95 % quantile of the studentized range of k values, divided by √2. Nemenyi, 1963;
/// Demšar 2006, equation after table 5. Precondition: k ≥ 2, N ≥ 1.
double critical_difference(std::size_t methods, std::size_t problems);

/// The q above. Demšar 2006, table 5, prints it for k = 2 to 10. It is computed from the distribution of the range of k
/// standard normal values: P(range ≤ w) = k ∫ φ(z) (Φ(z) − Φ(z − w))^(k−1) dz.
double nemenyi_quantile(std::size_t methods);

/// Each cost divided by the smallest cost of the same problem, sorted, for each method; infinite for failures. The
/// share of ratios ≤ τ is the method's performance profile. Dolan and Moré, "Benchmarking optimization software with
/// performance profiles", Mathematical Programming 91, 2002, equations 2.1 and 2.2. Precondition: costs > 0.
Costs performance_ratios(const Costs& costs);

/// Kendall's rank correlation τ_b of pairs (x_i, y_i): 1 if the larger x always has the larger y, −1 if it always has
/// the smaller one. It is (C − D) / √((N − T_x)(N − T_y)) for C concordant and D discordant ones of the N pairs of
/// pairs, T_x and T_y of which have equal x or y. Kendall, "The Treatment of Ties in Ranking Problems", Biometrika
/// 33(3), 1945. NaN if all x or all y are equal. Precondition: as many x as y.
double kendall_tau(std::span<const double> x, std::span<const double> y);

struct ParetoPoint {
  double cost = 0.0;     ///< smaller is better
  double quality = 0.0;  ///< larger is better
};
/// The indices of the points that no other point beats: none is at least as good in both and better in one. In the
/// order of increasing cost.
std::vector<std::size_t> pareto_front(const std::vector<ParetoPoint>& points);

}  // namespace isobench
