// Samples on an oriented, anisotropic lattice.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace isobench {

/// Where the nodes of a lattice lie. World position of node (i, j, k), in mm:
///   origin + direction * (spacing ∘ (i, j, k)).
struct Lattice {
  std::array<int, 3> size{0, 0, 0};                         ///< nodes along i, j, k
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();        ///< mm, > 0
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();         ///< mm, world position of node (0, 0, 0)
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();  ///< columns: unit world directions of i, j, k
  std::string space;  ///< the world's axes as the file states them: "RAS", "LPS", or "" (not said)

  std::size_t nodes() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  /// The geometric mean of the spacing: "a voxel" where one length is meant.
  double voxel() const;
  /// Lattice frame (spacing ∘ (i, j, k), mm, axis-aligned, node (0,0,0) at 0) to world and back.
  Eigen::Vector3d to_world(const Eigen::Vector3d& local) const { return origin + direction * local; }
  Eigen::Vector3d to_local(const Eigen::Vector3d& world) const;
  /// False where the axes i, j, k form a left-handed system: mapping to the world then mirrors triangles.
  bool right_handed() const;
};

/// A scalar volume; samples in x-fastest order, lattice.nodes() of them.
struct Volume {
  Lattice lattice;
  std::vector<float> samples;

  float at(int i, int j, int k) const { return samples[lattice.index(i, j, k)]; }
  float& at(int i, int j, int k) { return samples[lattice.index(i, j, k)]; }
};

struct Range {
  float min = 0.0F;
  float max = 0.0F;
};
/// Smallest and largest sample. Throws DataError naming the node if a sample is NaN or infinite, or if there are none.
Range sample_range(const Volume& volume);

}  // namespace isobench
