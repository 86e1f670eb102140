// The proof against closed forms, against itself under symmetries, and on values that are no regular values.
#include "isobench/datasets/topology/certified_topology.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/random.h"

namespace isobench {
namespace {

using Size = std::array<int, 3>;

template <class Value>
FloatVolume volume_of(const Size& size, Value&& value) {
  FloatVolume volume;
  volume.lattice.size = size;
  volume.samples.reserve(volume.lattice.nodes());
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) volume.samples.push_back(static_cast<float>(value(i, j, k)));
    }
  }
  return volume;
}

bool is_on_border(const Size& size, int i, int j, int k) {
  return std::min({i, j, k, size[0] - 1 - i, size[1] - 1 - j, size[2] - 1 - k}) < 2;
}

CertifiedTopology topology_of(const FloatVolume& volume, double isovalue, double cut_at = usual_cut) {
  Monitor monitor;
  return certified_topology(Isosurface(volume, isovalue), monitor, cut_at);
}

void expect_topology(const CertifiedTopology& found, long euler, std::size_t components) {
  EXPECT_TRUE(found.is_regular);
  EXPECT_EQ(found.euler, euler);
  EXPECT_EQ(found.components.size(), components);
}

/// Noise in [0, 1), averaged over neighbours, and 0 on the border.
FloatVolume noise(std::uint64_t seed, const Size& size) {
  FloatVolume volume = volume_of(size, [&](int i, int j, int k) {
    double sum = 0.0;
    for (int n = 0; n < 8; ++n) {
      const int node = (k + (n >> 2 & 1)) * 10000 + (j + (n >> 1 & 1)) * 100 + i + (n & 1);
      sum += uniform_random(seed, static_cast<std::uint64_t>(node), 0);
    }
    return is_on_border(size, i, j, k) ? 0.0 : sum / 8.0;
  });
  return volume;
}

FloatVolume mask(const FloatVolume& values, float threshold) {
  FloatVolume result = values;
  for (float& sample : result.samples) sample = sample > threshold ? 1.0F : 0.0F;
  return result;
}

/// The volume with its axes exchanged cyclically `turns` times, and mirrored along the first axis.
FloatVolume turned(const FloatVolume& volume, int turns, bool mirrored) {
  const Size& from = volume.lattice.size;
  const auto at = [turns](const Size& of, int axis) { return of[static_cast<std::size_t>((axis + turns) % 3)]; };
  return volume_of({at(from, 0), at(from, 1), at(from, 2)}, [&](int i, int j, int k) {
    Size node{};
    const Size here = {mirrored ? at(from, 0) - 1 - i : i, j, k};
    for (int axis = 0; axis < 3; ++axis)
      node[static_cast<std::size_t>((axis + turns) % 3)] = here[static_cast<std::size_t>(axis)];
    return volume.at(node[0], node[1], node[2]);
  });
}

class CertifiedPhantom : public testing::TestWithParam<Phantom> {};

TEST_P(CertifiedPhantom, HasItsEulerCharacteristicAndComponents) {
  const Phantom& shape = GetParam();
  // The lattice must not join what is close.
  const bool is_thin = shape.smallest_feature || shape.smallest_radius;
  const CertifiedTopology found = topology_of(sample_phantom(shape, is_thin ? 128 : 48), 0.0);
  expect_topology(found, shape.euler, static_cast<std::size_t>(shape.components));
  EXPECT_FALSE(found.is_open);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, CertifiedPhantom, testing::ValuesIn(phantoms()), [](const auto& chosen) {
  std::string name = chosen.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// The same answer for another cut, mirrored, with axes exchanged, and for values next to c. Returns whether 0.5 is a
/// regular value.
bool expect_the_same_from_all_sides(const FloatVolume& volume) {
  const CertifiedTopology found = topology_of(volume, 0.5);
  const auto same = [&](const CertifiedTopology& other) {
    EXPECT_EQ(other.is_regular, found.is_regular);
    EXPECT_EQ(other.euler, found.euler);
    EXPECT_EQ(other.components.size(), found.components.size());
  };
  same(topology_of(volume, 0.5, 0.5214));
  same(topology_of(turned(volume, 0, true), 0.5));
  same(topology_of(turned(volume, 1, false), 0.5));
  same(topology_of(turned(volume, 2, true), 0.5));
  if (found.is_regular) {
    same(topology_of(volume, 0.5 + 1e-9));
    same(topology_of(volume, 0.5 - 1e-9));
  }
  return found.is_regular;
}

TEST(CertifiedTopology, IsTheSameFromAllSides) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const FloatVolume field = noise(seed, {11, 12, 13});
    EXPECT_TRUE(expect_the_same_from_all_sides(field)) << seed;
    EXPECT_TRUE(expect_the_same_from_all_sides(mask(field, 0.55F))) << seed;
  }
}

TEST(CertifiedTopologyOfAThousandSurfaces, IsTheSameFromAllSides) {
  std::size_t regular_masks = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const int n = 12 + static_cast<int>(seed % 9);
    const FloatVolume field = noise(1000 + seed, {n, n + 1, n + 2});
    EXPECT_TRUE(expect_the_same_from_all_sides(field)) << seed;
    // Of a mask, 0.5 need not be a regular value, where blocks share no more than an edge or a corner.
    if (expect_the_same_from_all_sides(mask(field, 0.5F + 0.01F * static_cast<float>(seed % 13)))) ++regular_masks;
  }
  EXPECT_GT(regular_masks, 250U);
  RecordProperty("regular_masks", static_cast<int>(regular_masks));
}

