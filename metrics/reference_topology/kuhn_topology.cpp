#include "isobench/metrics/reference_topology/kuhn_topology.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace isobench {

namespace {

// The seven edges of a node, numbered by their direction: bit 0 is x, bit 1 is y, bit 2 is z. On a path along edges of
// the cube from the node to the opposite corner, the two nodes between are in a direction of one bit and in one of two
// bits. Each path belongs to one triangle (without the opposite corner) and one tetrahedron.
constexpr std::array<std::array<int, 2>, 6> paths{{{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};

/// Contribution of 64 nodes to χ. The bits of differs[d] mark nodes that differ in sign from the one in direction d.
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

/// Calls visit(x, inside, hole) for the first node of a row and for each node where one of the two changes.
template <class Visit>
void for_each_run(const std::uint64_t* row, const std::vector<std::uint64_t>& holes, std::size_t words, int nodes,
                  Visit visit) {
  const auto bit = [](std::uint64_t word, int at) { return (word >> at & 1U) != 0; };
  std::uint64_t before = (row[0] & ~holes[0]) << 63;  // no change at node 0, which is visited anyway
  std::uint64_t hole_before = holes[0] << 63;
  visit(0, bit(row[0], 0), bit(holes[0], 0));
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t hole = holes[w];
    const std::uint64_t inside = row[w] & ~hole;
    std::uint64_t changes = (inside ^ (inside << 1 | before >> 63)) | (hole ^ (hole << 1 | hole_before >> 63));
    for (; changes != 0; changes &= changes - 1) {
      const int at = std::countr_zero(changes);
      const auto x = static_cast<std::int32_t>(64 * w) + at;
      if (x < nodes) visit(x, bit(inside, at), bit(hole, at));  // the padding beyond is no node
    }
    before = inside;
    hole_before = hole;
  }
}

/// The nodes of a row that are strictly within boxes.
void mark_holes(const std::vector<NodeBox>& boxes, int y, int z, std::vector<std::uint64_t>& bits) {
  std::fill(bits.begin(), bits.end(), 0);
  for (const NodeBox& box : boxes) {
    if (y <= box.low[1] || y >= box.high[1] || z <= box.low[2] || z >= box.high[2]) continue;
    for (int x = box.low[0] + 1; x < box.high[0]; ++x)
      bits[static_cast<std::size_t>(x) / 64] |= std::uint64_t{1} << (static_cast<unsigned>(x) % 64);
  }
}

/// Inside vertices − edges + triangles − tetrahedra, of those with their lowest corner in a row.
long inside_euler_of_row(const SignLattice& signs, int y, int z) {
  const std::vector<std::uint64_t> none(signs.row_words(), 0);
  const bool next_y = y + 1 < signs.size()[1];
  const bool next_z = z + 1 < signs.size()[2];
  const std::array<const std::uint64_t*, 4> rows{signs.row(y, z), next_y ? signs.row(y + 1, z) : none.data(),
                                                 next_z ? signs.row(y, z + 1) : none.data(),
                                                 next_y && next_z ? signs.row(y + 1, z + 1) : none.data()};
  long euler = 0;
  for (std::size_t w = 0; w < signs.row_words(); ++w) {
    const std::uint64_t own = rows[0][w];
    if (own == 0) continue;
    std::array<std::uint64_t, 8> both{};
    for (std::size_t r = 0; r < 4; ++r) {
      const std::uint64_t next = w + 1 == signs.row_words() ? 0 : rows[r][w + 1];
      both[2 * r] = own & rows[r][w];
      both[2 * r + 1] = own & (rows[r][w] >> 1 | next << 63);
    }
    euler += std::popcount(own);
    for (int d = 1; d < 8; ++d) euler -= std::popcount(both[static_cast<std::size_t>(d)]);
    for (const std::array<int, 2>& path : paths) {
      const std::uint64_t triangle = both[static_cast<std::size_t>(path[0])] & both[static_cast<std::size_t>(path[1])];
      euler += std::popcount(triangle);
      euler -= std::popcount(triangle & both[7]);
    }
    for (int d = 1; d < 7; ++d) euler += std::popcount(both[static_cast<std::size_t>(d)] & both[7]);
  }
  return euler;
}

/// χ of the inside part of a box's border, which the faces of the tetrahedra triangulate.
long inside_euler_of_border(const SignLattice& signs) {
  using Node = std::array<int, 3>;
  const Node& size = signs.size();
  const auto moved = [](const Node& node, int d) {
    return Node{node[0] + (d & 1), node[1] + (d >> 1 & 1), node[2] + (d >> 2)};
  };
  const auto share_face = [&](const Node& a, const Node& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (b[axis] >= size[axis]) return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == size[axis] - 1)) return true;
    }
    return false;
  };
  const auto inside = [&](const Node& node) { return signs.inside(node[0], node[1], node[2]); };
  const auto at_node = [&](const Node& node) {
    if (!inside(node)) return 0L;
    long euler = 1;
    for (int d = 1; d < 7; ++d) {
      const Node other = moved(node, d);
      if (share_face(node, other) && inside(other)) --euler;
    }
    for (const std::array<int, 2>& path : paths) {
      const Node last = moved(node, path[1]);
      if (share_face(node, last) && inside(moved(node, path[0])) && inside(last)) ++euler;
    }
    return euler;
  };
  long euler = 0;
  for_each_border_node({{0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1}}, [&](int x, int y, int z) {
    euler += at_node({x, y, z});
  });
  return euler;
}

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

