#include "isobench/datasets/generated/generated.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <ostream>

#include "isobench/datasets/generated/generators.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

GeneratedRequest request_of(Generator generator, std::uint64_t seed = 3) {
  GeneratedRequest request;
  request.generator = generator;
  request.seed = seed;
  request.size = {26, 24, 28};
  request.spacing = {1.0, 0.5, 3.0};
  request.quantile = 0.4;
  return request;
}

FloatVolume floats_of(const GeneratedVolume& generated) { return as_float(generated.volume); }

bool is_border_node(const std::array<int, 3>& size, const std::array<int, 3>& node, int layers) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (node[a] < layers || node[a] >= size[a] - layers) return true;
  }
  return false;
}

/// Calls `visit(is within this many layers of the border, sample)` for each node.
template <class Visitor>
void for_each_sample(const FloatVolume& volume, int layers, const Visitor& visit) {
  const auto& size = volume.lattice.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) visit(is_border_node(size, {i, j, k}, layers), volume.at(i, j, k));
    }
  }
}

class EveryGenerator : public testing::TestWithParam<Generator> {};

TEST_P(EveryGenerator, HasAnObjectAwayFromTheBorderOnEitherSideOfTheIsovalue) {
  Monitor monitor;
  for (const Inside inside : {Inside::above, Inside::below}) {
    const GeneratedVolume generated = generate(request_of(GetParam()), inside, monitor);
    EXPECT_EQ(generated.volume.lattice.size, (std::array<int, 3>{26, 24, 28}));
    EXPECT_EQ(generated.volume.lattice.spacing, Eigen::Vector3d(1.0, 0.5, 3.0));
    int within = 0;
    for_each_sample(floats_of(generated), 3, [&](bool at_border, float sample) {
      const bool is_inside = inside == Inside::above ? sample > generated.isovalue : sample < generated.isovalue;
      EXPECT_FALSE(at_border && is_inside) << sample;
      within += is_inside ? 1 : 0;
    });
    EXPECT_GT(within, 20);
  }
}

TEST_P(EveryGenerator, DependsOnItsSeedAndOnNothingElse) {
  Monitor monitor;
  const auto samples = [&](std::uint64_t seed) {
    return generate(request_of(GetParam(), seed), Inside::above, monitor).volume.samples;
  };
  EXPECT_EQ(samples(3), samples(3));
  EXPECT_FALSE(samples(3) == samples(4));
}

