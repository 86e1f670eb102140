#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/union_find.h"

namespace isobench {

namespace {

/// Consecutive nodes > 0 of one x-row: begin ≤ i < end.
struct Run {
  int begin;
  int end;
};

/// Unites the runs [a, a_end) and [b, b_end) of two adjacent rows that touch, also diagonally.
void unite_rows(const std::vector<Run>& runs, UnionFind& components, std::uint32_t a, std::uint32_t a_end,
                std::uint32_t b, std::uint32_t b_end) {
  while (a < a_end && b < b_end) {
    if (runs[a].begin <= runs[b].end && runs[b].begin <= runs[a].end) components.unite(a, b);
    if (runs[a].end < runs[b].end)
      ++a;
    else
      ++b;
  }
}

void append_runs(const float* row, int count, std::vector<Run>& runs, UnionFind& components) {
  for (int i = 0; i < count; ++i) {
    if (!(row[i] > 0.0F)) continue;
    const int begin = i;
    while (i < count && row[i] > 0.0F) ++i;
    runs.push_back({begin, i});
    components.add();
  }
}

}  // namespace

void keep_largest_component(Volume& volume) {
  const auto [nx, ny, nz] = volume.lattice.size;
  std::vector<Run> runs;
  UnionFind components(0);
  std::vector<std::uint32_t> row_begin;  // of each row, and one past the last
  const auto row_of = [ny = ny](int j, int k) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(j);
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      row_begin.push_back(static_cast<std::uint32_t>(runs.size()));
      append_runs(volume.samples.data() + volume.lattice.index(0, j, k), nx, runs, components);
      const auto end = static_cast<std::uint32_t>(runs.size());
      // The rows before this one among its eight neighbours.
      const int neighbours[][2] = {{j - 1, k}, {j - 1, k - 1}, {j, k - 1}, {j + 1, k - 1}};
      for (const auto& [y, z] : neighbours) {
        if (y < 0 || y >= ny || z < 0) continue;
        const std::size_t row = row_of(y, z);
        unite_rows(runs, components, row_begin[row], row_begin[row + 1], row_begin.back(), end);
      }
    }
  }
  if (runs.empty()) throw DataError("largest component: no sample is > 0; check the threshold or the labels");

  std::vector<std::uint64_t> nodes(runs.size(), 0);
  for (std::uint32_t run = 0; run < runs.size(); ++run) {
    nodes[components.find(run)] += static_cast<std::uint64_t>(runs[run].end - runs[run].begin);
  }
  const auto largest = static_cast<std::uint32_t>(std::max_element(nodes.begin(), nodes.end()) - nodes.begin());
  row_begin.push_back(static_cast<std::uint32_t>(runs.size()));
  for (std::size_t row = 0; row + 1 < row_begin.size(); ++row) {
    float* samples = volume.samples.data() + row * static_cast<std::size_t>(nx);
    int done = 0;
    for (std::uint32_t run = row_begin[row]; run < row_begin[row + 1]; ++run) {
      if (components.find(run) != largest) continue;
      std::fill(samples + done, samples + runs[run].begin, 0.0F);
      done = runs[run].end;
    }
    std::fill(samples + done, samples + nx, 0.0F);
  }
}

}  // namespace isobench
