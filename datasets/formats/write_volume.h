// Writing volumes to files, for other programs to read.
#pragma once

#include <filesystem>

#include "isobench/datasets/volume.h"

namespace isobench {

/// Writes NRRD (.nrrd) or VTI (.vti) by the path's ending: samples as little-endian float, with spacing, origin,
/// direction and, in NRRD, the space where it is known; read_volume() gives the same volume again. Throws UsageError
/// for another ending, Error where the file cannot be written.
void write_volume(const Volume& volume, const std::filesystem::path& path);

}  // namespace isobench
