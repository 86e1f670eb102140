#include "isobench/methods/particles/cure/local_relaxation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/neighbours.h"

namespace isobench::particles {

namespace {

constexpr double shrink_factor = 0.7;
constexpr double shrunk_radius = 1.2;   // times the spacing at a point
constexpr double least_distance = 0.5;  // between points that get a bound, times the spacing
constexpr double relaxed_radius = 2.0;  // times the spacing; 3 has the same effect but moves two thirds more particles
constexpr int population_controls = 2;
constexpr int sweeps_between = 6;  // before, between and after the population controls

}  // namespace

void shrink_around(const std::vector<Eigen::Vector3d>& points, SizedSurface& sized, double least_h) {
  // Points that are close to another one would add nothing but bounds, and each value of h looks at all bounds that
  // reach it.
  std::vector<double> reach(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) reach[n] = least_distance * sized.spacing(points[n]);
  const NeighbourLists near = find_neighbours(points, reach);
  std::vector<char> kept(points.size(), 0);
  std::vector<SizeBound> bounds;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto others = near.of(n);
    kept[n] = std::none_of(others.begin(), others.end(), [&](std::uint32_t m) { return m < n && kept[m] != 0; });
    if (kept[n] == 0) continue;
    const Eigen::Vector3d& x = points[n];
    const double spacing = sized.spacing(x);
    const double h = spacing * sized.contraction();
    bounds.push_back({x, std::min(h, std::max(least_h, shrink_factor * h)), shrunk_radius * spacing, spacing});
  }
  sized.add_bounds(bounds);
}

Exchange relax_around(const std::vector<Eigen::Vector3d>& points, SizedSurface& sized, const Particles& particles,
                      double least_h, const PopulationLimits& population, Monitor& monitor) {
  const std::size_t first = sized.bounds().size();
  shrink_around(points, sized, least_h);

  // Particles beyond relaxed_radius stay but act on those within. Particles that no new bound reaches are left out.
  std::vector<double> distance(particles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 4096), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n)
      distance[n] = sized.bounds().scaled_distance(particles.points[n], first);
  });
  Exchange exchange;
  std::vector<Eigen::Vector3d> near;
  std::vector<char> fixed;
  for (std::uint32_t n = 0; n < particles.size(); ++n) {
    if (distance[n] == std::numeric_limits<double>::infinity()) continue;
    if (distance[n] <= relaxed_radius) exchange.removed.push_back(n);
    near.push_back(particles.points[n]);
    fixed.push_back(distance[n] <= relaxed_radius ? 0 : 1);
  }

  Particles all = make_particles(sized, std::move(near));
  Monitor unrecorded;  // the run's traces are of all particles, not of these few
  for (int control = 0; control <= population_controls; ++control) {
    monitor.check();
    if (control > 0) control_population(sized, all, population, &fixed);
    relax_by_newton(sized, all, sweeps_between, unrecorded, fixed);
  }
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (fixed[n] == 0) exchange.added.add(all, n);
  }
  return exchange;
}

}  // namespace isobench::particles
