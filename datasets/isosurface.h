// The surface F = c, where F is the smooth function that spline kernels reconstruct from a volume
// (Meyer, Kirby, Whitaker 2007, section 3; Kindlmann et al. 2003 for the derivatives).
//
// All points here are in the lattice frame: mm, axes along the lattice, node (0, 0, 0) at the origin. Meshing and
// measuring use this frame, so that an oblique or far-away volume costs neither time nor precision. Lattice::to_world
// moves the finished mesh to its place.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

enum class Kernel {
  bspline,  ///< cubic B-spline for value, gradient and Hessian: approximating, consistent (default)
  /// The cubic B-spline that passes through the samples; its coefficients are the solution of a linear system (the
  /// prefilter of Unser, Aldroubi, Eden 1991, exact for the border used here). The plain B-spline smooths. That suits
  /// segmentations, but it can join sheets that the samples of a grey-scale scan keep apart.
  interpolating_bspline,
  catmull_rom,  ///< values by the Catmull-Rom spline, derivatives by the B-spline, as in the paper: interpolating
};

std::string to_string(Kernel kernel);  ///< "bspline", "interpolating-bspline", "catmull-rom"

/// The side of c on which the object is.
enum class Inside { above, below };

std::string to_string(Inside inside);

/// Value, gradient and Hessian of the signed function f = ±(F − c) at a point.
struct Jet {
  double value = 0.0;                                  ///< > 0 inside
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< 1/mm, points inwards
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< 1/mm²
};

/// f = F − c (inside above) or c − F (inside below), positive inside the object, and its zero set, the surface.
class Isosurface {
 public:
  /// Takes the samples over. The coefficients of F are floats: c is subtracted from the samples in their own type, and
  /// the differences are rounded to float, once; the array of floats is moved, not copied. Memory: 4 bytes a node, and
  /// the samples as given until they are converted. Throws DataError if a sample is not finite or too large for a
  /// float, if there are fewer than 4 nodes along an axis, or if c is outside the range of the samples (the message
  /// says the range). F = c may still be empty.
  Isosurface(Volume volume, double isovalue, Inside inside = Inside::above, Kernel kernel = Kernel::bspline);

  double value(const Eigen::Vector3d& x) const;
  /// Value and gradient only; the Hessian of the result is zero.
  Jet value_gradient(const Eigen::Vector3d& x) const;
  Jet jet(const Eigen::Vector3d& x) const;

  /// Projects x to the surface: x ← x − f∇f/|∇f|², in steps of at most half a voxel, until |f|/|∇f| < tolerance·voxel.
  /// std::nullopt if that takes more than `max_steps` steps or the gradient vanishes.
  std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& x, double tolerance = 1e-6, int max_steps = 10) const;

  /// Replaces c. Each coefficient is rounded to float once more. Not while other threads use the surface.
  void move_isovalue(double isovalue);

  /// f at the nodes of one slab of constant k: size[0]·size[1] values, x fastest. At nodes the B-spline is a separable
  /// filter of three taps, so this is far cheaper than value().
  void node_values(int k, std::vector<float>& slab) const;

  /// ±(sample − c) of one slab of constant k, x fastest, for callers that need the samples instead of F.
  void sample_values(int k, std::vector<float>& slab) const;

  const Lattice& lattice() const { return lattice_; }
  double isovalue() const { return isovalue_; }
  Inside inside() const { return inside_; }
  Kernel kernel() const { return kernel_; }
  double voxel() const { return voxel_; }
  /// The largest lattice-frame point: spacing ∘ (size − 1).
  const Eigen::Vector3d& extent() const { return extent_; }
  /// The spline's coefficient at a node, with the sign applied and c subtracted. Indices are clamped to the lattice.
  float coefficient(int i, int j, int k) const;

 private:
  void copy_coefficients(int k, std::vector<float>& slab) const;
  using Block = std::array<float, 64>;
  /// The 4³ coefficients around a point: the first of them, and the steps to the next row and to the next slab.
  struct Taps {
    const float* first;
    std::ptrdiff_t row;
    std::ptrdiff_t slab;
  };
  /// Sets t to the place of x in its cell, 0 to 1 along each axis. Near the lattice's border the coefficients are
  /// copied to `border` with clamped indices, so that the volume needs no padding.
  Taps taps(const Eigen::Vector3d& x, std::array<double, 3>& t, Block& border) const;

  Lattice lattice_;
  std::vector<float> coefficients_;  // ±(sample − c); with the prefilter, ±(its result − c)
  double isovalue_;
  Inside inside_;
  Kernel kernel_;
  double voxel_;
  Eigen::Vector3d inverse_spacing_;
  Eigen::Vector3d extent_;
};

/// The unit normal that points out of the object, from the gradient of f.
inline Eigen::Vector3d outward_normal(const Eigen::Vector3d& gradient) { return -gradient.normalized(); }

/// Principal curvatures (1/mm) of the level set through a jet's point, κ1 ≥ κ2, positive where the object is convex
/// (Kindlmann et al. 2003: G = −P H P/|∇f|, T = tr G, N = ‖G‖, κ = (T ± √max(0, 2N² − T²))/2).
struct Curvatures {
  double k1 = 0.0;
  double k2 = 0.0;
  double max_abs() const;
};
Curvatures curvatures(const Jet& jet);

}  // namespace isobench
