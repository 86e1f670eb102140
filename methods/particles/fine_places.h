// Where the sizing's floor, or its lattice of nodes, is too coarse for the topology of F = c: near critical points of F
// (methods/sizing/critical_points.h). Particles are packed there as those small features need it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "datasets/isosurface.h"
#include "methods/sizing/critical_points.h"

namespace isobench::particles {

struct Spacing;

/// An upper bound on h around places. With an ideal edge of a at the place itself, a point ρ away has at most
/// a + δρ, and beyond a voxel more than that, so that nothing is bounded from four voxels on.
class FinePlaces {
 public:
  /// Edges of 2ε times a point's distance from the surface (equation 1 of Meyer, Kirby, Whitaker 2007: the distance is
  /// what λ and 1/κ are there), but not below `least` mm; h grows by δ a mm.
  FinePlaces(const Isosurface& surface, std::vector<CriticalPoint> points, double epsilon, double delta, double least);

  const std::vector<CriticalPoint>& points() const { return points_; }
  /// mm; infinite where nothing is bounded.
  double bound(const Eigen::Vector3d& x) const;
  double edge_at(std::size_t point) const;

 private:
  std::size_t brick_of(const Eigen::Vector3d& x) const;

  std::vector<CriticalPoint> points_;
  double epsilon_;
  double delta_;
  double least_;
  double voxel_;
  double brick_;  // mm
  Eigen::Array3i bricks_;
  std::vector<std::int32_t> list_of_brick_;  // -1: none reaches into it
  std::vector<std::vector<std::uint32_t>> lists_;
};

/// Adds seeds around the places until none has room for another, apart from each other and from `seeds` by most of the
/// spacing; sheets that face each other do not count. The same for any number of threads.
void add_seeds_at(const FinePlaces& places, const Isosurface& surface, const Spacing& spacing, std::uint64_t seed,
                  std::vector<Eigen::Vector3d>& seeds);

}  // namespace isobench::particles
