// The axes of a MetaImage file's array and the place of its nodes.
#pragma once

#include <vector>

#include "isobench/datasets/formats/metaimage/metaimage_header.h"
#include "isobench/datasets/formats/reading/axis_choice.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// The axes of the array, the fastest first: components if there are several channels, then two or three axes of space,
/// then steps. Throws DataError if a count is not a whole number, or if less than two axes are space.
std::vector<ArrayAxis> metaimage_axes(const MetaImageHeader& header);

/// Two axes of space make one slice. Adds notes to the header. Throws DataError as make_lattice() does, and for a
/// matrix that mixes space and time.
Lattice metaimage_lattice(MetaImageHeader& header);

}  // namespace isobench
