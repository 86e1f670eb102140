// For tests: headers of NIfTI-2 and ANALYZE 7.5 for the volume of oblique_files.h, field by field.
#pragma once

#include <cstring>
#include <string>

#include "isobench/datasets/formats/testing/oblique_files.h"

namespace isobench {

/// A NIfTI-1 header of floats without a place.
inline NiftiHeader nifti_of_type(std::int16_t code, std::int16_t bits, bool swapped = false) {
  NiftiHeader header(swapped);
  header.put<std::int16_t>(70, code);
  header.put<std::int16_t>(72, bits);
  return header;
}

/// The header of a pair of files: 348 bytes, and their mark.
inline std::string pair_header(NiftiHeader header) {
  header.put<float>(108, 0.0F);
  std::string bytes = header.bytes().substr(0, 348);
  return bytes.replace(344, 4, std::string("ni1\0", 4));
}

/// A NIfTI-2 header of 540 bytes and its four bytes of extension, with an sform for float samples.
inline std::string nifti_2_header(bool swapped = false, bool pair = false) {
  std::string bytes(544, '\0');
  const auto put = [&](std::size_t at, auto value) { bytes.replace(at, sizeof value, bytes_of_value(value, swapped)); };
  put(0, std::int32_t{540});
  bytes.replace(4, 8, std::string(pair ? "ni2\0\r\n\x1a\n" : "n+2\0\r\n\x1a\n", 8));
  put(12, std::int16_t{16});
  put(14, std::int16_t{32});
  const std::int64_t dim[] = {3, nx, ny, nz, 1, 1, 1, 1};
  for (std::size_t n = 0; n < 8; ++n) put(16 + 8 * n, dim[n]);
  put(104, 1.0);
  for (int n = 0; n < 3; ++n) put(112 + 8 * static_cast<std::size_t>(n), spacing[n]);
  put(168, std::int64_t{pair ? 0 : 544});
  put(348, std::int32_t{1});
  const Eigen::Matrix3d steps = oblique() * spacing.asDiagonal();
  for (int row = 0; row < 3; ++row) {
    const std::size_t at = 400 + 32 * static_cast<std::size_t>(row);
    for (int column = 0; column < 3; ++column) put(at + 8 * static_cast<std::size_t>(column), steps(row, column));
    put(at + 24, origin[row]);
  }
  put(500, std::int32_t{2});
  return pair ? bytes.substr(0, 540) : bytes;
}

/// An ANALYZE 7.5 header of shorts. What NIfTI has at its end are texts here.
inline std::string analyze_header(bool swapped = false, float factor = 0.0F) {
  NiftiHeader header = nifti_of_type(4, 16, swapped);
  header.put<std::int32_t>(32, 16384);  // "extents", always this number
  header.put<float>(108, 0.0F);
  header.put<float>(112, factor);
  std::string bytes = header.bytes().substr(0, 348);
  bytes[38] = 'r';
  bytes[123] = '\0';
  bytes.replace(56, 4, std::string("mm\0\0", 4));
  bytes.replace(253, 10, "originator");
  return bytes.replace(344, 4, 4, '\0');
}

}  // namespace isobench
