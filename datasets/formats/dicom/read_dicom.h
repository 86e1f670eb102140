// DICOM: series of images, one slice a file, and files of several frames.
#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// Reads the series of a folder, or the one that a file belongs to. Of a folder with a DICOMDIR, or with no DICOM file
/// of its own, the folders in it are searched, too; other files are passed over and counted in a note. Orders slices by
/// their positions. Throws DataError naming the path; see series_of() and stack_slices() for what is refused.
VolumeFile read_dicom(const std::filesystem::path& path, const VolumeChoice& choice);

/// Whether there is a DICOM file in the folder or the folders in it.
bool has_dicom_files(const std::filesystem::path& folder);

}  // namespace isobench
