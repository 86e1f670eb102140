#include "isobench/methods/lattice/lattice_signs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace isobench {

LatticeSigns::LatticeSigns(const Isosurface& surface, const Monitor& monitor)
    : size_(surface.lattice().size), words_((size_[0] + 63) / 64) {
  bits_.assign(row(0, size_[2]), 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, nz(), 4), [&](const tbb::blocked_range<int>& slabs) {
    std::vector<float> values;
    for (int k = slabs.begin(); k < slabs.end(); ++k) {
      monitor.check();
      surface.node_values(k, values);
      const float* value = values.data();
      for (int j = 0; j < ny(); ++j, value += nx()) {
        Word* bits = &bits_[row(j, k)];
        for (int i = 0; i < nx(); ++i) bits[i / 64] |= static_cast<Word>(value[i] > 0.0F) << (i % 64);
      }
    }
  });
}

LatticeSigns::Word LatticeSigns::crossed_cells(int w, int j, int k) const {
  const auto any_and_all = [&](int v) {
    const Word a = word(v, j, k), b = word(v, j + 1, k), c = word(v, j, k + 1), d = word(v, j + 1, k + 1);
    return std::array<Word, 2>{a | b | c | d, a & b & c & d};
  };
  const auto [any, all] = any_and_all(w);
  if (any == 0 && w + 1 >= words_) return 0;
  const auto [next_any, next_all] = any_and_all(w + 1);
  const Word either = any | any >> 1 | next_any << 63;
  const Word both = all & (all >> 1 | next_all << 63);
  return either & ~both & edge_mask(w);
}

unsigned LatticeSigns::cell_case(int i, int j, int k) const {
  return bit(i, j, k) | bit(i + 1, j, k) << 1 | bit(i + 1, j + 1, k) << 2 | bit(i, j + 1, k) << 3 |
         bit(i, j, k + 1) << 4 | bit(i + 1, j, k + 1) << 5 | bit(i + 1, j + 1, k + 1) << 6 | bit(i, j + 1, k + 1) << 7;
}

}  // namespace isobench
