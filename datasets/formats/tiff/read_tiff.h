// TIFF: files of several pages, and stacks of files of one page.
#pragma once

#include <filesystem>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// Reads a file, or the stack that a folder or a pattern such as "slice*.tif" or "slice%03d.tif" means: files of one
/// page each, in the order of the numbers in their names. Spacing, channels and steps come from what ImageJ or OME
/// wrote into the file, else the spacing comes from the resolution; where none is stated it is 1 mm, and a note says
/// so. Throws DataError naming the file.
VolumeFile read_tiff(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace isobench
