#include "isobench/methods/particles/cure/local_relaxation.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/sampling/population.h"

namespace isobench::particles {
namespace {

using Eigen::Vector3d;

// An even packing on a torus, and two places of it, far from each other.
class LocalRelaxationTest : public ::testing::Test {
 protected:
  static constexpr double apart = 1.5;

  LocalRelaxationTest() {
    const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
    const auto count = static_cast<std::size_t>(ideal_count(lattice_mesh, spacing));
    all = make_particles(surface, spacing, eliminate_to_seeds(surface, lattice_mesh, spacing, count, 4.0, 1, monitor));
    relax(surface, spacing, all, 40, monitor);
    places = {all.points[all.size() / 4], all.points[3 * all.size() / 4]};
  }

  Exchange run(double least = 0.0) { return relax_around(places, surface, spacing, smaller, least, all, monitor); }

  double to_place(const Vector3d& x) const { return std::min((x - places[0]).norm(), (x - places[1]).norm()); }

  Particles after(const Exchange& exchange) const {
    Particles result;
    for (std::uint32_t n = 0; n < all.size(); ++n) {
      if (!std::binary_search(exchange.gone.begin(), exchange.gone.end(), n)) result.add(all, n);
    }
    for (std::size_t n = 0; n < exchange.fresh.size(); ++n) result.add(exchange.fresh, n);
    return result;
  }

  // Of the particles within `reach` of a place, from each to the one nearest to it.
  std::vector<double> gaps(const Particles& particles, double reach) const {
    std::vector<double> result;
    for (std::size_t n = 0; n < particles.size(); ++n) {
      if (to_place(particles.points[n]) > reach) continue;
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
  const SizingField field{apart};
  SizeBounds smaller{surface, 0.3};
  const Spacing spacing{field, 1.0, &smaller};
  Particles all;
  std::vector<Vector3d> places;
};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST_F(LocalRelaxationTest, ExchangesThoseNearThePlaces) {
  const std::size_t traced = monitor.traces().at("energy").size();
  const Exchange exchange = run();
  EXPECT_TRUE(std::is_sorted(exchange.gone.begin(), exchange.gone.end()));
  for (std::uint32_t n = 0; n < all.size(); ++n) {
    const bool near = to_place(all.points[n]) <= 2.0 * apart;
    EXPECT_EQ(std::binary_search(exchange.gone.begin(), exchange.gone.end(), n), near);
  }
  EXPECT_GT(exchange.gone.size(), 20U);
  EXPECT_GT(exchange.fresh.size(), exchange.gone.size());
  EXPECT_EQ(monitor.traces().at("energy").size(), traced);
  for (std::size_t n = 0; n < exchange.fresh.size(); ++n) {
    const Vector3d& x = exchange.fresh.points[n];
    const Jet jet = surface.value_gradient(x);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * surface.voxel());
    EXPECT_LT(to_place(x), 3.0 * apart);
  }
}

TEST_F(LocalRelaxationTest, PacksCloserAtThePlacesAndNowhereTooClose) {
  const double before = mean(gaps(all, 1.2 * apart));
  const Particles now = after(run());
  EXPECT_NEAR(mean(gaps(now, 0.9 * apart)) / before, 0.7, 0.07);
  const std::vector<double> each = gaps(now, 6.0 * apart);
  EXPECT_GT(*std::min_element(each.begin(), each.end()), 0.5 * 0.7 * apart);
}

TEST_F(LocalRelaxationTest, ShrinksNoFurtherThanTheLeast) {
  run(0.9 * apart);
  ASSERT_EQ(smaller.size(), 2U);
  EXPECT_DOUBLE_EQ(smaller.at(0).edge, 0.9 * apart);
  run(2.0 * apart);
  ASSERT_EQ(smaller.size(), 4U);
  EXPECT_DOUBLE_EQ(smaller.at(2).edge, 0.9 * apart) << "what is smaller already does not grow";
}

TEST_F(LocalRelaxationTest, ASecondTimeShrinksFurther) {
  run();
  run();
  EXPECT_NEAR(spacing(places[0]), 0.49 * apart, 1e-12);
}

TEST_F(LocalRelaxationTest, DoesNotDependOnThreads) {
  const Exchange usual = run();
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  SizeBounds others(surface, 0.3);
  const Spacing same{field, 1.0, &others};
  const Exchange alone = relax_around(places, surface, same, others, 0.0, all, monitor);
  EXPECT_EQ(usual.gone, alone.gone);
  EXPECT_EQ(usual.fresh.points, alone.fresh.points);
}

// What both of its means leave alone.
TEST_F(LocalRelaxationTest, FixedParticlesStay) {
  std::vector<char> fixed(all.size(), 0);
  for (std::size_t n = 0; n < all.size(); n += 3) fixed[n] = 1;
  Particles moved = all;
  for (Vector3d& x : moved.points) x += 0.1 * apart * Vector3d(std::sin(31.0 * x[0]), std::cos(17.0 * x[1]), 0.3);
  const Particles start = moved;
  relax(surface, spacing, moved, 3, monitor, fixed);
  std::size_t same = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (moved.points[n] == start.points[n]) {
      ++same;
      EXPECT_NE(fixed[n], 0);
    }
  }
  EXPECT_EQ(same, (all.size() + 2) / 3);

  // Each is one too many, but only those may go that are not fixed.
  std::vector<char> flags = fixed;
  Particles fewer = all;
  const PopulationChange change = control_population(surface, spacing, fewer, 0.0, 0.1, &flags);
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
