#include "isobench/datasets/formats/mrc/mrc_placement.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr double angstrom = 1e-7;  // mm

/// Exact at 90°, so that a rectangular cell gives a rectangular lattice.
double cosine(double degrees) { return degrees == 90.0 ? 0.0 : std::cos(degrees * std::numbers::pi / 180.0); }

/// The unit directions of the cell's axes as columns, in the convention of crystallography: X along the first axis of
/// the world, Y in the plane of the first two.
Eigen::Matrix3d directions_of(const MrcHeader& header, const std::filesystem::path& path) {
  Eigen::Vector3d angles = header.angles;
  if (angles.isZero()) angles.setConstant(90.0);  // as old programs leave them
  const double alpha = cosine(angles[0]);
  const double beta = cosine(angles[1]);
  const double gamma = cosine(angles[2]);
  const double sine = std::sqrt(1.0 - gamma * gamma);
  const double along_y = (alpha - beta * gamma) / sine;
  const double height = std::sqrt(1.0 - beta * beta - along_y * along_y);
  const bool are_angles = (angles.array() > 0.0).all() && (angles.array() < 180.0).all();
  if (!are_angles || !(height > 0.0)) {
    throw DataError(fmt::format("{}: no cell has the angles {}°, {}° and {}°; correct the header", path.string(),
                                angles[0], angles[1], angles[2]));
  }
  return Eigen::Matrix3d{{1.0, gamma, beta}, {0.0, sine, along_y}, {0.0, 0.0, height}};
}

/// The axis of the array that runs along X, Y or Z.
std::size_t array_axis(const MrcHeader& header, int axis) {
  for (std::size_t n = 0; n < 3; ++n) {
    if (header.axis[n] == axis) return n;
  }
  return 0;  // the header was checked: there is one
}

/// The distances between samples along X, Y and Z, in Å.
Eigen::Vector3d spacing_of(const MrcHeader& header, const std::filesystem::path& path,
                           std::vector<std::string>& notes) {
  Eigen::Vector3d spacing = Eigen::Vector3d::Zero();
  bool has_intervals = true;
  double known = 0.0;  // along the first axis that has one
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!(header.cell[axis] > 0.0) || !std::isfinite(header.cell[axis])) continue;
    const bool is_stated = header.intervals[a] > 0;
    has_intervals = has_intervals && is_stated;
    spacing[axis] = header.cell[axis] /
                    static_cast<double>(is_stated ? header.intervals[a] : header.size[array_axis(header, axis)]);
    if (known == 0.0) known = spacing[axis];
  }
  if (known == 0.0) {
    notes.push_back(path.string() + ": it does not state the size of its voxels; 1 Å is taken");
    return Eigen::Vector3d::Ones();
  }
  if (!has_intervals) {
    notes.push_back(path.string() +
                    ": it does not state how many intervals its cell has; one for each sample is taken");
  }
  if ((spacing.array() == 0.0).any()) {
    notes.push_back(
        fmt::format("{}: it does not state the size of its voxels along every axis; {:.6g} Å is taken there",
                    path.string(), known));
  }
  return (spacing.array() == 0.0).select(known, spacing);
}

/// The place of the first node, in Å: what the header calls the origin, or else the number of the first column, row
/// and section, as programs for crystals state it.
Eigen::Vector3d mrc_origin(const MrcHeader& header, const Eigen::Matrix3d& steps, const std::filesystem::path& path,
                           std::vector<std::string>& notes) {
  Eigen::Vector3d by_start = Eigen::Vector3d::Zero();
  for (int n = 0; n < 3; ++n) by_start += static_cast<double>(header.start[static_cast<std::size_t>(n)]) * steps.col(n);
  if (header.origin.isZero(0.0)) return by_start;
  // IMOD's files had the other sign before it followed the standard, and say so by a flag.
  constexpr int usual_sign = 4;
  const bool is_standard = header.version / 10 == 2014;
  const bool is_negative = header.is_imod && !is_standard && (header.imod_flags & usual_sign) == 0;
  const Eigen::Vector3d origin = is_negative ? Eigen::Vector3d(-header.origin) : header.origin;
  if (!by_start.isZero(0.0) && (origin - by_start).norm() > 0.1 * steps.colwise().norm().minCoeff()) {
    notes.push_back(
        fmt::format("{}: its ORIGIN puts its first sample at ({:.6g}, {:.6g}, {:.6g}) Å, its NXSTART, NYSTART and "
                    "NZSTART at ({:.6g}, "
                    "{:.6g}, {:.6g}) Å; ORIGIN is taken",
                    path.string(), origin[0], origin[1], origin[2], by_start[0], by_start[1], by_start[2]));
  }
  return origin;
}

}  // namespace

Lattice mrc_lattice(const MrcHeader& header, long long sections, const std::filesystem::path& path,
                    std::vector<std::string>& notes) {
  const Eigen::Matrix3d cell = directions_of(header, path) * spacing_of(header, path, notes).asDiagonal();
  Eigen::Matrix3d steps;
  for (int n = 0; n < 3; ++n) steps.col(n) = cell.col(header.axis[static_cast<std::size_t>(n)]);
  const Eigen::Vector3d spacing = steps.colwise().norm();
  const Eigen::Vector3d origin = mrc_origin(header, steps, path, notes);
  notes.push_back(
      fmt::format("{}: its voxels measure {:.6g} × {:.6g} × {:.6g} Å; lengths are in mm from here on, and 1 Å "
                  "is 1e-7 mm",
                  path.string(), spacing[0], spacing[1], spacing[2]));
  return make_lattice(path, {header.size[0], header.size[1], sections}, angstrom * spacing, steps, angstrom * origin,
                      "");
}

}  // namespace isobench
