#include "isobench/methods/particles/cure/local_relaxation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "isobench/methods/particles/sampling/population.h"

namespace isobench::particles {

namespace {

constexpr double shrink = 0.7;
constexpr double shrunk = 1.2;  // times the spacing around a point
constexpr double loose = 2.0;   // with three, two thirds more particles would have to move, for the same
constexpr int local_controls = 2;
constexpr int sweeps_between = 6;     // before, between and after the controls
constexpr double least_energy = 0.6;  // times the ideal; with less a particle splits
constexpr double most_energy = 1.6;   // with more it goes

}  // namespace

void shrink_around(const std::vector<Eigen::Vector3d>& points, const Spacing& spacing, SizeBounds& smaller,
                   double least) {
  std::vector<SizeBound> places;
  places.reserve(points.size());
  for (const Eigen::Vector3d& x : points) {
    const double apart = spacing(x);
    const double h = apart * spacing.contraction;
    places.push_back({x, std::min(h, std::max(least, shrink * h)), shrunk * apart, apart});
  }
  smaller.add(places);
}

Exchange relax_around(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface, const Spacing& spacing,
                      SizeBounds& smaller, double least, const Particles& particles, Monitor& monitor) {
  const std::size_t first = smaller.size();
  shrink_around(points, spacing, smaller, least);

  // Those farther than `loose` units act on those within, and out of all reach nobody does.
  std::vector<double> away(particles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles.size(), 4096), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) away[n] = smaller.units_from(particles.points[n], first);
  });
  Exchange exchange;
  std::vector<Eigen::Vector3d> near;
  std::vector<char> fixed;
  for (std::uint32_t n = 0; n < particles.size(); ++n) {
    if (away[n] == std::numeric_limits<double>::infinity()) continue;
    if (away[n] <= loose) exchange.gone.push_back(n);
    near.push_back(particles.points[n]);
    fixed.push_back(away[n] <= loose ? 0 : 1);
  }

  Particles all = make_particles(surface, spacing, std::move(near));
  Monitor own;  // the traces are of relaxing all
  for (int control = 0; control <= local_controls; ++control) {
    monitor.check();
    if (control > 0) control_population(surface, spacing, all, least_energy, most_energy, &fixed);
    relax(surface, spacing, all, sweeps_between, own, fixed);
  }
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (fixed[n] == 0) exchange.fresh.add(all, n);
  }
  return exchange;
}

}  // namespace isobench::particles
