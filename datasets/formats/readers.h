// One reader a format, behind read_volume(), and what they share.
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

/// A checked lattice; the columns of `direction` may have any length and are normalised. Throws DataError, naming the
/// file, for a size that is not a volume's or whose product overflows, a spacing that is not positive, and axes that
/// are not perpendicular.
Lattice make_lattice(const std::filesystem::path& path, const std::array<long long, 3>& size,
                     const Eigen::Vector3d& spacing, const Eigen::Matrix3d& direction, const Eigen::Vector3d& origin,
                     const std::string& space);

/// The numbers in a text, which may stand in brackets and between commas. Throws DataError, naming the file and `what`,
/// if there are not exactly `count` of them.
std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::filesystem::path& path,
                               const std::string& what);

/// How many mm a unit of length is: "mm", "cm", "m", "um"; throws DataError for others.
double unit_in_mm(const std::string& unit, const std::filesystem::path& path);

}  // namespace isobench
