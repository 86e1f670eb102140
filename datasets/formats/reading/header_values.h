// The values of a file's header: what every reader checks in the same way. A DataError names the file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/volume.h"

namespace isobench {

/// The least determinant of a lattice's three unit axes. A gantry is tilted by at most 30°, and a slice is never nearly
/// parallel to the direction of the slices.
inline constexpr double least_determinant = 0.1;

/// Makes and checks a lattice; the columns of `direction` may have any length and are normalised. They need not be
/// perpendicular. Throws DataError naming the file if a size is below 1 or their product too large, if a spacing is not
/// positive, if the three axes lie nearly in a plane, or if the origin is not finite.
Lattice make_lattice(const std::filesystem::path& path, const std::array<long long, 3>& size,
                     const Eigen::Vector3d& spacing, const Eigen::Matrix3d& direction, const Eigen::Vector3d& origin,
                     const std::string& space);

/// The steps from node to node of a 2-D image that is taken as one slice. The third is perpendicular to the two that
/// are given, and its length is their geometric mean, because the file has none.
Eigen::Matrix3d steps_of_slice(const Eigen::Vector3d& i, const Eigen::Vector3d& j);

/// A number of nodes or steps as a header states it; 0, which make_lattice() refuses, unless it is a whole number from
/// 1 to 2^31 - 1.
long long size_in(double number);

/// The numbers in a text, which may have brackets and commas; none in an empty text. Throws DataError naming the file
/// and `what` if something else is among them.
std::vector<double> all_numbers_in(const std::string& text, const std::filesystem::path& path, const std::string& what);

/// The same; throws DataError, too, if there are not exactly `count` of them.
std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::filesystem::path& path,
                               const std::string& what);

/// Whether the text is a number. Blanks may stand around it.
bool is_number(const std::string& text);

/// How many mm a unit of length has, in the spellings that files have: "mm", "millimeter", "µm" with either of the two
/// signs for mu, "m" and so on; "", "?" and "pixel" count as mm. Throws DataError for any other unit.
double unit_in_mm(const std::string& unit, const std::filesystem::path& path);

}  // namespace isobench
