#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// MRC and CCP4 maps of electron microscopy and crystallography, plain or compressed. Their unit is the ångström.
VolumeFile read_mrc(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace isobench
