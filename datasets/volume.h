// Samples on an oriented, anisotropic lattice.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "isobench/datasets/samples.h"

namespace isobench {

/// Where the nodes of a lattice lie. World position of node (i, j, k), in mm:
///   origin + direction * (spacing ∘ (i, j, k)).
struct Lattice {
  std::array<int, 3> size{0, 0, 0};                         ///< nodes along i, j, k
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();        ///< mm, > 0
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();         ///< mm, world position of node (0, 0, 0)
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();  ///< columns: unit world directions of i, j, k
  std::string space;  ///< the world's axes as the file states them: "RAS", "LPS", or "" if it does not

  std::size_t nodes() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  /// The geometric mean of the spacing, mm: the length of "a voxel" where one number is needed.
  double voxel() const;
  /// From the lattice frame (mm, axes along the lattice, node (0, 0, 0) at the origin) to the world, and back.
  Eigen::Vector3d to_world(const Eigen::Vector3d& local) const { return origin + direction * local; }
  Eigen::Vector3d to_local(const Eigen::Vector3d& world) const;
  /// Whether the axes are perpendicular to 5e-3 (0.3°), which allows for rounding in headers: an error of 5e-3 of
  /// lengths measured along the lattice. Points go to the world and back by the axes as they are.
  bool is_rectangular() const;
  /// False if the axes i, j, k form a left-handed system: mapping a mesh to the world then turns its triangles over.
  bool right_handed() const;
};

/// A scalar volume whose samples keep the type of the file: lattice.nodes() of them, i running fastest.
/// F is computed from floats (see Isosurface); labels and thresholds are compared in the samples' own type.
struct Volume {
  Lattice lattice;
  Samples samples;
};

/// A volume of real numbers: of floats, the result of phantoms, smoothing, resampling and distances, or of doubles
/// where floats cannot hold the samples.
template <class Real>
struct RealVolume {
  Lattice lattice;
  std::vector<Real> samples;

  Real at(int i, int j, int k) const { return samples[lattice.index(i, j, k)]; }
  Real& at(int i, int j, int k) { return samples[lattice.index(i, j, k)]; }

  /// Moves the samples of a temporary, copies those of a variable.
  operator Volume() && { return {std::move(lattice), std::move(samples)}; }  // NOLINT(google-explicit-constructor)
  operator Volume() const& { return {lattice, samples}; }                    // NOLINT(google-explicit-constructor)
};
using FloatVolume = RealVolume<float>;
using DoubleVolume = RealVolume<double>;

/// Whether a float would round some sample: an integer beyond 2^24, or a double that is no float. Linear time; costs
/// nothing for the types that floats hold.
bool needs_double(const Volume& volume);

/// Rounds every sample to Real, float or double; moves the samples if they are of this type already. Throws DataError
/// naming the node if a sample is too large for a float. While it runs, both arrays are in memory.
template <class Real>
RealVolume<Real> as_real(Volume volume);
inline FloatVolume as_float(Volume volume) { return as_real<float>(std::move(volume)); }

/// The smallest and the largest sample; 64-bit integers beyond 2^53 are rounded.
struct Range {
  double min = 0.0;
  double max = 0.0;
};
/// Throws DataError naming the node if a sample is NaN or infinite, or if there are no samples. Linear time; takes no
/// memory.
Range sample_range(const Volume& volume);

/// "[0, 255]": the smallest and the largest sample, exact in the samples' own type. Throws as sample_range() does.
std::string range_text(const Volume& volume);

/// Whether no sample is NaN or infinite. Costs nothing for integers.
bool is_finite(const Volume& volume);
/// Throws DataError naming the node if a sample is NaN or infinite. Costs nothing for integers.
void check_finite(const Volume& volume);

}  // namespace isobench
