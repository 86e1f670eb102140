// Where a NIfTI volume lies in the world.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/formats/nifti/nifti_header.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// The lattice by the sform, else by the qform, else by the voxel's size alone, as the format demands. The qform takes
/// the place of an sform whose steps are not those that the header states, too. `notes` says what was taken where the
/// header contradicts itself or where it cannot be used. Throws DataError if no lattice can be made.
Lattice nifti_lattice(const NiftiFields& fields, const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace isobench
