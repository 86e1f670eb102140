#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// FreeSurfer's MGH, plain or compressed (MGZ); the world is RAS, in mm.
VolumeFile read_mgh(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace isobench
