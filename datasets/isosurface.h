// The surface F = c, where F is the smooth function that spline kernels reconstruct from a volume
// (Meyer, Kirby, Whitaker 2007, section 3; Kindlmann et al. 2003 for the derivatives).
//
// Everything here lives in the *lattice frame*: millimetres, axes along the lattice, node (0, 0, 0) at the origin.
// Meshing and measuring happen there, so that an oblique or far-away volume costs neither time nor precision;
// Lattice::to_world places the finished mesh.
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
  /// The cubic B-spline through the samples: its coefficients are solved for (the prefilter of Unser, Aldroubi, Eden
  /// 1991, exactly for the border used here). The plain B-spline smooths, which is right for segmentations, but it can
  /// weld sheets that the samples of a grey-scale scan keep apart.
  interpolating_bspline,
  catmull_rom,  ///< Catmull-Rom values with B-spline derivatives, as the paper mixes them: interpolating
};

std::string to_string(Kernel kernel);  ///< "bspline", "interpolating-bspline", "catmull-rom"

/// Which side of c is the object.
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
  /// Takes the samples over. Throws DataError if a sample is not finite, a dimension is below 4,
  /// c is outside the range of the node values (the message says the range), or no lattice edge crosses c.
  Isosurface(Volume volume, double isovalue, Inside inside = Inside::above, Kernel kernel = Kernel::bspline);

  double value(const Eigen::Vector3d& x) const;
  /// Value and gradient; the Hessian of the result stays zero.
  Jet value_gradient(const Eigen::Vector3d& x) const;
  Jet jet(const Eigen::Vector3d& x) const;

  /// The foot of x: x ← x − f∇f/|∇f|², each step at most half a voxel, until |f|/|∇f| < tolerance·voxel.
  /// std::nullopt after `max_steps` steps or where the gradient vanishes.
  std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& x, double tolerance = 1e-6, int max_steps = 10) const;

  /// f at every lattice node of one slab of constant k, size[0]*size[1] values, x fastest.
  /// At nodes the B-spline is a 3-tap separable filter, so this is far cheaper than value().
  void node_values(int k, std::vector<float>& slab) const;

  /// The samples as they were given, ±(sample − c), of one slab of constant k, x fastest; for what does not use F.
  void sample_values(int k, std::vector<float>& slab) const;

  const Lattice& lattice() const { return lattice_; }
  double isovalue() const { return isovalue_; }
  Inside inside() const { return inside_; }
  Kernel kernel() const { return kernel_; }
  double voxel() const { return voxel_; }
  /// The largest lattice-frame point: spacing ∘ (size − 1).
  const Eigen::Vector3d& extent() const { return extent_; }
  /// The coefficient that the spline has at a node (sign applied, c subtracted), indices clamped to the lattice.
  float coefficient(int i, int j, int k) const;

 private:
  void check_crossing() const;
  void copy_coefficients(int k, std::vector<float>& slab) const;
  using Block = std::array<float, 64>;
  /// The 4³ coefficients around a point: the first, and how far it is to the next row and slab.
  struct Taps {
    const float* first;
    std::ptrdiff_t row;
    std::ptrdiff_t slab;
  };
  /// t: where x lies in its cell. Near the lattice's border the coefficients are clamped copies in `border`, so that
  /// none but those of the volume need memory.
  Taps taps(const Eigen::Vector3d& x, std::array<double, 3>& t, Block& border) const;

  Lattice lattice_;
  std::vector<float> coefficients_;  // ±(sample − c), or what the prefilter makes of it
  double isovalue_;
  Inside inside_;
  Kernel kernel_;
  double voxel_;
  Eigen::Vector3d inverse_spacing_;
  Eigen::Vector3d extent_;
};

/// Outward unit normal from a gradient of f.
inline Eigen::Vector3d outward_normal(const Eigen::Vector3d& gradient) { return -gradient.normalized(); }

/// Principal curvatures of the level set through a jet's point, κ1 ≥ κ2, positive where the object is convex
/// (Kindlmann et al. 2003: G = −P H P/|∇f|, T = tr G, N = ‖G‖, κ = (T ± √max(0, 2N² − T²))/2).
struct Curvatures {
  double k1 = 0.0;
  double k2 = 0.0;
  double max_abs() const;
};
Curvatures curvatures(const Jet& jet);

}  // namespace isobench
