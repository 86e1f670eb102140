#include "isobench/metrics/reference_topology/reference_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/metrics/reference_topology/critical_boxes.h"
#include "isobench/metrics/reference_topology/kuhn_topology.h"
#include "isobench/metrics/reference_topology/sign_lattice.h"

namespace isobench {

namespace {

SignLattice whole(const Isosurface& surface, int k, Monitor& monitor) {
  if (k < 1) throw UsageError(fmt::format("reference_k is {}; it must be a whole number of at least 1", k));
  return refined_signs(surface, k, monitor);
}

/// Voxels. The lattice refined k times may miscount at critical points that are closer to the surface than this.
double reach(int k) { return std::min(0.75, 1.5 / k); }

/// How many times finer the lattice of a box is: four nodes to the point's distance, 16 to 96 nodes to a voxel, and no
/// more nodes than memory allows.
int factor_for(const CriticalBox& place, int k) {
  constexpr double least = 16.0;
  constexpr double most = 96.0;
  constexpr double most_nodes = 2e8;
  double cells = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) cells *= place.box.high[axis] - place.box.low[axis];
  const double wanted = std::clamp(4.0 / place.distance, least, most);
  return std::max(2, static_cast<int>(std::ceil(std::min(wanted, std::cbrt(most_nodes / cells)) / k)));
}

NodeBox scaled(const NodeBox& box, int k) {
  NodeBox result = box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.low[axis] *= k;
    result.high[axis] *= k;
  }
  return result;
}

/// Joins the coarse regions that a region of the box connects. Returns the number of regions that lie wholly within the
/// box. A region that reaches the border only between coarse nodes is part of a region outside and is counted there.
std::size_t join_over(const SignLattice& fine, const NodeBox& box, int factor, KuhnRegions& coarse, Monitor& monitor) {
  KuhnRegions regions(fine, {}, monitor);
  std::map<std::uint32_t, std::uint32_t> run_of_region;
  for_each_border_node(box, [&](int x, int y, int z) {
    const std::uint32_t run = coarse.run_of(x, y, z);
    const std::uint32_t region =
        regions.region_of(factor * (x - box.low[0]), factor * (y - box.low[1]), factor * (z - box.low[2]));
    const auto [known, is_new] = run_of_region.try_emplace(region, run);
    if (!is_new) coarse.unite(known->second, run);
  });
  std::set<std::uint32_t> at_border;
  const auto [nx, ny, nz] = fine.size();
  for_each_border_node({{0, 0, 0}, {nx - 1, ny - 1, nz - 1}},
                       [&](int x, int y, int z) { at_border.insert(regions.region_of(x, y, z)); });
  return regions.regions().size() - at_border.size();
}

}  // namespace

ReferenceTopology lattice_topology(const Isosurface& surface, int k, Monitor& monitor) {
  const SignLattice signs = whole(surface, k, monitor);
  return {k, kuhn_euler(signs, monitor), kuhn_components(signs, monitor)};
}

ReferenceTopology reference_topology(const Isosurface& surface, int k, Monitor& monitor) {
  const SignLattice signs = whole(surface, k, monitor);
  ReferenceTopology topology{k, kuhn_euler(signs, monitor), 0};
  const std::vector<CriticalBox> places = critical_boxes(surface, reach(k));
  std::vector<NodeBox> holes;
  for (const CriticalBox& place : places) holes.push_back(scaled(place.box, k));
  KuhnRegions regions(signs, holes, monitor);
  std::size_t within = 0;
  for (std::size_t n = 0; n < places.size(); ++n) {
    monitor.progress(static_cast<double>(n) / static_cast<double>(places.size()));
    const int factor = factor_for(places[n], k);
    const SignLattice fine = refined_signs(surface, places[n].box, k, factor, monitor);
    const SignLattice coarse = refined_signs(surface, places[n].box, k, 1, monitor);
    topology.euler += 2 * (kuhn_euler_within(fine) - kuhn_euler_within(coarse));
    within += join_over(fine, holes[n], factor, regions, monitor);
  }
  topology.components = regions.regions().size() + within - 1;
  return topology;
}

}  // namespace isobench
