// Surfaces with known answers, sampled on a lattice.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

/// A length that a phantom's manifest may choose, mm.
struct PhantomParameter {
  std::string name;
  double value = 0.0;  ///< of this phantom
  double min = 0.0;
  double max = 0.0;
  std::string description;
};

/// A shape given in closed form, its isovalue 0, inside above, and what is known of it.
struct Phantom {
  std::string name;
  std::string title;
  /// Positive inside, mm; a signed distance where `exact_distance`. The surface is where it is 0.
  std::function<double(const Eigen::Vector3d&)> function;
  bool exact_distance = true;
  Eigen::Vector3d half_extent;  ///< mm: the shape lies within ± this, around 0
  int euler = 2;                ///< χ of the surface
  int components = 1;           ///< of the surface
  /// λ, mm: the distance from x to the medial axis (both sides of the surface); empty where no closed form is known.
  /// Defined near the surface, not only on it: the B-spline moves the surface by about bspline_shift, which hardly
  /// moves the axis, so that λ of the *moved* surface is this function at the moved points.
  std::function<double(const Eigen::Vector3d&)> feature_size;
  std::optional<double> smallest_feature;  ///< mm, λ where it is smallest on the surface, where a parameter sets it
  std::optional<double> smallest_radius;   ///< mm, of the thinnest part of a tree
  std::optional<double> area;              ///< mm²
  std::optional<double> volume;            ///< mm³
  std::vector<PhantomParameter> parameters;
};

/// sphere, torus, ellipsoid, slab, two-spheres, capsule, rounded-box, gyroid-ball, and three for what is hard:
///   thin-sheets   two plates `thickness` thick and `gap` apart; everything is known, λ = min(thickness, gap)/2 on the
///                 sides that face each other and thickness/2 elsewhere;
///   near-spheres  two spheres `gap` apart; everything is known, λ = min(r, distance to the plane between them);
///   vessel-tree   tapered branches by Murray's law; known are one closed surface of genus 0, its smallest radius, and
///                 outside it the exact distance.
/// The cubic B-spline lifts F in the middle of a gap of g mm along an axis to at most 13/24 voxel − g/2: parts that are
/// more than 13/12 voxel apart stay apart wherever they lie on the lattice, and nearer ones may be welded.
const std::vector<Phantom>& phantoms();
/// Throws UsageError with the nearest valid name.
const Phantom& phantom(const std::string& name);
/// The same with some of its parameters (mm) chosen. Throws UsageError for a parameter that the phantom does not have
/// or that is out of its range.
Phantom phantom(const std::string& name, const std::map<std::string, double>& parameters);

/// Samples a phantom with `nodes` nodes along its longest axis and at least `margin` nodes outside it all round,
/// spacing equal along all axes. World coordinates are the phantom's own; the lattice is placed off-centre by fractions
/// of a voxel, so that no plane of symmetry or extreme point falls on nodes. Throws UsageError if fewer than four cells
/// would lie across the phantom.
Volume sample_phantom(const Phantom& phantom, int nodes, int margin = 5);

/// How far inwards (mm) the cubic B-spline, which smooths like a Gaussian of variance voxel²/3, moves the zero set of a
/// sampled signed distance where its principal curvatures are k1 and k2 (positive where convex), to leading order:
/// F = d + voxel²/6 Δd, and Δd = −(k1 + k2).
inline double bspline_shift(double k1, double k2, double voxel) { return (k1 + k2) * voxel * voxel / 6.0; }

}  // namespace isobench
