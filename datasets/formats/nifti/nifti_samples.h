// The samples of a NIfTI file: their type, their axes in the file, and their scale.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/formats/nifti/nifti_header.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/volume_file.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// The type of the samples, or of one part of a colour. Throws DataError for types that no volume can have.
SampleType nifti_sample_type(const NiftiFields& fields, const std::filesystem::path& path,
                             std::vector<std::string>& notes);

/// The axes of the array in the file: parts of a colour, the three axes of the volume, time, components. Throws
/// DataError if the choice does not say which of several volumes is meant, or if the sizes are too large for any file.
std::vector<FileAxis> nifti_axes(const NiftiFields& fields, const VolumeChoice& choice,
                                 const std::filesystem::path& path);

/// slope · sample + intercept, computed in double. Integers stay integers if the slope and the intercept are whole
/// numbers, so that labels stay what they are; otherwise they become floating-point numbers that keep them apart.
Samples nifti_scaled(Samples samples, const NiftiFields& fields, const std::filesystem::path& path,
                     std::vector<std::string>& notes);

}  // namespace isobench
