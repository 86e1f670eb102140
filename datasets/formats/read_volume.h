// Reading volumes from files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

/// Reads NRRD (.nrrd, .nhdr), MetaImage (.mhd, .mha), NIfTI (.nii, .nii.gz), VTI (.vti) or INRIMAGE-4 (.inr, .inr.gz)
/// by the path's ending, with spacing, origin and direction, scaled by the file's own slope and intercept, as float.
/// Throws DataError, naming the file, for one that is missing, empty, truncated, of another format or not a 3-D scalar
/// volume, or whose samples are not finite.
Volume read_volume(const std::filesystem::path& path);

enum class SampleType { u8, i8, u16, i16, u32, i32, f32, f64, i64, u64 };
enum class ByteOrder { little, big };

/// What a file without a header does not say of itself.
struct RawLayout {
  std::array<int, 3> size{};                          ///< of the whole volume
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();  ///< mm
  SampleType type = SampleType::u8;
  ByteOrder order = ByteOrder::little;
};

/// Raw samples from one file or from one file a slice, in order of k; together they must have exactly the declared
/// size.
Volume read_raw(const std::vector<std::filesystem::path>& files, const RawLayout& layout);

}  // namespace isobench
