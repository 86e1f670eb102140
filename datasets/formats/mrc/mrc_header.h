// The header of MRC and CCP4 files: https://www.ccpem.ac.uk/mrc_format/mrc2014.php, and IMOD's use of it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/formats/reading/byte_reader.h"

namespace isobench {

inline constexpr std::size_t mrc_header_bytes = 1024;

/// The fields as the file states them. Columns, rows and sections are the array's axes; X, Y and Z are those of the
/// unit cell.
struct MrcHeader {
  ByteOrder order = ByteOrder::little;
  std::array<long long, 3> size{};       ///< columns, rows, sections
  int mode = 0;                          ///< the type of the samples
  std::array<long long, 3> start{};      ///< the first column, row and section
  std::array<long long, 3> intervals{};  ///< of the unit cell along X, Y, Z
  Eigen::Vector3d cell;                  ///< its lengths, Å
  Eigen::Vector3d angles;                ///< between Y and Z, Z and X, X and Y; degrees
  std::array<int, 3> axis{0, 1, 2};      ///< which of X, Y, Z the columns, rows and sections run along
  double least = 0.0;                    ///< of the samples
  double largest = 0.0;
  int space_group = 0;  ///< 0: images, 1: a volume, 401 and above: several volumes
  long long extension_bytes = 0;
  int version = 0;  ///< 20140 or 20141 for the standard of 2014, else anything
  bool is_imod = false;
  int imod_flags = 0;
  Eigen::Vector3d origin;  ///< of the first node, Å
};

/// Reads the header at the reader's beginning, in the byte order that makes sense. Adds to `notes` what was put right.
/// Throws DataError if it is another file, is truncated, or contradicts itself.
MrcHeader read_mrc_header(ByteReader& reader, std::vector<std::string>& notes);

}  // namespace isobench
