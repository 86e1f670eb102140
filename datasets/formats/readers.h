// The readers behind read_volume(), one for each format, and the functions that they share.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

Volume read_nrrd(const std::filesystem::path& path);
Volume read_metaimage(const std::filesystem::path& path);
Volume read_nifti(const std::filesystem::path& path);
Volume read_vti(const std::filesystem::path& path);
Volume read_inrimage(const std::filesystem::path& path);

/// Makes and checks a lattice; the columns of `direction` may have any length and are normalised. Throws DataError
/// naming the file if a size is below 1 or their product too large, if a spacing is not positive, if the axes are not
/// perpendicular, or if the origin is not finite.
Lattice make_lattice(const std::filesystem::path& path, const std::array<long long, 3>& size,
                     const Eigen::Vector3d& spacing, const Eigen::Matrix3d& direction, const Eigen::Vector3d& origin,
                     const std::string& space);

/// The numbers in a text, which may have brackets and commas. Throws DataError naming the file and `what` if there are
/// not exactly `count` of them.
std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::filesystem::path& path,
                               const std::string& what);

/// How many mm a unit of length has: "mm", "cm", "m" or "um"; an unknown unit, "" or "?", counts as mm. Throws
/// DataError for any other unit.
double unit_in_mm(const std::string& unit, const std::filesystem::path& path);

}  // namespace isobench
