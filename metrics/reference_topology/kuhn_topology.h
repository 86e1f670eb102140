// Topology of the surface between the inside and outside nodes of a lattice that is cut into Kuhn tetrahedra. Six
// tetrahedra share the main diagonal of each cube, so each node has 7 edges, 12 triangles and 6 tetrahedra of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/foundation/union_find.h"
#include "isobench/metrics/reference_topology/sign_lattice.h"

namespace isobench {

/// χ = bichromatic edges − triangles + tetrahedra: each contains one vertex, edge or face of the surface.
/// Precondition: the outermost layer is outside. With all threads.
long kuhn_euler(const SignLattice& signs, Monitor& monitor);

/// Connected components of the surface. Each component divides space in two, so the inside and outside regions form a
/// tree whose edges are the components. Their number is one less than that of the regions of nodes, which are connected
/// over the 14 edges at each node. Precondition and threads as above.
std::size_t kuhn_components(const SignLattice& signs, Monitor& monitor);

/// χ of the body between a box's inside nodes, less that of its cut with the box's border: vertices − edges + triangles
/// − tetrahedra whose corners are all inside and not all on one face of the box. The inner part of the box adds twice
/// this number to the χ of a closed surface.
long kuhn_euler_within(const SignLattice& signs);

/// The regions of a lattice's nodes, inside and outside, connected over the 14 edges at each node. Nodes strictly
/// within `holes` (in nodes of this lattice) belong to no region. Each row is stored as runs of equal nodes.
class KuhnRegions {
 public:
  KuhnRegions(const SignLattice& signs, const std::vector<NodeBox>& holes, Monitor& monitor);

  /// The run that contains a node. Precondition: the node is in no hole.
  std::uint32_t run_of(int x, int y, int z) const;
  std::uint32_t region_of(int x, int y, int z) { return sets_.find(run_of(x, y, z)); }
  void unite(std::uint32_t run_a, std::uint32_t run_b) { sets_.unite(run_a, run_b); }
  /// One run that represents each region, ascending.
  std::vector<std::uint32_t> regions() const;

 private:
  enum class State : std::uint8_t { outside, inside, hole };
  void find_runs(const SignLattice& signs, const std::vector<NodeBox>& holes);
  void join_within(int z);
  void join_with_next(int z);
  void join_rows(std::size_t lower, std::size_t upper);
  bool is_region(std::size_t run) const { return state_[run] != State::hole; }
  std::size_t row(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y);
  }
  std::int32_t end(std::size_t run, std::size_t row_end) const {
    return run + 1 < row_end ? begin_[run + 1] : size_[0];
  }

  std::array<int, 3> size_;
  std::vector<std::size_t> row_start_;  // first run of each row, and the number of runs at the end
  std::vector<std::int32_t> begin_;     // first node of each run
  std::vector<State> state_;
  UnionFind sets_{0};
};

}  // namespace isobench
