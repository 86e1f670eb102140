// For tests: the header of FreeSurfer's MGH for the volume of oblique_files.h.
#pragma once

#include <string>

#include "isobench/datasets/formats/testing/oblique_files.h"

namespace isobench {

/// MGH is big-endian: its bytes are those of the other order on all machines that this runs on.
template <class Value>
void put_mgh(std::string& header, std::size_t at, Value value) {
  header.replace(at, sizeof value, bytes_of_value(value, true));
}

/// The header of 284 bytes for samples of a type of the format: 0 uchar, 1 int, 3 float, 4 short, 10 ushort.
inline std::string mgh_header(int type, int frames = 1) {
  std::string header(284, '\0');
  const int first[] = {1, nx, ny, nz, frames, type};
  for (std::size_t n = 0; n < 6; ++n) put_mgh(header, 4 * n, first[n]);
  put_mgh(header, 28, std::int16_t{1});
  const Eigen::Vector3d centre =
      origin + oblique() * spacing.cwiseProduct(Eigen::Vector3d(0.5 * nx, 0.5 * ny, 0.5 * nz));
  const Eigen::Matrix3d direction = oblique();
  for (int n = 0; n < 3; ++n) {
    const std::size_t at = 4 * static_cast<std::size_t>(n);
    put_mgh(header, 30 + at, static_cast<float>(spacing[n]));
    put_mgh(header, 78 + at, static_cast<float>(centre[n]));
    for (int axis = 0; axis < 3; ++axis)
      put_mgh(header, 42 + 12 * static_cast<std::size_t>(axis) + at, static_cast<float>(direction(n, axis)));
  }
  return header;
}

}  // namespace isobench