// As in soft tissue of a CT scan, values differ by little of the range. So of the many boxes some always have a corner
// with a value within same_value of c, and for values nearby others have.
TEST(CertifiedTopologyOfFaintNoise, IsProven) {
  const Size size{56, 56, 56};
  const FloatVolume field = volume_of(size, [&](int i, int j, int k) {
    const int node = (k * 56 + j) * 56 + i;
    const double faint = 0.004 * (uniform_random(7, static_cast<std::uint64_t>(node), 0) - 0.5);
    return is_on_border(size, i, j, k) ? 0.0 : 0.5 + faint;
  });
  const CertifiedTopology found = topology_of(field, 0.5);
  ASSERT_TRUE(found.is_regular);
  EXPECT_NE(found.counted_at, 0.0);
  const CertifiedTopology other = topology_of(field, 0.5, 0.5214);
  EXPECT_EQ(other.euler, found.euler);
  EXPECT_EQ(other.components.size(), found.components.size());
}

TEST(CertifiedTopology, DoesNotDependOnThreads) {
  const FloatVolume field = noise(5, {20, 20, 20});
  const CertifiedTopology many = topology_of(field, 0.5);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const CertifiedTopology single = topology_of(field, 0.5);
  expect_topology(single, many.euler, many.components.size());
  for (std::size_t n = 0; n < single.components.size(); ++n) {
    EXPECT_EQ(single.components[n].euler, many.components[n].euler);
    EXPECT_EQ(single.components[n].boxes, many.components[n].boxes);
  }
}

// A speck whose peak is 0.001 above c lies between the nodes of any lattice of signs that is not very fine.
TEST(CertifiedTopology, FindsSpecksBetweenNodes) {
  const FloatVolume volume = volume_of({20, 12, 12}, [](int i, int j, int k) {
    const bool ball = i >= 11 && i < 16 && j >= 3 && j < 9 && k >= 3 && k < 9;
    const bool speck = (i == 4 || i == 5) && (j == 5 || j == 6) && (k == 5 || k == 6);
    return ball || speck ? 1.0 : 0.0;
  });
  // F in the middle of the speck's eight nodes. F at these nodes is 0.58.
  const double peak = std::pow(23.0 / 24.0, 3);
  expect_topology(topology_of(volume, peak - 1e-3), 4, 2);
  expect_topology(topology_of(volume, peak - 1e-6), 4, 2);
  expect_topology(topology_of(volume, peak + 1e-6), 2, 1);
}

TEST(CertifiedTopology, ATouchIsNoRegularValue) {
  // Two blocks that share an edge: F = 0.5 along it, with a gradient of zero.
  const FloatVolume volume = volume_of({14, 14, 14}, [](int i, int j, int k) {
    const bool first = i >= 3 && i < 7 && j >= 3 && j < 7;
    const bool second = i >= 7 && i < 11 && j >= 7 && j < 11;
    return k >= 3 && k < 11 && (first || second) ? 1.0 : 0.0;
  });
  const CertifiedTopology found = topology_of(volume, 0.5);
  EXPECT_FALSE(found.is_regular);
  ASSERT_FALSE(found.singular.empty());
  for (const CellBox& box : found.singular) {
    EXPECT_NEAR(box.low.x(), 6.5, 1e-3);
    EXPECT_NEAR(box.low.y(), 6.5, 1e-3);
  }
  expect_topology(topology_of(volume, 0.49), 2, 1);
  expect_topology(topology_of(volume, 0.51), 4, 2);
}

TEST(CertifiedTopology, APlateauIsNoRegularValue) {
  const FloatVolume volume = volume_of({16, 16, 16}, [](int i, int j, int k) {
    const double r = std::hypot(std::hypot(i - 7.5, j - 7.5), k - 7.5);
    return r < 3.0 ? 2.0 : r < 6.0 ? 1.0 : 0.0;
  });
  const CertifiedTopology found = topology_of(volume, 1.0);
  EXPECT_FALSE(found.is_regular);
  EXPECT_FALSE(found.singular.empty());
  expect_topology(topology_of(volume, 1.01), 2, 1);
  expect_topology(topology_of(volume, 0.99), 2, 1);
}

TEST(CertifiedTopology, ASurfaceThatLeavesTheLatticeIsOpen) {
  const Size size = {12, 13, 14};
  const auto expect_open = [](const FloatVolume& volume, long euler, std::size_t components) {
    const CertifiedTopology found = topology_of(volume, 0.0);
    expect_topology(found, euler, components);
    EXPECT_TRUE(found.is_open);
  };
  // Discs: a plane, and balls around the corners and the middles of the faces of the lattice.
  expect_open(volume_of(size, [](int i, int j, int k) { return 7.3 - k - 0.3 * i + 0.2 * j; }), 1, 1);
  for (const double x : {0.0, 5.5, 11.0}) {
    for (const double y : {0.0, 6.0, 12.0}) {
      for (const double z : {0.0, 6.5, 13.0}) {
        const bool is_middle = x == 5.5 && y == 6.0 && z == 6.5;
        const FloatVolume ball =
            volume_of(size, [&](int i, int j, int k) { return 4.3 - std::hypot(i - x, j - y, k - z); });
        if (!is_middle) expect_open(ball, 1, 1);
      }
    }
  }
  // Tubes along each axis, open at both ends.
  expect_open(volume_of(size, [](int, int j, int k) { return 3.3 - std::hypot(j - 6.1, k - 6.2); }), 0, 1);
  expect_open(volume_of(size, [](int i, int, int k) { return 3.3 - std::hypot(i - 5.2, k - 6.2); }), 0, 1);
  expect_open(volume_of(size, [](int i, int j, int) { return 3.3 - std::hypot(i - 5.2, j - 6.1); }), 0, 1);
}

}  // namespace
}  // namespace isobench
