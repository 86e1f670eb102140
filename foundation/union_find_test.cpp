#include "isobench/foundation/union_find.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace isobench {
namespace {

TEST(UnionFind, TheSmallestMemberRepresentsItsSet) {
  UnionFind sets(5);
  sets.unite(4, 2);
  sets.unite(3, 4);
  sets.unite(3, 2);  // already one set
  EXPECT_EQ(sets.find(0), 0U);
  for (const std::uint32_t n : {2U, 3U, 4U}) EXPECT_EQ(sets.find(n), 2U);
  EXPECT_TRUE(sets.is_root(1));
  EXPECT_TRUE(sets.is_root(2));
  EXPECT_FALSE(sets.is_root(4));
}

TEST(UnionFind, AgreesWithRelabellingWhateverTheOrder) {
  constexpr std::uint32_t count = 200;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::uint32_t> any(0, count - 1);
  UnionFind sets(count);
  std::vector<std::uint32_t> labels(count);
  std::iota(labels.begin(), labels.end(), 0U);
  for (int n = 0; n < 150; ++n) {
    const std::uint32_t a = any(random), b = any(random);
    sets.unite(a, b);
    const auto [low, high] = std::minmax(labels[a], labels[b]);
    std::replace(labels.begin(), labels.end(), std::uint32_t{high}, std::uint32_t{low});
  }
  for (std::uint32_t n = 0; n < count; ++n) {
    EXPECT_EQ(sets.find(n), labels[n]);
    EXPECT_EQ(sets.is_root(n), labels[n] == n);
  }
}

}  // namespace
}  // namespace isobench
