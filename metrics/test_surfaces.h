// Surfaces whose distances are known.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// The plane z = 10.25 in a lattice of spacing (1, 2, 0.5), the object below it. Splines reproduce a linear function.
inline Isosurface plane() {
  FloatVolume volume;
  volume.lattice.size = {21, 11, 41};
  volume.lattice.spacing = {1.0, 2.0, 0.5};
  for (int k = 0; k < 41; ++k) volume.samples.insert(volume.samples.end(), 21 * 11, static_cast<float>(0.5 * k));
  return {std::move(volume), 10.25, Inside::below};
}

/// A ball of radius 12 mm around (20, 20, 20).
inline Isosurface ball() {
  FloatVolume volume;
  volume.lattice.size = {41, 41, 41};
  for (int k = 0; k < 41; ++k) {
    for (int j = 0; j < 41; ++j) {
      for (int i = 0; i < 41; ++i) {
        volume.samples.push_back(static_cast<float>(12.0 - (Eigen::Vector3d(i, j, k).array() - 20.0).matrix().norm()));
      }
    }
  }
  return {std::move(volume), 0.0};
}

}  // namespace isobench
