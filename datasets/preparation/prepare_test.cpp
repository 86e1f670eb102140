#include "isobench/datasets/preparation/prepare.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

FloatVolume make_volume(const std::array<int, 3>& size, const Eigen::Vector3d& spacing = Eigen::Vector3d::Ones()) {
  FloatVolume volume;
  volume.lattice.size = size;
  volume.lattice.spacing = spacing;
  volume.lattice.origin = {5.0, -3.0, 11.0};
  volume.lattice.direction = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, -1.0, 2.0).normalized()).toRotationMatrix();
  volume.samples.assign(volume.lattice.nodes(), 0.0F);
  return volume;
}

FloatVolume random_binary(const std::array<int, 3>& size, const Eigen::Vector3d& spacing, double share) {
  FloatVolume volume = make_volume(size, spacing);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (float& sample : volume.samples) sample = uniform(random) < share ? 1.0F : 0.0F;
  return volume;
}

FloatVolume apply(FloatVolume volume, const PrepareStep& step) {
  Monitor monitor;
  return as_float(prepare(std::move(volume), {step}, monitor));
}

template <class Visit>
void for_nodes(const Lattice& lattice, Visit visit) {
  for (int k = 0; k < lattice.size[2]; ++k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i) visit(i, j, k);
    }
  }
}

Eigen::Vector3d world(const Lattice& lattice, double i, double j, double k) {
  return lattice.to_world(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)));
}

/// The signed distance to the nearest node on the other side, found by looking at all nodes.
double brute_force_distance(const FloatVolume& binary, int i, int j, int k) {
  const bool inside = binary.at(i, j, k) > 0.0F;
  double nearest = std::numeric_limits<double>::infinity();
  for_nodes(binary.lattice, [&](int x, int y, int z) {
    if ((binary.at(x, y, z) > 0.0F) == inside) return;
    nearest = std::min(nearest, binary.lattice.spacing.cwiseProduct(Eigen::Vector3d(x - i, y - j, z - k)).norm());
  });
  return inside ? nearest : -nearest;
}

TEST(PrepareSignedDistance, EqualsBruteForceOnAnisotropicLattices) {
  for (const double share : {0.003, 0.1, 0.5, 0.98}) {
    const FloatVolume binary = random_binary({13, 9, 11}, {0.7, 1.3, 2.9}, share);
    const FloatVolume distance = apply(binary, SignedDistance{});
    // 1e-5: squared distances pass through single precision twice.
    for_nodes(binary.lattice, [&](int i, int j, int k) {
      EXPECT_NEAR(distance.at(i, j, k), brute_force_distance(binary, i, j, k), 1e-5);
    });
  }
}

TEST(PrepareSignedDistance, OfAHalfSpaceHasNoZeroAndAJumpOfTwoSpacings) {
  FloatVolume volume = make_volume({8, 5, 6}, {1.0, 1.0, 3.0});
  for_nodes(volume.lattice, [&](int i, int j, int k) { volume.at(i, j, k) = k >= 3 ? 1.0F : 0.0F; });
  const FloatVolume distance = apply(volume, SignedDistance{});
  for_nodes(volume.lattice, [&](int i, int j, int k) {
    EXPECT_EQ(distance.at(i, j, k), k >= 3 ? 3.0F * static_cast<float>(k - 2) : 3.0F * static_cast<float>(k - 3));
  });
}

TEST(PrepareSignedDistance, RefusesVolumesWithoutInsideOrOutside) {
  EXPECT_THROW(apply(make_volume({4, 4, 4}), SignedDistance{}), DataError);
  FloatVolume full = make_volume({4, 4, 4});
  full.samples.assign(full.samples.size(), 1.0F);
  EXPECT_THROW(apply(full, SignedDistance{}), DataError);
}

TEST(PrepareGaussian, OfAnImpulseIsTheSampledKernelAndKeepsTheSum) {
  FloatVolume volume = make_volume({41, 31, 27}, {0.5, 1.0, 2.0});
  volume.at(20, 15, 13) = 1.0F;
  const Eigen::Vector3d sigma(1.5, 0.8, 1.0);
  const FloatVolume smooth = apply(volume, Gaussian{sigma});
  double sum = 0.0;
  for (const float sample : smooth.samples) sum += sample;
  EXPECT_NEAR(sum, 1.0, 1e-5);
  const auto weight = [&](int axis, int t) {
    double total = 0.0;
    const int radius = static_cast<int>(std::lround(4.0 * sigma[axis]));
    if (std::abs(t) > radius) return 0.0;
    for (int n = -radius; n <= radius; ++n) total += std::exp(-0.5 * n * n / (sigma[axis] * sigma[axis]));
    return std::exp(-0.5 * t * t / (sigma[axis] * sigma[axis])) / total;
  };
  for_nodes(volume.lattice, [&](int i, int j, int k) {
    EXPECT_NEAR(smooth.at(i, j, k), weight(0, i - 20) * weight(1, j - 15) * weight(2, k - 13), 1e-7);
  });
}

