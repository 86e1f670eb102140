#include "isobench/methods/sizing/critical_points/hidden_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "isobench/datasets/topology/candidate_cells.h"
#include "isobench/datasets/topology/tricubic.h"

namespace isobench {

namespace {

bool is_hidden(const Tricubic& f) {
  const auto is_inside = [](double value) { return value > 0.0; };
  const auto inside = std::count_if(f.b.begin(), f.b.end(), is_inside);
  if (inside == 0 || inside == 64) return false;
  int corners = 0;
  for (unsigned corner = 0; corner < 8; ++corner) corners += is_inside(f.corner(corner)) ? 1 : 0;
  return corners == 0 || corners == 8;
}

}  // namespace

std::vector<std::array<int, 3>> hidden_cells(const Isosurface& surface) {
  const int layers = surface.lattice().size[2] - 1;
  std::vector<std::vector<std::array<int, 3>>> found(static_cast<std::size_t>(layers));
  tbb::parallel_for(0, layers, [&](int k) {
    for (const auto& [i, j] : candidate_cells(surface, k, 0.0, 0.0)) {
      if (is_hidden(cell_polynomial(surface, i, j, k, 0.0))) found[static_cast<std::size_t>(k)].push_back({i, j, k});
    }
  });
  std::vector<std::array<int, 3>> all;
  for (const auto& in_layer : found) all.insert(all.end(), in_layer.begin(), in_layer.end());
  return all;
}

}  // namespace isobench
