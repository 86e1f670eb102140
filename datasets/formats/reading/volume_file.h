// What a reader of a file format is asked for, and what it gives.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

/// Which scalar volume is meant, where a file or a folder holds several. A choice that is not made means the only one
/// that there is; a reader that finds several then throws DataError with the names of all that can be chosen.
struct VolumeChoice {
  std::optional<std::size_t> step = {};       ///< of a series in time; the first is 0
  std::optional<std::size_t> component = {};  ///< of samples that are vectors or colours; the first is 0
  std::string array = {};                     ///< the name of an array of a VTI file
  std::string segment = {};  ///< the name, the ID or the label of a segment, or "layer N" for all of a layer
  std::string series = {};   ///< of DICOM files: its number or its UID
};

/// The choices that a format knows.
struct KnownChoices {
  bool step = false;
  bool component = false;
  bool array = false;
  bool segment = false;
  bool series = false;
};

/// A volume as it is in a file. Its samples may be NaN or infinite, and its axes need not be perpendicular
/// (preparation/needed_steps.h).
struct VolumeFile {
  Volume volume;
  /// What the user should know of how the file was read: sentences that begin with the file's path.
  std::vector<std::string> notes;
};

}  // namespace isobench