INSTANTIATE_TEST_SUITE_P(Generated, EveryGenerator,
                         testing::Values(Generator::random_field, Generator::mask, Generator::foam, Generator::islands),
                         [](const auto& test) {
                           std::string name = to_string(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Generated, GivesTheSameBitsWithAnyNumberOfThreads) {
  for (const Generator generator : {Generator::random_field, Generator::mask, Generator::foam, Generator::islands}) {
    std::vector<float> first;
    for (const std::size_t threads : {1U, 2U, 4U}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      Monitor monitor;
      const FloatVolume volume = floats_of(generate(request_of(generator), Inside::above, monitor));
      if (first.empty()) first = volume.samples;
      EXPECT_EQ(volume.samples, first) << to_string(generator) << " with " << threads << " threads";
    }
  }
}

// Where the field is whole, from the 8th layer on, so many samples are below the isovalue as were asked for.
TEST(Generated, ARandomFieldReachesItsQuantileOnEitherSide) {
  Monitor monitor;
  for (const Inside inside : {Inside::above, Inside::below}) {
    for (const double quantile : {0.1, 0.4, 0.9}) {
      GeneratedRequest request = request_of(Generator::random_field);
      request.quantile = quantile;
      const GeneratedVolume generated = generate(request, inside, monitor);
      int below = 0;
      int whole = 0;
      for_each_sample(floats_of(generated), 7, [&](bool is_faded, float sample) {
        if (is_faded) return;
        ++whole;
        below += sample < generated.isovalue ? 1 : 0;
      });
      EXPECT_EQ(whole, 12 * 10 * 14);
      EXPECT_NEAR(static_cast<double>(below) / whole, quantile, 1.0 / whole);
    }
  }
}

// Neighbouring samples of noise smoothed with sigma have the correlation exp(−1/(4 sigma²)).
TEST(Generated, ALargerCorrelationGivesASmootherField) {
  Monitor monitor;
  for (const double sigma : {1.0, 2.0}) {
    GeneratedRequest request = request_of(Generator::random_field);
    request.size = {48, 48, 48};
    request.correlation = sigma;
    const FloatVolume field = random_field(request, monitor).field;
    double product = 0.0;
    double square = 0.0;
    for (int k = 7; k < 41; ++k) {
      for (int j = 7; j < 41; ++j) {
        for (int i = 7; i < 40; ++i) {
          product += static_cast<double>(field.at(i, j, k)) * field.at(i + 1, j, k);
          square += static_cast<double>(field.at(i, j, k)) * field.at(i, j, k);
        }
      }
    }
    // Some hundred independent places, so a few per cent.
    EXPECT_NEAR(product / square, std::exp(-0.25 / (sigma * sigma)), 0.05) << sigma;
  }
}

TEST(Generated, AMaskIsItsRandomFieldInZerosAndOnes) {
  Monitor monitor;
  const GeneratedVolume mask = generate(request_of(Generator::mask), Inside::above, monitor);
  const GeneratedVolume field = generate(request_of(Generator::random_field), Inside::above, monitor);
  EXPECT_EQ(mask.isovalue, 0.5);
  const auto& labels = mask.volume.samples.as<std::uint8_t>();
  const auto& samples = field.volume.samples.as<float>();
  ASSERT_EQ(labels.size(), samples.size());
  for (std::size_t n = 0; n < labels.size(); ++n) EXPECT_EQ(labels[n], samples[n] > field.isovalue ? 1 : 0);
}

CertifiedTopology topology_of(const GeneratedRequest& request) {
  Monitor monitor;
  GeneratedVolume generated = generate(request, Inside::above, monitor);
  const Isosurface surface(std::move(generated.volume), generated.isovalue, Inside::above);
  return certified_topology(surface, monitor);
}

// Balls of at least 1.5 voxels keep a surface that is a sphere, and a hollow one has a second.
TEST(Generated, IslandsAreAsManySpheresAsWerePlaced) {
  GeneratedRequest request = request_of(Generator::islands);
  request.size = {40, 40, 40};
  request.radii = {1.5, 9.0};
  const std::vector<Island> islands = place_islands(request);
  ASSERT_GT(islands.size(), 10U);
  EXPECT_LT(islands.back().radius, 2.0);
  EXPECT_GT(islands.front().radius, 4.0);
  std::size_t hollow = 0;
  std::size_t near = 0;
  for (std::size_t n = 0; n < islands.size(); ++n) {
    hollow += islands[n].hollow > 0.0 ? 1 : 0;
    for (std::size_t m = 0; m < n; ++m) {
      const double gap = (islands[n].centre - islands[m].centre).norm() - islands[n].radius - islands[m].radius;
      EXPECT_GE(gap, narrowest_gap);
      near += gap <= widest_gap ? 1 : 0;
    }
  }
  EXPECT_GT(hollow, 0U);
  EXPECT_GT(near, 2U);
  const CertifiedTopology topology = topology_of(request);
  ASSERT_TRUE(topology.is_regular);
  EXPECT_FALSE(topology.is_open);
  EXPECT_EQ(topology.components.size(), islands.size() + hollow);
  EXPECT_EQ(topology.euler, 2 * static_cast<long>(islands.size() + hollow));
}

TEST(Generated, FoamOfThickWallsIsOneSurfaceWithHandles) {
  GeneratedRequest request = request_of(Generator::foam);
  request.size = {40, 40, 40};
  request.bubbles = 8;
  request.wall = 3.0;
  const CertifiedTopology topology = topology_of(request);
  ASSERT_TRUE(topology.is_regular);
  EXPECT_FALSE(topology.is_open);
  EXPECT_LE(topology.components.size(), 8U);  // no more than the cells that the cut left closed
}

TEST(Generated, TooManyTooLargeIslandsAreLeftOutAndNoneIsAnError) {
  GeneratedRequest request = request_of(Generator::islands);
  request.islands = 500;
  request.radii = {3.0, 3.0};
  EXPECT_LT(place_islands(request).size(), 500U);
  request.size = {16, 16, 16};
  EXPECT_LE(place_islands(request).front().radius, 0.25 * 9.0);
}

TEST(Generated, ItsDescriptionTellsRequestsApart) {
  const GeneratedRequest request = request_of(Generator::random_field);
  EXPECT_EQ(describe(request),
            "random-field, revision 1, seed 3, size 26 × 24 × 28, spacing 1 × 0.5 × 3 mm, correlation 2 voxels, "
            "quantile 0.4");
  GeneratedRequest other = request;
  other.quantile = 0.41;
  EXPECT_NE(describe(other), describe(request));
  other = request_of(Generator::islands);
  other.radii[0] = 1.1;
  EXPECT_NE(describe(other), describe(request_of(Generator::islands)));
  other = request_of(Generator::foam);
  other.wall = 2.1;
  EXPECT_NE(describe(other), describe(request_of(Generator::foam)));
}

}  // namespace
}  // namespace isobench