TEST(PrepareGaussian, RepeatsTheBorder) {
  FloatVolume volume = make_volume({6, 5, 3});  // thinner than the kernel
  for_nodes(volume.lattice, [&](int i, int j, int k) { volume.at(i, j, k) = static_cast<float>(3 * i - j + 7 * k); });
  const FloatVolume smooth = apply(volume, Gaussian{{1.2, 1.2, 1.2}});
  const int radius = 5;
  double total = 0.0;
  for (int t = -radius; t <= radius; ++t) total += std::exp(-0.5 * t * t / 1.44);
  const auto along = [&](int n, int count) {
    double sum = 0.0;
    for (int t = -radius; t <= radius; ++t) sum += std::exp(-0.5 * t * t / 1.44) * std::clamp(n + t, 0, count - 1);
    return sum / total;
  };
  // The samples are linear, so each axis can be filtered on its own.
  for_nodes(volume.lattice, [&](int i, int j, int k) {
    EXPECT_NEAR(smooth.at(i, j, k), 3.0 * along(i, 6) - along(j, 5) + 7.0 * along(k, 3), 1e-5);
  });
}

TEST(PrepareLargestComponent, JoinsAcrossCornersAndDropsTheRest) {
  FloatVolume volume = make_volume({9, 9, 9});
  // A diagonal chain of 9 nodes that touch only at corners, and a separate block of 8 nodes.
  for (int n = 0; n < 9; ++n) volume.at(n, 8 - n, n) = 2.0F;
  for (int n = 0; n < 8; ++n) volume.at(n & 1, n >> 1 & 1, n >> 2) = 1.0F;
  const FloatVolume largest = apply(volume, LargestComponent{});
  for_nodes(volume.lattice,
            [&](int i, int j, int k) { EXPECT_EQ(largest.at(i, j, k), i == k && j == 8 - i ? 2.0F : 0.0F); });
  EXPECT_THROW(apply(make_volume({3, 3, 3}), LargestComponent{}), DataError);
}

/// The nodes of the largest 26-connected component, found by flooding.
std::vector<bool> flooded_largest(const FloatVolume& volume) {
  const Lattice& lattice = volume.lattice;
  std::vector<int> label(lattice.nodes(), 0);
  std::vector<int> sizes{0};
  for_nodes(lattice, [&](int i, int j, int k) {
    if (volume.at(i, j, k) <= 0.0F || label[lattice.index(i, j, k)] != 0) return;
    const int current = static_cast<int>(sizes.size());
    sizes.push_back(0);
    std::vector<std::array<int, 3>> open{{i, j, k}};
    label[lattice.index(i, j, k)] = current;
    while (!open.empty()) {
      const auto [x, y, z] = open.back();
      open.pop_back();
      ++sizes.back();
      for (int n = 0; n < 27; ++n) {
        const int u = x + n % 3 - 1, v = y + n / 3 % 3 - 1, w = z + n / 9 - 1;
        if (u < 0 || v < 0 || w < 0 || u >= lattice.size[0] || v >= lattice.size[1] || w >= lattice.size[2]) continue;
        if (volume.at(u, v, w) <= 0.0F || label[lattice.index(u, v, w)] != 0) continue;
        label[lattice.index(u, v, w)] = current;
        open.push_back({u, v, w});
      }
    }
  });
  const auto largest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<bool> kept;
  for (const int l : label) kept.push_back(l == largest);
  return kept;
}

TEST(PrepareLargestComponent, EqualsFloodingOnRandomNodes) {
  for (const double share : {0.03, 0.06, 0.1, 0.3}) {
    const FloatVolume volume = random_binary({23, 17, 19}, Eigen::Vector3d::Ones(), share);
    const std::vector<bool> expected = flooded_largest(volume);
    const FloatVolume largest = apply(volume, LargestComponent{});
    for (std::size_t n = 0; n < expected.size(); ++n) ASSERT_EQ(largest.samples[n] > 0.0F, expected[n]) << share;
  }
}

