// Writing volumes to files, for other programs to read.
#pragma once

#include <filesystem>

#include "isobench/datasets/volume.h"

namespace isobench {

/// Writes NRRD (.nrrd) or VTI (.vti) by the path's ending: the samples in their own type, little-endian, with spacing,
/// origin and direction, and, in NRRD, the space if it is known. read_volume() gives the same volume again. Throws
/// UsageError for another ending, Error if the file cannot be written.
void write_volume(const Volume& volume, const std::filesystem::path& path);

}  // namespace isobench