long kuhn_euler_within(const SignLattice& signs) {
  std::vector<long> euler(static_cast<std::size_t>(signs.size()[2]), 0);
  tbb::parallel_for(0, signs.size()[2], [&](int z) {
    for (int y = 0; y < signs.size()[1]; ++y) euler[static_cast<std::size_t>(z)] += inside_euler_of_row(signs, y, z);
  });
  long sum = 0;
  for (const long of_slab : euler) sum += of_slab;
  return sum - inside_euler_of_border(signs);
}

KuhnRegions::KuhnRegions(const SignLattice& signs, const std::vector<NodeBox>& holes, Monitor& monitor)
    : size_(signs.size()) {
  monitor.check();
  find_runs(signs, holes);
  monitor.check();
  sets_ = UnionFind(begin_.size());
  // Joins blocks of slabs in parallel, then their seams: until then, runs of different blocks never meet.
  constexpr int block = 16;
  const int slabs = signs.size()[2];
  const int blocks = (slabs + block - 1) / block;
  tbb::parallel_for(0, blocks, [&](int b) {
    for (int z = b * block; z < std::min((b + 1) * block, slabs); ++z) {
      join_within(z);
      if (z + 1 < std::min((b + 1) * block, slabs)) join_with_next(z);
    }
  });
  for (int b = 1; b < blocks; ++b) join_with_next(b * block - 1);
}

void KuhnRegions::find_runs(const SignLattice& signs, const std::vector<NodeBox>& holes) {
  const auto rows_in_slab = static_cast<std::size_t>(size_[1]);
  row_start_.assign(rows_in_slab * static_cast<std::size_t>(size_[2]) + 1, 0);
  const auto for_each_row = [&](auto visit) {
    tbb::parallel_for(0, size_[2], [&](int z) {
      std::vector<NodeBox> met;
      for (const NodeBox& box : holes) {
        if (box.low[2] < z && z < box.high[2]) met.push_back(box);
      }
      std::vector<std::uint64_t> bits(signs.row_words(), 0);
      for (int y = 0; y < size_[1]; ++y) {
        if (!met.empty()) mark_holes(met, y, z, bits);
        const auto each = [&](auto act) { for_each_run(signs.row(y, z), bits, signs.row_words(), size_[0], act); };
        visit(static_cast<std::size_t>(z) * rows_in_slab + static_cast<std::size_t>(y), each);
      }
    });
  };
  for_each_row([&](std::size_t row, const auto& each_run) {
    std::size_t count = 0;
    each_run([&](std::int32_t, bool, bool) { ++count; });
    row_start_[row + 1] = count;
  });
  for (std::size_t r = 1; r < row_start_.size(); ++r) row_start_[r] += row_start_[r - 1];
  begin_.resize(row_start_.back());
  state_.resize(row_start_.back());
  for_each_row([&](std::size_t row, const auto& each_run) {
    std::size_t run = row_start_[row];
    each_run([&](std::int32_t x, bool inside, bool hole) {
      begin_[run] = x;
      state_[run++] = hole ? State::hole : inside ? State::inside : State::outside;
    });
  });
}

/// Joins like runs of slab z among themselves.
void KuhnRegions::join_within(int z) {
  for (int y = 0; y + 1 < size_[1]; ++y) join_rows(row(y, z), row(y + 1, z));
}

/// Joins like runs of slab z with those of the next.
void KuhnRegions::join_with_next(int z) {
  for (int y = 0; y < size_[1]; ++y) {
    join_rows(row(y, z), row(y, z + 1));
    if (y + 1 < size_[1]) join_rows(row(y, z), row(y + 1, z + 1));
  }
}

/// Node x of the lower row has edges to x and x + 1 of the upper one.
void KuhnRegions::join_rows(std::size_t lower, std::size_t upper) {
  std::size_t a = row_start_[lower];
  std::size_t b = row_start_[upper];
  const std::size_t end_a = row_start_[lower + 1];
  const std::size_t end_b = row_start_[upper + 1];
  while (a < end_a && b < end_b) {
    // Run a, shifted by one, ends at end(a) + 1; like runs touch if [begin, end] of a meets [begin, end) of b.
    const std::int32_t a_end = end(a, end_a) + 1;
    const std::int32_t b_end = end(b, end_b);
    if (state_[a] == state_[b] && is_region(a) && begin_[a] < b_end && begin_[b] < a_end) {
      sets_.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    }
    // The next run of a begins at end(a) = a_end − 1; a run b that ends before a_end does not meet it.
    if (b_end < a_end) {
      ++b;
    } else {
      ++a;
    }
  }
}

std::uint32_t KuhnRegions::run_of(int x, int y, int z) const {
  const auto first = begin_.begin() + static_cast<std::ptrdiff_t>(row_start_[row(y, z)]);
  const auto last = begin_.begin() + static_cast<std::ptrdiff_t>(row_start_[row(y, z) + 1]);
  return static_cast<std::uint32_t>(std::upper_bound(first, last, x) - begin_.begin() - 1);
}

std::vector<std::uint32_t> KuhnRegions::regions() const {
  std::vector<std::uint32_t> roots;
  for (std::uint32_t run = 0; run < begin_.size(); ++run) {
    if (is_region(run) && sets_.is_root(run)) roots.push_back(run);
  }
  return roots;
}

std::size_t kuhn_components(const SignLattice& signs, Monitor& monitor) {
  return KuhnRegions(signs, {}, monitor).regions().size() - 1;
}

}  // namespace isobench
