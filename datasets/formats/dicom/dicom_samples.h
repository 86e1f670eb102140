// The samples of DICOM slices.
#pragma once

#include <cstddef>
#include <filesystem>

#include "isobench/datasets/formats/dicom/dicom_stack.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// Reads one component of all slices of a stack, one after the other. Samples keep the type that they have in the
/// files; where the slices state slopes of 1 and whole intercepts, the least integer type that holds the sums; with
/// other slopes and intercepts, RealOf their type. Throws DataError naming the file where it is truncated, where its
/// compression is not known, or where it is damaged. Takes memory as samples arrive.
Samples read_dicom_samples(const DicomStack& stack, std::size_t component);

}  // namespace isobench
