// Which nodes of a lattice are inside, one bit a node.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Bits packed along x, each row padded with outside nodes to whole 64-bit words, with at least one bit of padding.
class SignLattice {
 public:
  explicit SignLattice(std::array<int, 3> size)
      : size_(size),
        row_words_(static_cast<std::size_t>(size[0]) / 64 + 1),
        words_(row_words_ * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]), 0) {}

  const std::array<int, 3>& size() const { return size_; }
  std::size_t row_words() const { return row_words_; }
  std::uint64_t* row(int y, int z) { return words_.data() + offset(y, z); }
  const std::uint64_t* row(int y, int z) const { return words_.data() + offset(y, z); }
  bool inside(int x, int y, int z) const {
    return (row(y, z)[static_cast<std::size_t>(x) / 64] >> (static_cast<unsigned>(x) % 64) & 1U) != 0;
  }
  void set_inside(int x, int y, int z) {
    row(y, z)[static_cast<std::size_t>(x) / 64] |= std::uint64_t{1} << (static_cast<unsigned>(x) % 64);
  }

 private:
  std::size_t offset(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y)) *
           row_words_;
  }
  std::array<int, 3> size_;
  std::size_t row_words_;
  std::vector<std::uint64_t> words_;
};

/// A box of cells of a surface's lattice, between the nodes `low` and `high`; low < high along each axis.
struct NodeBox {
  std::array<int, 3> low{};
  std::array<int, 3> high{};
};

/// Calls visit(x, y, z) for the nodes on the border of a box. Its corners may be nodes of any lattice.
template <class Visit>
void for_each_border_node(const NodeBox& box, Visit visit) {
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      const bool face = y == box.low[1] || y == box.high[1] || z == box.low[2] || z == box.high[2];
      const int step = face ? 1 : box.high[0] - box.low[0];
      for (int x = box.low[0]; x <= box.high[0]; x += step) visit(x, y, z);
    }
  }
}

/// The signs of f at the nodes i/k (k ≥ 1) of the surface's lattice, k(n − 1) + 1 along each axis, with the kernel that
/// value() uses; inside is f > 0. The outermost two layers of nodes count as outside.
/// Separable: four multiply-adds a node, with all threads; memory is the bits and a few slabs a thread.
SignLattice refined_signs(const Isosurface& surface, int k, Monitor& monitor);

/// The same for a box of the lattice, refined `factor` · k times: k(high − low) · factor + 1 nodes along each axis, the
/// first at `low`. The border that counts as outside is as thick as in the lattice refined k times.
SignLattice refined_signs(const Isosurface& surface, const NodeBox& box, int k, int factor, Monitor& monitor);

}  // namespace isobench
