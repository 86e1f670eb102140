#include "metrics/kuhn_topology.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "datasets/union_find.h"

namespace isobench {

namespace {

// The seven edges of a node, numbered by their direction: bit 0 is x, bit 1 is y, bit 2 is z. A path from the node to
// the opposite corner of its cube passes one direction of one bit and one of two: a triangle or tetrahedron each.
constexpr std::array<std::array<int, 2>, 6> paths{{{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};

/// Contribution to χ of 64 nodes; differs[d] has a bit where node and neighbour in direction d are of unlike sign.
long euler_of_word(const std::array<std::uint64_t, 8>& differs) {
  long euler = 0;
  for (int d = 1; d < 8; ++d) euler += std::popcount(differs[static_cast<std::size_t>(d)]);
  for (const std::array<int, 2>& path : paths) {
    const std::uint64_t first = differs[static_cast<std::size_t>(path[0])];
    const std::uint64_t second = differs[static_cast<std::size_t>(path[1])];
    euler -= std::popcount(first | second);
    euler += std::popcount(first | second | differs[7]);
  }
  for (int d = 1; d < 7; ++d) euler -= std::popcount(differs[static_cast<std::size_t>(d)] | differs[7]);
  return euler;
}

long euler_of_row(const SignLattice& signs, int y, int z) {
  const std::array<const std::uint64_t*, 4> rows{signs.row(y, z), signs.row(y + 1, z), signs.row(y, z + 1),
                                                 signs.row(y + 1, z + 1)};
  long euler = 0;
  for (std::size_t w = 0; w < signs.row_words(); ++w) {
    const bool last = w + 1 == signs.row_words();
    const std::uint64_t own = rows[0][w];
    std::array<std::uint64_t, 8> differs{};
    std::uint64_t any = 0;
    for (std::size_t r = 0; r < 4; ++r) {
      const std::uint64_t next = last ? 0 : rows[r][w + 1];
      differs[2 * r] = own ^ rows[r][w];
      differs[2 * r + 1] = own ^ (rows[r][w] >> 1 | next << 63);
      any |= differs[2 * r] | differs[2 * r + 1];
    }
    if (any != 0) euler += euler_of_word(differs);
  }
  return euler;
}

/// The rows of a lattice as runs of one sign: the even ones outside, the odd ones inside, as each row begins outside.
struct Runs {
  std::vector<std::size_t> row_start;  ///< first run of each row, and the number of runs at the end
  std::vector<std::int32_t> begin;     ///< first node of each run
};

/// Calls visit(x) for each x at which a row changes sign.
template <class Visit>
void for_each_change(const SignLattice& signs, int y, int z, Visit visit) {
  const std::uint64_t* row = signs.row(y, z);
  std::uint64_t before = 0;
  for (std::size_t w = 0; w < signs.row_words(); ++w) {
    for (std::uint64_t changes = row[w] ^ (row[w] << 1 | before); changes != 0; changes &= changes - 1) {
      visit(static_cast<std::int32_t>(64 * w) + std::countr_zero(changes));
    }
    before = row[w] >> 63;
  }
}

Runs find_runs(const SignLattice& signs) {
  const auto [nx, ny, nz] = signs.size();
  const auto rows_in_slab = static_cast<std::size_t>(ny);
  Runs runs;
  runs.row_start.assign(rows_in_slab * static_cast<std::size_t>(nz) + 1, 0);
  const auto for_each_row = [&, slabs = nz](auto visit) {
    tbb::parallel_for(0, slabs, [&](int z) {
      for (int y = 0; y < signs.size()[1]; ++y)
        visit(static_cast<std::size_t>(z) * rows_in_slab + static_cast<std::size_t>(y), y, z);
    });
  };
  for_each_row([&](std::size_t row, int y, int z) {
    std::size_t count = 1;
    for_each_change(signs, y, z, [&](std::int32_t) { ++count; });
    runs.row_start[row + 1] = count;
  });
  for (std::size_t r = 1; r < runs.row_start.size(); ++r) runs.row_start[r] += runs.row_start[r - 1];
  runs.begin.resize(runs.row_start.back());
  for_each_row([&](std::size_t row, int y, int z) {
    std::size_t run = runs.row_start[row];
    runs.begin[run++] = 0;
    for_each_change(signs, y, z, [&](std::int32_t x) { runs.begin[run++] = x; });
  });
  return runs;
}

class Regions {
 public:
  explicit Regions(const SignLattice& signs)
      : size_(signs.size()), runs_(find_runs(signs)), sets_(runs_.begin.size()) {}

  /// Joins like runs of slab z among themselves.
  void join_within(int z) {
    for (int y = 0; y + 1 < size_[1]; ++y) join_rows(row(y, z), row(y + 1, z));
  }
  /// Joins like runs of slab z with those of the next.
  void join_with_next(int z) {
    for (int y = 0; y < size_[1]; ++y) {
      join_rows(row(y, z), row(y, z + 1));
      if (y + 1 < size_[1]) join_rows(row(y, z), row(y + 1, z + 1));
    }
  }
  std::size_t count() const {
    std::size_t roots = 0;
    for (std::uint32_t r = 0; r < runs_.begin.size(); ++r) roots += sets_.is_root(r) ? 1 : 0;
    return roots;
  }

 private:
  std::size_t row(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y);
  }
  std::int32_t end(std::size_t run, std::size_t row_end) const {
    return run + 1 < row_end ? runs_.begin[run + 1] : size_[0];
  }

  /// Node x of the lower row has edges to x and x + 1 of the upper one.
  void join_rows(std::size_t lower, std::size_t upper) {
    std::size_t a = runs_.row_start[lower];
    std::size_t b = runs_.row_start[upper];
    const std::size_t first_a = a;
    const std::size_t first_b = b;
    const std::size_t end_a = runs_.row_start[lower + 1];
    const std::size_t end_b = runs_.row_start[upper + 1];
    while (a < end_a && b < end_b) {
      // Run a, shifted by one, ends at end(a) + 1; like runs touch if [begin, end] of a meets [begin, end) of b.
      const std::int32_t a_end = end(a, end_a) + 1;
      const std::int32_t b_end = end(b, end_b);
      const bool alike = ((a - first_a) ^ (b - first_b)) % 2 == 0;
      if (alike && runs_.begin[a] < b_end && runs_.begin[b] < a_end) {
        sets_.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
      }
      // The next run of a reaches from end(a), one node before a's own reach ends: what ends there does not meet it.
      if (b_end < a_end) {
        ++b;
      } else {
        ++a;
      }
    }
  }

  std::array<int, 3> size_;
  Runs runs_;
  UnionFind sets_;
};

}  // namespace

long kuhn_euler(const SignLattice& signs, Monitor& monitor) {
  monitor.check();
  const int slabs = signs.size()[2] - 1;
  std::vector<long> euler(static_cast<std::size_t>(slabs), 0);
  tbb::parallel_for(0, slabs, [&](int z) {
    for (int y = 0; y + 1 < signs.size()[1]; ++y) euler[static_cast<std::size_t>(z)] += euler_of_row(signs, y, z);
  });
  long sum = 0;
  for (const long of_slab : euler) sum += of_slab;
  return sum;
}

std::size_t kuhn_components(const SignLattice& signs, Monitor& monitor) {
  monitor.check();
  Regions regions(signs);
  monitor.check();
  // Blocks of slabs are joined in parallel, their seams after them: the runs of different blocks never meet before.
  constexpr int block = 16;
  const int slabs = signs.size()[2];
  const int blocks = (slabs + block - 1) / block;
  tbb::parallel_for(0, blocks, [&](int b) {
    for (int z = b * block; z < std::min((b + 1) * block, slabs); ++z) {
      regions.join_within(z);
      if (z + 1 < std::min((b + 1) * block, slabs)) regions.join_with_next(z);
    }
  });
  for (int b = 1; b < blocks; ++b) regions.join_with_next(b * block - 1);
  return regions.count() - 1;
}

}  // namespace isobench
