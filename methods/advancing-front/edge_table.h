// The directed edges of the triangles made so far. No directed edge may be used twice: this keeps the mesh manifold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench::advancing_front {

/// A hash set of pairs of vertex numbers, with open addressing and without removal. The pair (2³²−1, 2³²−1) is not
/// allowed: it marks free slots.
class EdgeTable {
 public:
  EdgeTable() : slots_(1024, free_slot) {}

  void insert(std::uint32_t from, std::uint32_t to) {
    if (2 * ++size_ > slots_.size()) grow();
    std::uint64_t& slot = slots_[find(key(from, to))];
    if (slot != free_slot) --size_;
    slot = key(from, to);
  }
  bool contains(std::uint32_t from, std::uint32_t to) const { return slots_[find(key(from, to))] != free_slot; }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::uint64_t free_slot = ~std::uint64_t{0};

  static std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

  std::size_t find(std::uint64_t key) const {
    std::size_t slot = (key * 0x9E3779B97F4A7C15U >> 20) & (slots_.size() - 1);
    while (slots_[slot] != free_slot && slots_[slot] != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    std::vector<std::uint64_t> old(4 * slots_.size(), free_slot);
    old.swap(slots_);
    for (const std::uint64_t key : old) {
      if (key != free_slot) slots_[find(key)] = key;
    }
  }

  std::vector<std::uint64_t> slots_;
  std::size_t size_ = 0;
};

}  // namespace isobench::advancing_front