TEST(PrepareCropAndPad, KeepEveryNodeAtItsPlaceInTheWorld) {
  FloatVolume volume = make_volume({12, 10, 8}, {0.5, 1.5, 2.0});
  volume.at(3, 4, 2) = 7.0F;
  volume.at(8, 5, 6) = 9.0F;
  const FloatVolume cropped = apply(volume, Crop{});
  EXPECT_EQ(cropped.lattice.size, (std::array<int, 3>{6, 2, 5}));
  EXPECT_EQ(cropped.at(0, 0, 0), 7.0F);
  EXPECT_EQ(cropped.at(5, 1, 4), 9.0F);
  EXPECT_LT((world(cropped.lattice, 0, 0, 0) - world(volume.lattice, 3, 4, 2)).norm(), 1e-12);
  const FloatVolume with_margin = apply(volume, Crop{3});  // the far side in z has only one node left
  EXPECT_EQ(with_margin.lattice.size, (std::array<int, 3>{12, 8, 8}));
  EXPECT_LT((world(with_margin.lattice, 3, 3, 2) - world(volume.lattice, 3, 4, 2)).norm(), 1e-12);
  EXPECT_EQ(with_margin.at(3, 3, 2), 7.0F);
  const FloatVolume padded = apply(cropped, Pad{4, -1.0});
  EXPECT_EQ(padded.lattice.size, (std::array<int, 3>{14, 10, 13}));
  EXPECT_EQ(padded.at(4, 4, 4), 7.0F);
  EXPECT_EQ(padded.at(3, 4, 4), -1.0F);
  EXPECT_LT((world(padded.lattice, 4, 4, 4) - world(volume.lattice, 3, 4, 2)).norm(), 1e-12);
  EXPECT_THROW(apply(make_volume({4, 4, 4}), Crop{}), DataError);
}

TEST(PrepareResample, IsExactForLinearFunctionsOfTheWorld) {
  FloatVolume volume = make_volume({7, 6, 5}, {1.0, 2.0, 3.0});
  const auto linear = [](const Eigen::Vector3d& x) { return 1.0 + 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2]; };
  for_nodes(volume.lattice, [&](int i, int j, int k) {
    volume.at(i, j, k) = static_cast<float>(linear(world(volume.lattice, i, j, k)));
  });
  const FloatVolume fine = apply(volume, Resample{{1.0, 0.9, 1.0}});
  EXPECT_EQ(fine.lattice.size, (std::array<int, 3>{7, 12, 13}));
  EXPECT_NEAR(fine.lattice.spacing[1], 10.0 / 11.0, 1e-12);  // so that the last node stays where it is
  EXPECT_LT((world(fine.lattice, 6, 11, 12) - world(volume.lattice, 6, 5, 4)).norm(), 1e-12);
  for_nodes(fine.lattice,
            [&](int i, int j, int k) { EXPECT_NEAR(fine.at(i, j, k), linear(world(fine.lattice, i, j, k)), 1e-4); });
}

TEST(PrepareSubsample, AveragesBlocksAtTheirMiddle) {
  FloatVolume volume = make_volume({7, 6, 4}, {1.0, 2.0, 3.0});
  const auto linear = [](const Eigen::Vector3d& x) { return 1.0 + 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2]; };
  for_nodes(volume.lattice, [&](int i, int j, int k) {
    volume.at(i, j, k) = static_cast<float>(linear(world(volume.lattice, i, j, k)));
  });
  const FloatVolume coarse = apply(volume, Subsample{2});
  EXPECT_EQ(coarse.lattice.size, (std::array<int, 3>{3, 3, 2}));
  // The mean of a linear function over a block is its value at the block's middle.
  for_nodes(coarse.lattice, [&](int i, int j, int k) {
    EXPECT_NEAR(coarse.at(i, j, k), linear(world(coarse.lattice, i, j, k)), 1e-4);
  });
  EXPECT_THROW(apply(volume, Subsample{5}), DataError);
}

TEST(PrepareCloseBorder, AddsLayersOnlyWhereTheObjectLeaves) {
  for (const bool below : {false, true}) {
    // A bar along z that comes to the lower end, and one layer short of the upper one.
    FloatVolume volume = make_volume({9, 8, 7}, {1.0, 2.0, 3.0});
    const auto value = [below](bool inside) { return inside != below ? 100.0F : 20.0F; };
    for_nodes(volume.lattice,
              [&](int i, int j, int k) { volume.at(i, j, k) = value(i >= 3 && i < 6 && j >= 3 && j < 5 && k < 6); });
    Monitor monitor;
    const Volume prepared = prepare(Volume(volume), {CloseBorder{50.0, below}}, monitor);
    const FloatVolume closed = as_float(prepared);
    EXPECT_EQ(closed.lattice.size, (std::array<int, 3>{9, 8, 13}));
    EXPECT_LT((world(closed.lattice, 0, 0, 3) - world(volume.lattice, 0, 0, 0)).norm(), 1e-12);
    for_nodes(closed.lattice, [&](int i, int j, int k) {
      const bool added = k < 3 || k >= 10;
      const float outside = below ? 80.0F : 0.0F;  // as far from 50 as the object
      EXPECT_EQ(closed.at(i, j, k), added ? outside : volume.at(i, j, k - 3));
    });
    // Six nodes at the lower end, each with a face of 1 × 2 mm².
    EXPECT_EQ(monitor.notes(),
              std::vector<std::string>{
                  "the object reaches the volume's border on 2 sides; 12 mm² of it were closed, outside"});
  }
}

