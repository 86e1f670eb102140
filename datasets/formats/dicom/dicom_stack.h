// Slices in the order in which they lie in the patient, and the lattice that they make.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/formats/dicom/dicom_series.h"
#include "isobench/datasets/formats/reading/volume_file.h"
#include "isobench/datasets/volume.h"

namespace isobench {

struct DicomStack {
  std::vector<DicomSlice> slices;  ///< one for each k
  Lattice lattice;                 ///< in LPS
  std::vector<std::string> notes;  ///< sentences that begin with the path
};

/// Orders slices by where they lie along their normal, whatever the names of their files and their numbers are. Copies
/// of a slice are dropped; of several phases at each place, `choice.step` takes one. The slices may be shifted within
/// their planes, as those of a tilted gantry are: the lattice is sheared then. Throws DataError that names `path` where
/// a slice is missing, where distances or shifts are not equal (by more than 1 % of the distance), or where the files
/// do not say where the slices lie.
DicomStack stack_slices(const DicomSeries& series, const VolumeChoice& choice, const std::filesystem::path& path);

}  // namespace isobench
