#include "isobench/reports/statistics/ranking.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace isobench {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The ranks of all methods on one problem.
std::vector<double> ranks_on(const Costs& costs, std::size_t problem) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cost = [&costs, problem](std::size_t method) { return costs[method][problem]; };
  std::sort(order.begin(), order.end(), [&cost](std::size_t a, std::size_t b) { return cost(a) < cost(b); });
  std::vector<double> ranks(costs.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && cost(order[end]) == cost(order[first])) ++end;
    const double shared = 0.5 * static_cast<double>(first + 1 + end);  // the mean of the ranks first + 1 to end
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = shared;
    first = end;
  }
  return ranks;
}

std::size_t problems_of(const Costs& costs) { return costs.empty() ? 0 : costs.front().size(); }

double normal_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::acos(-1.0)); }
double normal_share(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

// P(range of k standard normal values ≤ w), by Simpson's rule; z is the largest of the values.
double range_share(double k, double w) {
  constexpr int steps = 800;
  constexpr double end = 8.0;  // the density beyond is below 1e-14
  const double width = 2.0 * end / steps;
  double sum = 0.0;
  for (int n = 0; n <= steps; ++n) {
    const double z = -end + n * width;
    const double weight = n == 0 || n == steps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
    sum += weight * normal_density(z) * std::pow(normal_share(z) - normal_share(z - w), k - 1.0);
  }
  return k * sum * width / 3.0;
}

}  // namespace

std::vector<double> average_ranks(const Costs& costs) {
  std::vector<double> sums(costs.size(), 0.0);
  const std::size_t problems = problems_of(costs);
  for (std::size_t p = 0; p < problems; ++p) {
    const std::vector<double> ranks = ranks_on(costs, p);
    for (std::size_t m = 0; m < sums.size(); ++m) sums[m] += ranks[m];
  }
  for (double& sum : sums) sum /= static_cast<double>(problems);
  return sums;
}

FriedmanTest friedman_test(const Costs& costs) {
  const auto k = static_cast<double>(costs.size());
  const auto n = static_cast<double>(problems_of(costs));
  FriedmanTest test;
  if (costs.size() < 2 || problems_of(costs) < 2) return test;
  std::vector<double> sums(costs.size(), 0.0);
  double squares = 0.0;
  for (std::size_t p = 0; p < problems_of(costs); ++p) {
    const std::vector<double> ranks = ranks_on(costs, p);
    for (std::size_t m = 0; m < sums.size(); ++m) {
      sums[m] += ranks[m];
      squares += ranks[m] * ranks[m];
    }
  }
  double between = 0.0;
  for (const double sum : sums) between += (sum - 0.5 * n * (k + 1.0)) * (sum - 0.5 * n * (k + 1.0));
  const double within = squares - 0.25 * n * k * (k + 1.0) * (k + 1.0);
  if (within <= 0.0) return test;  // only ties
  test.chi_square = (k - 1.0) * between / within;
  const double rest = n * (k - 1.0) - test.chi_square;
  const bool all_agree = rest <= 1e-9 * n;  // what rounding leaves of zero
  test.f = all_agree ? infinite : (n - 1.0) * test.chi_square / rest;
  const double above = k - 1.0;
  const double below = (k - 1.0) * (n - 1.0);
  test.p = all_agree ? 0.0 : boost::math::ibeta(0.5 * below, 0.5 * above, below / (below + above * test.f));
  return test;
}

double nemenyi_quantile(std::size_t methods) {
  const auto k = static_cast<double>(methods);
  const auto off = [k](double w) { return range_share(k, w) - 0.95; };
  std::uintmax_t steps = 100;
  const auto found =
      boost::math::tools::toms748_solve(off, 0.5, 15.0, boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (found.first + found.second) / std::sqrt(2.0);
}

double critical_difference(std::size_t methods, std::size_t problems) {
  const auto k = static_cast<double>(methods);
  return nemenyi_quantile(methods) * std::sqrt(k * (k + 1.0) / (6.0 * static_cast<double>(problems)));
}

Costs performance_ratios(const Costs& costs) {
  Costs ratios = costs;
  for (std::size_t p = 0; p < problems_of(costs); ++p) {
    double best = infinite;
    for (const std::vector<double>& method : costs) best = std::min(best, method[p]);
    for (std::vector<double>& method : ratios) {
      const bool is_best = method[p] == best && std::isfinite(best);
      method[p] = is_best ? 1.0 : method[p] / best;  // a failure stays infinite, unless all fail
      if (std::isnan(method[p])) method[p] = infinite;
    }
  }
  for (std::vector<double>& method : ratios) std::sort(method.begin(), method.end());
  return ratios;
}

double kendall_tau(std::span<const double> x, std::span<const double> y) {
  const auto sign = [](double difference) { return difference > 0.0 ? 1.0 : difference < 0.0 ? -1.0 : 0.0; };
  double agreement = 0.0;
  double differ_in_x = 0.0;
  double differ_in_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double of_x = sign(x[i] - x[j]);
      const double of_y = sign(y[i] - y[j]);
      agreement += of_x * of_y;
      differ_in_x += std::abs(of_x);
      differ_in_y += std::abs(of_y);
    }
  }
  return agreement / std::sqrt(differ_in_x * differ_in_y);
}

std::vector<std::size_t> pareto_front(const std::vector<ParetoPoint>& points) {
  const auto beats = [](const ParetoPoint& a, const ParetoPoint& b) {
    return a.cost <= b.cost && a.quality >= b.quality && (a.cost < b.cost || a.quality > b.quality);
  };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool beaten =
        std::any_of(points.begin(), points.end(), [&](const ParetoPoint& other) { return beats(other, points[i]); });
    if (!beaten) front.push_back(i);
  }
  std::stable_sort(front.begin(), front.end(),
                   [&points](std::size_t a, std::size_t b) { return points[a].cost < points[b].cost; });
  return front;
}

}  // namespace isobench
