#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// Consecutive nodes > 0 of one x-row: begin ≤ i < end.
struct Run {
  int begin;
  int end;
  std::uint32_t parent;
};

std::uint32_t root_of(std::vector<Run>& runs, std::uint32_t run) {
  while (runs[run].parent != run) {
    runs[run].parent = runs[runs[run].parent].parent;
    run = runs[run].parent;
  }
  return run;
}

/// The older run stays root, so that the outcome does not depend on the order of unions.
void unite(std::vector<Run>& runs, std::uint32_t a, std::uint32_t b) {
  a = root_of(runs, a);
  b = root_of(runs, b);
  if (a == b) return;
  runs[std::max(a, b)].parent = std::min(a, b);
}

/// Unites the runs [a, a_end) and [b, b_end) of two adjacent rows that touch, also diagonally.
void unite_rows(std::vector<Run>& runs, std::uint32_t a, std::uint32_t a_end, std::uint32_t b, std::uint32_t b_end) {
  while (a < a_end && b < b_end) {
    if (runs[a].begin <= runs[b].end && runs[b].begin <= runs[a].end) unite(runs, a, b);
    if (runs[a].end < runs[b].end)
      ++a;
    else
      ++b;
  }
}

void append_runs(const float* row, int count, std::vector<Run>& runs) {
  for (int i = 0; i < count; ++i) {
    if (!(row[i] > 0.0F)) continue;
    const int begin = i;
    while (i < count && row[i] > 0.0F) ++i;
    runs.push_back({begin, i, static_cast<std::uint32_t>(runs.size())});
  }
}

}  // namespace

void keep_largest_component(Volume& volume) {
  const auto [nx, ny, nz] = volume.lattice.size;
  std::vector<Run> runs;
  std::vector<std::uint32_t> row_begin;  // of each row, and one past the last
  const auto row_of = [ny = ny](int j, int k) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(j);
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      row_begin.push_back(static_cast<std::uint32_t>(runs.size()));
      append_runs(volume.samples.data() + volume.lattice.index(0, j, k), nx, runs);
      const auto end = static_cast<std::uint32_t>(runs.size());
      // The rows before this one among its eight neighbours.
      const int neighbours[][2] = {{j - 1, k}, {j - 1, k - 1}, {j, k - 1}, {j + 1, k - 1}};
      for (const auto& [y, z] : neighbours) {
        if (y < 0 || y >= ny || z < 0) continue;
        const std::size_t row = row_of(y, z);
        unite_rows(runs, row_begin[row], row_begin[row + 1], row_begin.back(), end);
      }
    }
  }
  if (runs.empty()) throw DataError("largest component: no sample is > 0; check the threshold or the labels");

  std::vector<std::uint64_t> nodes(runs.size(), 0);
  for (std::uint32_t run = 0; run < runs.size(); ++run) {
    nodes[root_of(runs, run)] += static_cast<std::uint64_t>(runs[run].end - runs[run].begin);
  }
  const auto largest = static_cast<std::uint32_t>(std::max_element(nodes.begin(), nodes.end()) - nodes.begin());
  row_begin.push_back(static_cast<std::uint32_t>(runs.size()));
  for (std::size_t row = 0; row + 1 < row_begin.size(); ++row) {
    float* samples = volume.samples.data() + row * static_cast<std::size_t>(nx);
    int done = 0;
    for (std::uint32_t run = row_begin[row]; run < row_begin[row + 1]; ++run) {
      if (root_of(runs, run) != largest) continue;
      std::fill(samples + done, samples + runs[run].begin, 0.0F);
      done = runs[run].end;
    }
    std::fill(samples + done, samples + nx, 0.0F);
  }
}

}  // namespace isobench
