// One bit for each lattice node: whether it is inside the object. For most nodes, marching cubes needs nothing else.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Rows of bits along x, 64 nodes a word. Bits beyond the end of a row are 0.
class LatticeSigns {
 public:
  using Word = std::uint64_t;

  /// A node is inside if f > 0 in Isosurface::node_values.
  LatticeSigns(const Isosurface& surface, const Monitor& monitor);

  int nx() const { return size_[0]; }
  int ny() const { return size_[1]; }
  int nz() const { return size_[2]; }
  int words() const { return words_; }

  Word word(int w, int j, int k) const { return w < words_ ? bits_[row(j, k) + static_cast<std::size_t>(w)] : 0; }
  /// The bits of nodes 64w + 1 … 64w + 64, the far ends of the x-edges that start in word w.
  Word next(int w, int j, int k) const { return word(w, j, k) >> 1 | word(w + 1, j, k) << 63; }
  unsigned bit(int i, int j, int k) const { return word(i / 64, j, k) >> (i % 64) & 1U; }

  /// The x-, y- and z-edges that start in word w of a row and have different signs at their ends. Precondition
  /// for y and z: row j + 1 or slab k + 1 exists.
  Word x_crossings(int w, int j, int k) const { return (word(w, j, k) ^ next(w, j, k)) & edge_mask(w); }
  Word y_crossings(int w, int j, int k) const { return word(w, j, k) ^ word(w, j + 1, k); }
  Word z_crossings(int w, int j, int k) const { return word(w, j, k) ^ word(w, j, k + 1); }
  /// The cells that start in word w of a row and have corners on both sides.
  Word crossed_cells(int w, int j, int k) const;
  /// The bits of a cell's corners in VTK's order for a hexahedron: bit n is corner n.
  unsigned cell_case(int i, int j, int k) const;

 private:
  std::size_t row(int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
           static_cast<std::size_t>(words_);
  }
  /// The nodes of word w that start an x-edge and a cell: all but the last node of the row.
  Word edge_mask(int w) const {
    const int left = size_[0] - 1 - 64 * w;
    return left >= 64 ? ~Word{0} : left <= 0 ? Word{0} : (Word{1} << left) - 1;
  }

  std::array<int, 3> size_;
  int words_;
  std::vector<Word> bits_;
};

/// Calls visit(i) for every set bit of word w, in order.
template <typename Visit>
void for_each_bit(LatticeSigns::Word word, int w, Visit&& visit) {
  for (; word != 0; word &= word - 1) visit(64 * w + std::countr_zero(word));
}

}  // namespace isobench