TEST(PrepareCloseBorder, LeavesAnObjectThatStaysWithinAsItIs) {
  FloatVolume volume = make_volume({7, 7, 7});
  volume.at(3, 3, 3) = 1.0F;
  Monitor monitor;
  EXPECT_EQ(as_float(prepare(Volume(volume), {CloseBorder{0.5, false}}, monitor)).samples, volume.samples);
  EXPECT_TRUE(monitor.notes().empty());
}

TEST(PrepareSelect, ThresholdAndLabelsMakeBinaryVolumes) {
  FloatVolume volume = make_volume({5, 1, 1});
  volume.samples = {0.0F, 1.0F, 2.0F, 3.0F, 0.5F};
  EXPECT_EQ(apply(volume, Threshold{0.5}).samples, (std::vector<float>{0, 1, 1, 1, 1}));
  EXPECT_EQ(apply(volume, SelectLabels{{1, 3}}).samples, (std::vector<float>{0, 1, 0, 1, 0}));
  EXPECT_THROW(apply(volume, SelectLabels{{7}}), DataError);
  try {
    apply(volume, Threshold{4.0});
    ADD_FAILURE();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("[0, 3]"), std::string::npos) << error.what();  // says the range
  }
}

TEST(Prepare, GivesTheSameBitsWithAnyNumberOfThreads) {
  const FloatVolume volume = random_binary({40, 33, 29}, {0.7, 1.0, 1.4}, 0.4);
  const std::vector<PrepareStep> steps = {
      LargestComponent{},        Crop{},       Pad{3},          SignedDistance{}, Resample{{0.5, 0.5, 0.5}},
      Gaussian{{1.0, 1.0, 1.0}}, Subsample{2}, CloseBorder{0.5}};
  std::vector<float> first;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Monitor monitor;
    const FloatVolume prepared = as_float(prepare(volume, steps, monitor));
    if (first.empty()) first = prepared.samples;
    EXPECT_EQ(prepared.samples, first) << threads;
    EXPECT_GT(monitor.seconds("prepare/signed-distance"), 0.0);
  }
}

TEST(Prepare, StopsWhereTheMonitorIsCancelled) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(prepare(make_volume({4, 4, 4}), {Pad{}}, monitor), Cancelled);
}

TEST(Prepare, DescribesEveryStepInALine) {
  const std::vector<PrepareStep> steps = {
      Threshold{0.5}, SelectLabels{{1, 3}}, LargestComponent{},       Crop{8},
      Pad{2, -1.5},   Resample{{1, 1, 1}},  SignedDistance{},         Gaussian{{0.8, 0.8, 0.5}},
      CloseBorder{},  Subsample{3},         Cut{{1, 2, 3}, {4, 5, 6}}};
  std::vector<std::string> lines;
  for (const PrepareStep& step : steps) {
    lines.push_back(describe(step));
    EXPECT_EQ(lines.back().find('\n'), std::string::npos);
  }
  EXPECT_EQ(lines[1], "labels {1, 3}");
  EXPECT_EQ(lines[7], "gaussian sigma = (0.8, 0.8, 0.5) voxels");
  EXPECT_NE(describe(Crop{8}), describe(Crop{7}));
  EXPECT_NE(describe(CloseBorder{1.0}), describe(CloseBorder{2.0}));
  EXPECT_NE(describe(CloseBorder{1.0, false}), describe(CloseBorder{1.0, true}));
}

TEST(PrepareBadInput, StepsThatAskForTheImpossible) {
  FloatVolume volume;
  volume.lattice.size = {4, 4, 4};
  volume.samples.assign(64, 1.0F);
  Monitor monitor;
  EXPECT_THROW(prepare(volume, {Pad{1000000000, 0.0}}, monitor), DataError);
  EXPECT_THROW(prepare(volume, {Resample{Eigen::Vector3d::Constant(1e-5)}}, monitor), DataError);
  EXPECT_THROW(prepare(volume, {Subsample{2000000000}}, monitor), DataError);
  // A sigma whose square is 0 changes nothing.
  EXPECT_EQ(prepare(volume, {Gaussian{Eigen::Vector3d::Constant(1e-200)}}, monitor).samples, volume.samples);
}

}  // namespace
}  // namespace isobench
