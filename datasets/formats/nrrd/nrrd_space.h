// The space of an NRRD file: what its fields `space`, `space dimension`, `space units`, `space origin` and `space
// directions` state, in mm.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/nrrd/nrrd_header.h"

namespace isobench {

struct NrrdSpace {
  std::string axes;                                 ///< "RAS", "LPS" or "", as in Lattice
  Eigen::Vector3d flip = Eigen::Vector3d::Ones();   ///< -1 where `axes` are a mirror image of the file's
  std::size_t dimension = 0;                        ///< 0 without a space; beyond 3, the last is time
  Eigen::Vector3d units = Eigen::Vector3d::Ones();  ///< how many mm the space's units have
  /// What an axis of the array moves in space. In a space of four dimensions, an axis may move in time only.
  struct Direction {
    Eigen::Vector3d step = Eigen::Vector3d::Zero();  ///< mm
    bool is_time = false;
  };
  /// One for each axis of the array, without a value where it is "none"; empty without the field.
  std::vector<std::optional<Direction>> directions;
  std::optional<Eigen::Vector3d> origin;  ///< mm; without a value if the file does not state it
};

/// Coordinates in LAS, a mirror image of RAS, become RAS. Adds notes to the header. Throws DataError if a field is not
/// of the format's form. `dimension` is that of the array.
NrrdSpace nrrd_space(NrrdHeader& header, std::size_t dimension);

}  // namespace isobench
