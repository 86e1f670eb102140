#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "isobench/datasets/preparation/prepare.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

/// Samples 100 i + 10 j + k on a turned lattice.
Volume numbered_volume() {
  FloatVolume volume;
  volume.lattice.size = {7, 6, 5};
  volume.lattice.spacing = {0.5, 1.0, 2.5};
  volume.lattice.origin = {5.0, -3.0, 11.0};
  volume.lattice.direction = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, -1.0, 2.0).normalized()).toRotationMatrix();
  volume.samples.resize(volume.lattice.nodes());
  for (int k = 0; k < 5; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = 0; i < 7; ++i) volume.at(i, j, k) = static_cast<float>(100 * i + 10 * j + k);
    }
  }
  return volume;
}

TEST(Cut, KeepsTheNodesOfTheBlockAtTheirPlace) {
  const Volume before = numbered_volume();
  Monitor monitor;
  const FloatVolume after = as_float(prepare(before, {Cut{{2, 1, 3}, {4, 5, 2}}}, monitor));
  EXPECT_EQ(after.lattice.size, (std::array<int, 3>{4, 5, 2}));
  EXPECT_EQ(after.at(0, 0, 0), 213.0F);
  EXPECT_EQ(after.at(3, 4, 1), 554.0F);
  const Eigen::Vector3d first = before.lattice.to_world(before.lattice.spacing.cwiseProduct(Eigen::Vector3d(2, 1, 3)));
  EXPECT_LT((after.lattice.to_world(Eigen::Vector3d::Zero()) - first).norm(), 1e-12);
  EXPECT_EQ(after.lattice.spacing, before.lattice.spacing);
}

TEST(Cut, TheWholeVolumeStaysAsItIsAndKeepsItsType) {
  Volume bytes;
  bytes.lattice.size = {2, 2, 2};
  bytes.samples = std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8};
  Monitor monitor;
  EXPECT_EQ(prepare(bytes, {Cut{{0, 0, 0}, {2, 2, 2}}}, monitor).samples, bytes.samples);
}

TEST(Cut, BeyondTheVolumeIsAnErrorThatSaysWhere) {
  Monitor monitor;
  for (const Cut& step : {Cut{{2, 1, 3}, {4, 5, 3}}, Cut{{0, 0, 5}, {1, 1, 1}}}) {
    try {
      prepare(numbered_volume(), {step}, monitor);
      ADD_FAILURE() << describe(step);
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find("to 5 are asked for along axis k"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("nodes 0 to 4"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(prepare(numbered_volume(), {Cut{{2147483647, 0, 0}, {2147483647, 1, 1}}}, monitor), DataError);
}

}  // namespace
}  // namespace isobench
