// Reading volumes from files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/formats/reading/volume_file.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// Reads NRRD (.nrrd, .nhdr), MetaImage (.mhd, .mha), NIfTI (.nii, .nii.gz), VTI (.vti), INRIMAGE-4 (.inr, .inr.gz)
/// or TIFF (.tif, .tiff) by the path's ending, and DICOM by the file's first bytes. A folder of DICOM files or of TIFF
/// files, or a pattern such as "slice%03d.tif", means the stack that they make. All with spacing, origin and direction
/// in mm; docs/INPUTS.md says what is understood of each. Samples keep the type that they have in the file; only a
/// slope and an intercept turn them into RealOf their type. Memory: one array of samples, and for VTI the whole file.
/// Throws DataError naming the file if it is missing, empty, truncated, of another format, if it holds several volumes
/// and `choice` does not say which, or if `choice` asks for something that the file or its format does not have.
VolumeFile read_volume(const std::filesystem::path& path, const VolumeChoice& choice = {});

/// The formats that read_volume() knows, for a help text: "NRRD (.nrrd, .nhdr), …".
std::string volume_formats_text();

/// How to read a file without a header.
struct RawLayout {
  std::array<int, 3> size{};                          ///< nodes of the whole volume along i, j, k
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();  ///< mm
  SampleType type = SampleType::u8;
  ByteOrder order = ByteOrder::little;
};

/// Reads raw samples from one file, or from several of equal size in order of k, for example one a slice. Throws
/// DataError naming the file if it cannot be read, or if it does not have exactly the bytes that the layout makes.
Volume read_raw(const std::vector<std::filesystem::path>& files, const RawLayout& layout);

}  // namespace isobench
