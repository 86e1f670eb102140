// The surface F = c together with the distance that particles on it keep from each other.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/sampling/size_bounds.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::particles {

/// Lengths in mm, positions in the lattice frame.
///
/// The size h at a point is the sizing field's h or the bounds' (size_bounds.h), whichever is smaller. Particles are
/// spaced by h/g, where g is the contraction: with g > 1, even edges longer than the average stay below h0.
class SizedSurface {
 public:
  /// Keeps references to the surface and the field. `delta` > 0 is the rise of an added bound, mm per mm.
  SizedSurface(const Isosurface& surface, const SizingField& field, double contraction = 1.0, double delta = 0.3)
      : surface_(surface), field_(field), contraction_(contraction), bounds_(surface, delta) {}

  const Isosurface& surface() const { return surface_; }
  const SizingField& field() const { return field_; }
  double contraction() const { return contraction_; }  ///< g
  const SizeBounds& bounds() const { return bounds_; }

  /// The distance that particles near x keep: h/g.
  double spacing(const Eigen::Vector3d& x) const { return std::min(field_.h(x), bounds_.bound(x)) / contraction_; }

  /// Adds bounds, which make h smaller around some points.
  void add_bounds(const std::vector<SizeBound>& bounds) { bounds_.add(bounds); }

 private:
  const Isosurface& surface_;
  const SizingField& field_;
  double contraction_;
  SizeBounds bounds_;
};

}  // namespace isobench::particles
