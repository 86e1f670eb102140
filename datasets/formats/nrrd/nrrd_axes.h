// Which axes of an NRRD file's array are space, steps in time or components, and where its nodes lie.
#pragma once

#include <vector>

#include "isobench/datasets/formats/nrrd/nrrd_header.h"
#include "isobench/datasets/formats/nrrd/nrrd_space.h"
#include "isobench/datasets/formats/reading/axis_choice.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// The axes of the array, the fastest first; two or three of them are space. The directions of the space decide;
/// without them the kinds of the axes, and then which of them have a spacing. Adds a note to the header where this is a
/// guess. Throws DataError if less than two or more than three axes are space.
std::vector<ArrayAxis> nrrd_axes(NrrdHeader& header, const NrrdSpace& space);

/// How many dimensions the array has. Throws DataError unless the header states a whole number from 1 to 16.
std::size_t nrrd_dimension(const NrrdHeader& header);

/// The lattice of the axes that are space. Without space directions it is that of spacings, of axis mins and maxs, or
/// of thicknesses. Two axes of space make one slice. Adds notes to the header. Throws DataError as make_lattice() does.
Lattice nrrd_lattice(NrrdHeader& header, const NrrdSpace& space, const std::vector<ArrayAxis>& axes);

}  // namespace isobench
