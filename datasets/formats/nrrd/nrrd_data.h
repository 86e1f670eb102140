// Where the samples of an NRRD file are and how they are encoded.
#pragma once

#include <vector>

#include "isobench/datasets/formats/nrrd/nrrd_header.h"
#include "isobench/datasets/formats/reading/axis_choice.h"
#include "isobench/datasets/formats/reading/read_data_files.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// Throws DataError for types that are not numbers of at most 64 bits.
SampleType nrrd_type(const NrrdHeader& header);

/// The encoding, the order of bytes and the skips. Adds a note to the header if the order of bytes is not stated.
DataLayout nrrd_layout(NrrdHeader& header, SampleType type);

/// The file or the files of samples; `attached` is where the samples begin that follow the header. Checks the number of
/// files against the sizes, and that all are there.
VolumeData nrrd_files(const NrrdHeader& header, std::uintmax_t attached, const std::vector<ArrayAxis>& axes);

}  // namespace isobench
