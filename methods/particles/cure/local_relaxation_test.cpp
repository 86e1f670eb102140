#include "isobench/methods/particles/cure/local_relaxation.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::particles {
namespace {

using Eigen::Vector3d;

// An even packing on a torus and two particles of it that are far from each other.
class LocalRelaxationTest : public ::testing::Test {
 protected:
  static constexpr double edge_length = 1.5;

  LocalRelaxationTest() {
    const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
    const auto count = static_cast<std::size_t>(ideal_count(sized, lattice_mesh));
    all = make_particles(sized, eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor));
    relax_by_newton(sized, all, 40, monitor);
    centres = {all.points[all.size() / 4], all.points[3 * all.size() / 4]};
  }

  Exchange run(double least_h = 0.0, const PopulationLimits& limits = {}) {
    return relax_around(centres, sized, all, least_h, limits, monitor);
  }

  double to_centre(const Vector3d& x) const { return std::min((x - centres[0]).norm(), (x - centres[1]).norm()); }

  Particles after(const Exchange& exchange) const {
    Particles result;
    for (std::uint32_t n = 0; n < all.size(); ++n) {
      if (!std::binary_search(exchange.removed.begin(), exchange.removed.end(), n)) result.add(all, n);
    }
    for (std::size_t n = 0; n < exchange.added.size(); ++n) result.add(exchange.added, n);
    return result;
  }

  // The distance to the nearest other particle, for each particle within `reach` of a centre.
  std::vector<double> gaps(const Particles& particles, double reach) const {
    std::vector<double> result;
    for (std::size_t n = 0; n < particles.size(); ++n) {
      if (to_centre(particles.points[n]) > reach) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t m = 0; m < particles.size(); ++m) {
        if (m != n) least = std::min(least, (particles.points[m] - particles.points[n]).norm());
      }
      result.push_back(least);
    }
    return result;
  }

  Monitor monitor;
  const Isosurface surface{sample_phantom(phantom("torus"), 48), 0.0};
  const SizingField field{edge_length};
  SizedSurface sized{surface, field};
  Particles all;
  std::vector<Vector3d> centres;
};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST_F(LocalRelaxationTest, ExchangesParticlesNearTheCentres) {
  const std::size_t traced = monitor.traces().at("energy").size();
  const Exchange exchange = run();
  EXPECT_TRUE(std::is_sorted(exchange.removed.begin(), exchange.removed.end()));
  for (std::uint32_t n = 0; n < all.size(); ++n) {
    const bool near = to_centre(all.points[n]) <= 2.0 * edge_length;
    EXPECT_EQ(std::binary_search(exchange.removed.begin(), exchange.removed.end(), n), near);
  }
  EXPECT_GT(exchange.removed.size(), 20U);
  EXPECT_GT(exchange.added.size(), exchange.removed.size());
  EXPECT_EQ(monitor.traces().at("energy").size(), traced);
  for (std::size_t n = 0; n < exchange.added.size(); ++n) {
    const Vector3d& x = exchange.added.points[n];
    const Jet jet = surface.value_gradient(x);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * surface.voxel());
    EXPECT_LT(to_centre(x), 3.0 * edge_length);
  }
}

TEST_F(LocalRelaxationTest, PacksCloserAtTheCentresAndNowhereTooClose) {
  const double before = mean(gaps(all, 1.2 * edge_length));
  const Particles now = after(run());
  EXPECT_NEAR(mean(gaps(now, 0.9 * edge_length)) / before, 0.7, 0.07);
  const std::vector<double> each = gaps(now, 6.0 * edge_length);
  EXPECT_GT(*std::min_element(each.begin(), each.end()), 0.5 * 0.7 * edge_length);
}

TEST_F(LocalRelaxationTest, ShrinksNoFurtherThanTheLeast) {
  run(0.9 * edge_length);
  ASSERT_EQ(sized.bounds().size(), 2U);
  EXPECT_DOUBLE_EQ(sized.bounds().at(0).h, 0.9 * edge_length);
  run(2.0 * edge_length);
  ASSERT_EQ(sized.bounds().size(), 4U);
  EXPECT_DOUBLE_EQ(sized.bounds().at(2).h, 0.9 * edge_length) << "h must not grow where it is smaller already";
}

TEST_F(LocalRelaxationTest, ASecondTimeShrinksFurther) {
  run();
  run();
  EXPECT_NEAR(sized.spacing(centres[0]), 0.49 * edge_length, 1e-12);
}

// A lower limit deletes more particles, a higher one splits more.
TEST_F(LocalRelaxationTest, FollowsThePopulationLimits) {
  const std::size_t usual = run().added.size();
  SizedSurface again(surface, field);
  const Exchange fewer = relax_around(centres, again, all, 0.0, {.delete_above = 0.7}, monitor);
  EXPECT_LT(fewer.added.size(), usual);
  SizedSurface once_more(surface, field);
  const Exchange more =
      relax_around(centres, once_more, all, 0.0, {.split_below = 0.95, .delete_above = 10.0}, monitor);
  EXPECT_GT(more.added.size(), usual);
}

TEST_F(LocalRelaxationTest, DoesNotDependOnThreads) {
  const Exchange usual = run();
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  SizedSurface again(surface, field);
  const Exchange alone = relax_around(centres, again, all, 0.0, {}, monitor);
  EXPECT_EQ(usual.removed, alone.removed);
  EXPECT_EQ(usual.added.points, alone.added.points);
}

// Neither the relaxation nor the population control touches fixed particles.
TEST_F(LocalRelaxationTest, FixedParticlesStay) {
  std::vector<char> fixed(all.size(), 0);
  for (std::size_t n = 0; n < all.size(); n += 3) fixed[n] = 1;
  Particles moved = all;
  for (Vector3d& x : moved.points) x += 0.1 * edge_length * Vector3d(std::sin(31.0 * x[0]), std::cos(17.0 * x[1]), 0.3);
  const Particles start = moved;
  relax_by_newton(sized, moved, 3, monitor, fixed);
  std::size_t same = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (moved.points[n] == start.points[n]) {
      ++same;
      EXPECT_NE(fixed[n], 0);
    }
  }
  EXPECT_EQ(same, (all.size() + 2) / 3);

  // These limits delete every particle that is not fixed or beside a deleted one.
  std::vector<char> flags = fixed;
  Particles fewer = all;
  const PopulationChange change = control_population(sized, fewer, {0.0, 0.1}, &flags);
  EXPECT_GT(change.deleted, 0U);
  ASSERT_EQ(flags.size(), fewer.size());
  std::vector<Vector3d> staying;
  std::vector<Vector3d> stayed;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (fixed[n] != 0) staying.push_back(all.points[n]);
  }
  for (std::size_t n = 0; n < fewer.size(); ++n) {
    if (flags[n] != 0) stayed.push_back(fewer.points[n]);
  }
  EXPECT_EQ(staying, stayed);
}

}  // namespace
}  // namespace isobench::particles
