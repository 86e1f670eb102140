// The boxes in which a proof found F = c: where each component of the surface is, and where it needed small boxes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "isobench/datasets/topology/subdivision.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// A box that holds one disc of F = c.
struct SurfaceBox {
  CellBox box;
  int depth = 0;                ///< how often its cell was cut to make it
  std::uint32_t component = 0;  ///< of F = c
};

class SurfaceBoxes {
 public:
  /// `component` has one number for each disc of the layers, in their order.
  SurfaceBoxes(const Lattice& lattice, double cut_at, std::vector<CellLayer> layers,
               std::vector<std::uint32_t> component);

  /// The component whose box contains x, or else is nearest to x, among the boxes of x's cell and of the cells around
  /// it. x: lattice frame, mm. Time: logarithmic in the number of boxes where x is on F = c.
  std::optional<std::uint32_t> component_at(const Eigen::Vector3d& x) const;

  /// Calls visit(box) for every box with a disc, in the order of the lattice's cells.
  void for_each(const std::function<void(const SurfaceBox&)>& visit) const;

 private:
  struct Tree;
  std::optional<Tree> tree_of(const std::array<int, 3>& cell) const;
  template <class Visit>
  void descend(const Tree& tree, const Visit& visit) const;

  std::array<int, 3> cells_;  // along each axis
  Eigen::Vector3d spacing_;
  double cut_at_;
  std::vector<CellLayer> layers_;
  std::vector<std::size_t> first_disc_;  // of each layer
  std::vector<std::uint32_t> component_;
};

}  // namespace isobench
