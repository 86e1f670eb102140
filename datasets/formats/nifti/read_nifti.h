#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// NIfTI-1, NIfTI-2 and ANALYZE 7.5, in one file or as a pair of which either file may be named.
VolumeFile read_nifti(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace isobench
