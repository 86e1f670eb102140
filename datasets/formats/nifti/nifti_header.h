// The header of NIfTI-1, NIfTI-2 and ANALYZE 7.5 files (https://nifti.nimh.nih.gov): fields of a fixed place and type.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/formats/reading/byte_reader.h"

namespace isobench {

/// Where the samples are, and how far the header can be believed.
enum class NiftiKind {
  one_file,  ///< NIfTI, header and samples in one file
  pair,      ///< NIfTI, header and samples in two files
  analyze,   ///< two files; the header is that of ANALYZE 7.5, without a place in the world
};

/// The fields of all versions in one form, as the file states them but for `dim`.
struct NiftiFields {
  NiftiKind kind = NiftiKind::one_file;
  std::size_t bytes = 0;  ///< of the header, without extensions
  ByteOrder order = ByteOrder::little;
  std::array<long long, 8> dim{};  ///< [0] is the number of dimensions, 1 to 7; sizes beyond it are 1
  int datatype = 0;
  int bits = 0;
  std::array<double, 8> pixdim{};  ///< [0] is the handedness of the qform
  double offset = 0.0;             ///< of the samples; bytes
  double slope = 0.0;
  double intercept = 0.0;
  int units = 0;
  int intent = 0;
  int qform = 0;
  int sform = 0;
  Eigen::Vector3d quaternion = Eigen::Vector3d::Zero();
  Eigen::Vector3d qoffset = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 4> srow = Eigen::Matrix<double, 3, 4>::Zero();
  std::string unit_name;  ///< of ANALYZE, which has a text in place of a code

  long long size(std::size_t axis) const { return dim[axis + 1]; }  ///< of axis 0 to 6
};

/// Reads the header at the reader's beginning. A header without NIfTI's mark is one of ANALYZE 7.5 if
/// `may_be_analyze`. Adds to `notes` what was put right. Throws DataError if it is another file, is truncated, or has
/// sizes that cannot be meant.
NiftiFields read_nifti_header(ByteReader& reader, bool may_be_analyze, std::vector<std::string>& notes);

}  // namespace isobench
