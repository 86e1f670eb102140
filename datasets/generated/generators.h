// The generators behind generate(). Each makes an object above the isovalue; generate() turns it over for one below.
#pragma once

#include <tbb/parallel_for.h>

#include <vector>

#include "isobench/datasets/generated/generated.h"

namespace isobench {

/// A random field and its isovalue. Samples have mean 0 and standard deviation 1 before they are faded out.
struct RandomField {
  FloatVolume field;
  double isovalue = 0.0;
};
/// a = (G_σ ∗ w − mean)/deviation, with white noise w uniform in [−1, 1] at each node; smoothing makes it nearly
/// normal. The isovalue c is the quantile of a over the nodes that are not faded: halfway between two neighbouring
/// samples. Towards the border, a fades to c − 1: F = (c − 1) + Π s(l)·(a − (c − 1)), where l counts layers from the
/// border along an axis, and s rises smoothly from 0 at l = 2 to 1 at l = 7. Cost: (n + 8σ)³·(8σ + 1)·3
/// multiplications.
RandomField random_field(const GeneratedRequest& request, Monitor& monitor);

/// 1 where the random field is above its isovalue, else 0, as bytes.
Volume random_mask(const GeneratedRequest& request, Monitor& monitor);

/// min(w − (d₂ − d₁), depth), voxels: d₁ and d₂ are the distances to the nearest and the second-nearest of the points,
/// so that walls of thickness w stand between their cells (a closed-cell foam). The depth in a box with round edges,
/// r·(1 − ‖x/r‖₄), cuts the foam, so that cells at the border are open. Needs at least two bubbles.
/// Cost: nodes times bubbles.
FloatVolume foam(const GeneratedRequest& request);

/// A ball of the generator islands; voxels.
struct Island {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
  double hollow = 0.0;  ///< radius of the cavity in its middle; 0 for none
};
/// Radii have the density r⁻³ between the two that are asked for: many small ones, few large ones. Largest first, each
/// ball gets a random place at least `widest_gap` from the others, or, every second one, `narrowest_gap` to
/// `widest_gap` from an earlier one. Every third ball has a cavity of half its radius, if its radius is at least
/// `least_hollow`. Radii are at most a quarter of what the border leaves of the volume's shortest side. A ball for
/// which no place is found is left out. Cost: islands² · tries.
std::vector<Island> place_islands(const GeneratedRequest& request);
inline constexpr double narrowest_gap = 1.15;  ///< voxels: the cubic B-spline joins parts less than 13/12 voxel apart
inline constexpr double widest_gap = 1.6;      ///< voxels
inline constexpr double least_hollow = 3.5;    ///< voxels

/// The largest of min(r − d, d − hollow) over the islands, voxels, where d is the distance to the centre. The cubic
/// B-spline smooths the tip of a ball: one of radius 0.92 vanishes, and one a little larger becomes a speck.
/// Cost: nodes times islands.
FloatVolume islands_volume(const GeneratedRequest& request);

/// A volume of the size and spacing asked for, with the value of `function` at the voxel (i, j, k) of each node.
/// Threaded.
template <class Function>
FloatVolume sampled(const GeneratedRequest& request, const Function& function) {
  FloatVolume volume;
  volume.lattice.size = request.size;
  volume.lattice.spacing = request.spacing;
  volume.samples.resize(volume.lattice.nodes());
  tbb::parallel_for(0, request.size[2], [&](int k) {
    for (int j = 0; j < request.size[1]; ++j) {
      for (int i = 0; i < request.size[0]; ++i) {
        volume.at(i, j, k) = static_cast<float>(function(Eigen::Vector3d(i, j, k)));
      }
    }
  });
  return volume;
}

}  // namespace isobench
