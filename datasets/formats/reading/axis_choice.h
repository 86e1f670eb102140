// Which axes of a file's array are space, and which place is meant on each of the others.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

/// What the places of an axis are.
enum class AxisKind {
  space,
  step,       ///< of a series in time
  component,  ///< of vectors, of colours, or entries of a list
};

/// An axis as a header states it.
struct ArrayAxis {
  long long size = 1;
  AxisKind kind = AxisKind::space;
};

/// The axes, the fastest first, with the chosen place on each that is not space. Throws DataError that names the file
/// if a size is below 1 or their product is above 2^40, if several axes have steps or several have components, if the
/// choice is not made although there are several places, or if it names a place that is not there.
std::vector<FileAxis> choose_places(std::span<const ArrayAxis> axes, const VolumeChoice& choice,
                                    const std::filesystem::path& path);

}  // namespace isobench
