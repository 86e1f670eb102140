// What the metric makes of the proof. datasets/topology/ tests the proof itself.
#include <gtest/gtest.h>

#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"

namespace isobench {
namespace {

template <class Value>
FloatVolume sampled(Value&& value) {
  FloatVolume volume;
  volume.lattice.size = {24, 22, 20};
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 22; ++j) {
      for (int i = 0; i < 24; ++i) volume.samples.push_back(static_cast<float>(value(i, j, k)));
    }
  }
  return volume;
}

Measurement measured(const MeasuredAgainst& against) {
  TriangleMesh mesh = sample_meshes::box({8, 8, 8}, {12, 12, 12});
  Monitor monitor;
  return measure(mesh, against, monitor);
}

void expect_reference(const Isosurface& surface, double euler, double components) {
  const Measurement found = measured({.surface = &surface});
  EXPECT_EQ(found.figure("euler_reference"), euler);
  EXPECT_EQ(found.figure("components_reference"), components);
}

void expect_none(const Isosurface& surface) {
  const Measurement found = measured({.surface = &surface});
  EXPECT_EQ(found.figure("euler_reference"), std::nullopt);
  EXPECT_EQ(found.figure("components_reference"), std::nullopt);
  EXPECT_TRUE(found.figure("distance_max").has_value()) << "other figures are measured";
}

TEST(ReferenceTopology, OfASphereAndATorus) {
  expect_reference(Isosurface(sample_phantom(phantom("sphere"), 32), 0.0), 2.0, 1.0);
  expect_reference(Isosurface(sample_phantom(phantom("torus"), 32), 0.0), 0.0, 1.0);
}

// Two bodies, joined by a bridge of some hundredths of a voxel or separated by a gap of that size. The signs at the
// nodes, and at those of a lattice three times as fine, are the same.
TEST(ReferenceTopology, TellsABridgeFromAGapThatNoNodeShows) {
  const auto dumb_bell = [](double off) {
    const auto f = [](double x, double y, double z) {
      return std::exp(-(std::pow(x - 5.9, 2) + y * y + z * z) / 12.0) +
             std::exp(-(std::pow(x - 14.2, 2) + y * y + z * z) / 12.0);
    };
    const double between = f(0.5 * (5.9 + 14.2), 0.0, 0.0) + off;
    return Isosurface(sampled([&](int i, int j, int k) { return f(i, j - 10.47, k - 9.53) - between; }), 0.0,
                      Inside::above, Kernel::interpolating_bspline);
  };
  expect_reference(dumb_bell(-0.0005), 2.0, 1.0);
  expect_reference(dumb_bell(0.0005), 4.0, 2.0);
}

// F of a block of ones is a product of functions of x, y and z. Where m voxels are one, such a function is 23/24 (m =
// 2) or 2/3 (m = 1) in the middle, and 5/6 at either node of m = 2.
TEST(ReferenceTopology, OfAMaskWithSpecks) {
  const auto mask = [](int plate) {
    return sampled([plate](int i, int j, int k) {
      const bool block = i >= 3 && i < 9 && j >= 3 && j < 9 && k >= 3 && k < 9;
      const bool speck = i >= 14 && i < 16 && j >= 14 && j < 14 + plate && k == 6;
      return block || speck ? 1.0 : 0.0;
    });
  };
  // Two by two voxels: 0.61 between the nodes, but 0.46 at each node.
  expect_reference(Isosurface(mask(2), 0.5), 4.0, 2.0);
  // Two by one: nowhere above 0.43.
  expect_reference(Isosurface(mask(1), 0.5), 2.0, 1.0);
}

TEST(ReferenceTopology, IsNotMeasuredWhereTheSurfaceTouchesItself) {
  // Two blocks of a mask that share an edge: there F is 0.5, with a gradient of zero.
  const FloatVolume blocks = sampled([](int i, int j, int k) {
    const bool first = i >= 3 && i < 8 && j >= 3 && j < 8;
    const bool second = i >= 8 && i < 13 && j >= 8 && j < 13;
    return k >= 3 && k < 13 && (first || second) ? 1.0 : 0.0;
  });
  expect_none(Isosurface(blocks, 0.5));
  expect_reference(Isosurface(blocks, 0.49), 2.0, 1.0);
}

TEST(ReferenceTopology, IsNotMeasuredWhereTheSurfaceLeavesTheVolume) {
  const auto ball = [](double x) {
    return Isosurface(sampled([x](int i, int j, int k) { return 5.3 - std::hypot(i - x, j - 10.4, k - 9.6); }), 0.0);
  };
  expect_reference(ball(11.7), 2.0, 1.0);
  expect_none(ball(2.2));
}

TEST(ReferenceTopology, IsTakenFromTheCallerWhoHasIt) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 32), 0.0);
  Monitor monitor;
  const Isosurface other(sample_phantom(phantom("two-spheres"), 48), 0.0);
  const CertifiedTopology known = certified_topology(other, monitor);
  const Measurement found = measured({.surface = &surface, .topology = &known});
  EXPECT_EQ(found.figure("euler_reference"), 4.0);
  EXPECT_EQ(found.figure("components_reference"), 2.0);
}

}  // namespace
}  // namespace isobench
