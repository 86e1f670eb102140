// Where the samples of an MRC or CCP4 map lie.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/formats/mrc/mrc_header.h"
#include "isobench/datasets/volume.h"

namespace isobench {

/// The lattice in mm, with an axis each for columns, rows and sections, which need not be perpendicular. `sections` are
/// those of one volume. `notes` says which unit the file has, and what was taken where the header states nothing or
/// contradicts itself. Throws DataError if no lattice can be made.
Lattice mrc_lattice(const MrcHeader& header, long long sections, const std::filesystem::path& path,
                    std::vector<std::string>& notes);

}  // namespace isobench
