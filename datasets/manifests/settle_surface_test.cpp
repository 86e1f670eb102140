#include "isobench/datasets/manifests/settle_surface.h"

#include <gtest/gtest.h>

#include <string>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

using Node = std::array<int, 3>;

template <class Value>
Dataset dataset_of(int size, double isovalue, Value&& value, Inside inside = Inside::above) {
  FloatVolume volume;
  volume.lattice.size = {size, size, size};
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) volume.samples.push_back(static_cast<float>(value(i, j, k)));
    }
  }
  Dataset dataset;
  dataset.title = "scan";
  dataset.surface = std::make_unique<Isosurface>(std::move(volume), isovalue, inside);
  return dataset;
}

/// Two blocks of `side` nodes that share an edge.
int touching_blocks(int side, int i, int j, int k) {
  const auto within = [&](int n, int first) { return n >= first && n < first + side; };
  return within(k, 4) && ((within(i, 4) && within(j, 4)) || (within(i, 4 + side) && within(j, 4 + side))) ? 1 : 0;
}

std::string refusal(Dataset& dataset, bool exactly = false) {
  Monitor monitor;
  try {
    settle_surface(dataset, {.exact_isovalue = exactly}, monitor);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(SettleSurface, KeepsARegularValueAndItsTopology) {
  const auto ball = [](int i, int j, int k) { return 5.0 - std::hypot(i - 7.5, j - 7.5, k - 7.5); };
  Dataset dataset = dataset_of(16, 0.0, ball);
  Monitor monitor;
  settle_surface(dataset, {.exact_isovalue = true}, monitor);
  EXPECT_EQ(dataset.surface->isovalue(), 0.0);
  EXPECT_FALSE(dataset.asked_isovalue);
  EXPECT_EQ(dataset.topology->euler, 2);
  EXPECT_TRUE(monitor.notes().empty());
}

TEST(SettleSurface, LeavesABackgroundAtTheIsovalueOutside) {
  // Below 0 all but the block of −1 would be inside, out to the border.
  const auto blocks = [](int i, int j, int k) {
    const auto [least, most] = std::minmax({i, j, k});
    return least >= 3 && most < 7 ? 3.0 : least >= 9 && most < 13 ? -1.0 : 0.0;
  };
  Dataset dataset = dataset_of(16, 0.0, blocks);
  Monitor monitor;
  settle_surface(dataset, {}, monitor);
  EXPECT_EQ(dataset.asked_isovalue, 0.0);
  EXPECT_GT(dataset.surface->isovalue(), 0.0);
  EXPECT_EQ(dataset.topology->euler, 2);
}

TEST(SettleSurface, JoinsBlocksThatTouchAndSaysSo) {
  for (const Inside inside : {Inside::above, Inside::below}) {
    const bool above = inside == Inside::above;
    const auto blocks = [above](int i, int j, int k) {
      return (touching_blocks(4, i, j, k) == 1) == above ? 1.0 : 0.0;
    };
    Dataset dataset = dataset_of(16, 0.5, blocks, inside);
    Monitor monitor;
    settle_surface(dataset, {}, monitor);
    // All smaller changes leave a bridge narrower than half a voxel.
    EXPECT_NEAR(dataset.surface->isovalue(), above ? 0.49 : 0.51, 1e-6);
    EXPECT_EQ(dataset.asked_isovalue, 0.5);
    EXPECT_EQ(dataset.topology->euler, 2);
    EXPECT_EQ(dataset.topology->components.size(), 1U);
    ASSERT_EQ(monitor.notes().size(), 1U);
    EXPECT_EQ(monitor.notes()[0].find("scan: F = 0.5 touches itself or fills space in 3 cells, near ("), 0U)
        << monitor.notes()[0];
  }
}

TEST(SettleSurface, PlateausBelongToTheObject) {
  const auto shell = [](int i, int j, int k) {
    const double r = std::hypot(i - 9.5, j - 9.5, k - 9.5);
    return r < 4.0 ? 200.0 : r < 7.0 ? 100.0 : 0.0;
  };
  Dataset dataset = dataset_of(20, 100.0, shell);
  EXPECT_EQ(refusal(dataset), "");
  EXPECT_LT(dataset.surface->isovalue(), 100.0);
  EXPECT_GT(dataset.surface->isovalue(), 97.9);
  EXPECT_EQ(dataset.topology->components.size(), 1U);
  // 5 mm from the middle, within the plateau.
  EXPECT_GT(dataset.surface->value({14.5, 9.5, 9.5}), 0.0);
}

TEST(SettleSurface, RefusesIfAskedTo) {
  Dataset dataset = dataset_of(16, 0.5, [](int i, int j, int k) { return touching_blocks(4, i, j, k); });
  const std::string message = refusal(dataset, true);
  EXPECT_EQ(message.find("isovalue 0.5 is no regular value of F"), 0U) << message;
  EXPECT_EQ(dataset.surface->isovalue(), 0.5);
}

TEST(SettleSurface, RefusesWhatSmoothingRemoves) {
  const auto spike = [](int i, int j, int k) { return i == 4 && j == 4 && k == 4 ? 1.0 : 0.0; };
  Dataset dataset = dataset_of(9, 0.5, spike);  // F's maximum is (2/3)³ = 0.296
  const std::string message = refusal(dataset);
  EXPECT_NE(message.find("stays within 0 to 0.296296 at the nodes"), std::string::npos) << message;
  Dataset lower = dataset_of(9, 0.2, spike);
  EXPECT_EQ(refusal(lower), "");
}

TEST(SettleSurface, LeavesOutSmallComponentsAndSaysSo) {
  const auto balls = [](int i, int j, int k) {
    return std::max(5.0 - std::hypot(i - 7.5, j - 7.5, k - 7.5), 1.5 - std::hypot(i - 18.2, j - 18.3, k - 18.4));
  };
  Dataset dataset = dataset_of(24, 0.0, balls);
  Monitor monitor;
  settle_surface(dataset, {.min_component = 100.0}, monitor);
  EXPECT_EQ(dataset.topology->components.size(), 2U);
  EXPECT_EQ(dataset.topology->kept_components(), 1U);
  EXPECT_EQ(dataset.topology->euler, 2);
  const std::vector<std::string> note = {"scan: 1 of 2 components of F = c enclose less than 100 mm³ and are left out"};
  EXPECT_EQ(monitor.notes(), note);
  EXPECT_EQ(dataset.preparation, std::vector<std::string>{"components below 100 mm³ left out: 1"});
  Dataset both = dataset_of(24, 0.0, balls);
  try {
    settle_surface(both, {.min_component = 1000.0}, monitor);
    FAIL() << "nothing is left";
  } catch (const DataError& error) {
    EXPECT_EQ(std::string(error.what()).find("each of the 2 components of F = 0 encloses less than 1000 mm³"), 0U)
        << error.what();
  }
}

TEST(SettleSurface, ASpeckBetweenNodesIsASurface) {
  // Two voxels side by side: F is 0.296 + 0.074 at each and more half-way between them.
  const auto pair = [](int i, int j, int k) { return (i == 4 || i == 5) && j == 4 && k == 4 ? 1.0 : 0.0; };
  Dataset dataset = dataset_of(10, 0.4, pair);
  EXPECT_EQ(refusal(dataset), "");
  EXPECT_EQ(dataset.topology->components.size(), 1U);
  EXPECT_LT(dataset.surface->value({4.0, 4.0, 4.0}), 0.0);
}

}  // namespace
}  // namespace isobench
