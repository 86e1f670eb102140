// Disjoint sets of the numbers 0 to n − 1. The smallest number of a set represents it, so that the outcome does not
// depend on the order of the unions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isobench {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The representative of the set that n is in.
  std::uint32_t find(std::uint32_t n) {
    while (parent_[n] != n) {
      parent_[n] = parent_[parent_[n]];
      n = parent_[n];
    }
    return n;
  }
  /// Several threads may call this at once if no two of them use the same set.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }
  bool is_root(std::uint32_t n) const { return parent_[n] == n; }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace isobench
