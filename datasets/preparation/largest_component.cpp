#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/datasets/preparation/components.h"
#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/union_find.h"

namespace isobench {

namespace {

/// Consecutive nodes > 0 of one row along x: begin ≤ i < end.
struct Run {
  int begin;
  int end;
};

/// The runs of all rows, row after row. Row n has the runs row_begin[n] ≤ r < row_begin[n + 1].
struct Runs {
  std::vector<Run> runs;
  std::vector<std::uint32_t> row_begin{0};
};

template <class T>
Runs find_runs(const std::vector<T>& samples, std::size_t nx) {
  Runs found;
  for (std::size_t first = 0; first < samples.size(); first += nx) {
    const T* row = &samples[first];
    const int count = static_cast<int>(nx);
    for (int i = 0; i < count; ++i) {
      if (!(row[i] > T{0})) continue;
      const int begin = i;
      while (i < count && row[i] > T{0}) ++i;
      found.runs.push_back({begin, i});
    }
    found.row_begin.push_back(static_cast<std::uint32_t>(found.runs.size()));
  }
  return found;
}

/// Unites the runs of two adjacent rows that touch, also diagonally.
void unite_rows(const Runs& all, std::size_t row, std::size_t other, UnionFind& components) {
  std::uint32_t a = all.row_begin[row];
  std::uint32_t b = all.row_begin[other];
  while (a < all.row_begin[row + 1] && b < all.row_begin[other + 1]) {
    const Run& run = all.runs[a];
    const Run& near = all.runs[b];
    if (run.begin <= near.end && near.begin <= run.end) components.unite(a, b);
    if (run.end < near.end)
      ++a;
    else
      ++b;
  }
}

UnionFind connect(const Runs& all, int ny, int nz) {
  UnionFind components(all.runs.size());
  const auto row_of = [&](int j, int k) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(j);
  };
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      // Of the eight rows around this one, the four that come before it.
      const int neighbours[][2] = {{j - 1, k}, {j - 1, k - 1}, {j, k - 1}, {j + 1, k - 1}};
      for (const auto& [y, z] : neighbours) {
        if (y >= 0 && y < ny && z >= 0) unite_rows(all, row_of(y, z), row_of(j, k), components);
      }
    }
  }
  return components;
}

/// The component with the most nodes; of several, the one that begins first.
std::uint32_t largest_of(const Runs& all, UnionFind& components) {
  std::vector<std::uint64_t> nodes(all.runs.size(), 0);
  for (std::uint32_t run = 0; run < nodes.size(); ++run) {
    nodes[components.find(run)] += static_cast<std::uint64_t>(all.runs[run].end - all.runs[run].begin);
  }
  return static_cast<std::uint32_t>(std::max_element(nodes.begin(), nodes.end()) - nodes.begin());
}

/// Sets all nodes outside one component to 0.
template <class T>
void clear_others(const Runs& all, UnionFind& components, std::uint32_t kept, std::size_t nx, std::vector<T>& samples) {
  for (std::size_t row = 0; row + 1 < all.row_begin.size(); ++row) {
    T* first = samples.data() + row * nx;
    int done = 0;
    for (std::uint32_t run = all.row_begin[row]; run < all.row_begin[row + 1]; ++run) {
      if (components.find(run) != kept) continue;
      std::fill(first + done, first + all.runs[run].begin, T{0});
      done = all.runs[run].end;
    }
    std::fill(first + done, first + nx, T{0});
  }
}

}  // namespace

std::size_t count_components(const Volume& volume) {
  const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
  const Runs all = volume.samples.visit([&](const auto& samples) { return find_runs(samples, nx); });
  UnionFind components = connect(all, volume.lattice.size[1], volume.lattice.size[2]);
  std::size_t count = 0;
  for (std::uint32_t run = 0; run < all.runs.size(); ++run) count += components.find(run) == run ? 1 : 0;
  return count;
}

void keep_largest_component(Volume& volume) {
  const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
  const Runs all = volume.samples.visit([&](const auto& samples) { return find_runs(samples, nx); });
  if (all.runs.empty()) throw DataError("largest component: no sample is > 0; check the threshold or the labels");
  UnionFind components = connect(all, volume.lattice.size[1], volume.lattice.size[2]);
  const std::uint32_t largest = largest_of(all, components);
  volume.samples.visit([&](auto& samples) { clear_others(all, components, largest, nx, samples); });
}

}  // namespace isobench
