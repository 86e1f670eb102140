#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

VolumeFile read_nifti(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace isobench
