// Phantoms: shapes given by formulas, whose area, volume, topology or feature size is known.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

/// A length in mm that a manifest may choose.
struct PhantomParameter {
  std::string name;
  double value = 0.0;  ///< the value that this phantom has
  double min = 0.0;
  double max = 0.0;
  std::string description;
};

/// A shape in closed form, with isovalue 0 and inside above, and the facts known about it.
struct Phantom {
  std::string name;
  std::string title;
  /// Positive inside, 0 on the surface; mm. A signed distance if `exact_distance`.
  std::function<double(const Eigen::Vector3d&)> function;
  bool exact_distance = true;
  Eigen::Vector3d half_extent;  ///< mm: the shape lies within ± this, around 0
  int euler = 2;                ///< χ of the surface
  int components = 1;           ///< of the surface
  /// λ, mm: the distance from x to the medial axis on both sides of the surface; empty if no closed form is known. It
  /// is defined near the surface, too: the B-spline moves the surface by about bspline_shift and hardly moves the axis,
  /// so that this function gives λ of the moved surface at its own points.
  std::function<double(const Eigen::Vector3d&)> feature_size;
  std::optional<double> smallest_feature;  ///< mm, the smallest λ on the surface, if a parameter sets it
  std::optional<double> smallest_radius;   ///< mm, of the thinnest branch of a tree
  std::optional<double> area;              ///< mm²
  std::optional<double> volume;            ///< mm³
  std::vector<PhantomParameter> parameters;
};

/// sphere, torus, ellipsoid, slab, two-spheres, capsule, rounded-box, gyroid-ball, and three that are hard to mesh:
///   thin-sheets   two plates, `thickness` thick and `gap` apart; everything is known, λ = min(thickness, gap)/2 on the
///                 sides that face each other and thickness/2 elsewhere;
///   near-spheres  two spheres, `gap` apart; everything is known, λ = min(r, distance to the plane between them);
///   vessel-tree   tapered branches by Murray's law; the topology (one closed surface of genus 0), the smallest radius
///                 and, outside, the exact distance are known.
/// In the middle of a gap of g mm along an axis, the cubic B-spline lifts F to at most 13/24 voxel − g/2. So parts more
/// than 13/12 voxel apart stay apart wherever they lie on the lattice; nearer parts may be joined.
const std::vector<Phantom>& phantoms();
/// Throws UsageError with the nearest valid name.
const Phantom& phantom(const std::string& name);
/// The phantom with these values (mm) for some of its parameters. Throws UsageError for a parameter that the phantom
/// does not have and for a value out of range.
Phantom phantom(const std::string& name, const std::map<std::string, double>& parameters);

/// Samples a phantom on `nodes` nodes along its longest axis, with at least `margin` nodes outside it on every side and
/// one spacing for all axes. World coordinates are the phantom's own. The lattice lies off-centre by fractions of a
/// voxel, so that no plane of symmetry and no extreme point falls on nodes. Threaded. Throws UsageError if fewer than
/// four cells would lie across the phantom.
FloatVolume sample_phantom(const Phantom& phantom, int nodes, int margin = 5);

/// The length (mm) by which the cubic B-spline moves the zero set of a sampled signed distance d inwards, to leading
/// order. The spline smooths like a Gaussian of variance voxel²/3: F = d + voxel²/6 Δd with Δd = −(k1 + k2), where k1
/// and k2 are the principal curvatures, positive where convex.
inline double bspline_shift(double k1, double k2, double voxel) { return (k1 + k2) * voxel * voxel / 6.0; }

}  // namespace isobench
