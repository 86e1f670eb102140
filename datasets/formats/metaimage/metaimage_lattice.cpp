#include "isobench/datasets/formats/metaimage/metaimage_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

std::size_t whole_count(const MetaImageHeader& header, const char* key, double otherwise, double most) {
  const double count = header.numbers({key}, 1, {otherwise}).front();
  if (count >= 1.0 && count <= most && count == std::floor(count)) return static_cast<std::size_t>(count);
  throw DataError(fmt::format("{}: its {} '{}' is not a whole number from 1 to {}; correct its header",
                              header.path.string(), key, header.text({key}, "").substr(0, 60), most));
}

std::size_t dimensions_of(const MetaImageHeader& header) {
  const std::size_t dimensions = whole_count(header, "NDims", 3.0, 10.0);
  if (dimensions >= 2) return dimensions;
  throw DataError(header.path.string() + ": its NDims is 1, but a 3-D volume has three and a slice has two");
}

std::vector<double> spacing_of(MetaImageHeader& header, std::size_t dimensions) {
  if (!header.has("ElementSpacing")) {
    // The extent of a sample takes the place of the distance between samples.
    header.note(header.has("ElementSize") ? "its header has no ElementSpacing; its ElementSize was taken"
                                          : "its header has no ElementSpacing; 1 was taken");
  }
  return header.numbers({"ElementSpacing", "ElementSize"}, dimensions, std::vector<double>(dimensions, 1.0));
}

/// The columns are the directions of the axes of space. In the file, row n of the matrix is that of axis n.
Eigen::Matrix3d direction_of(const MetaImageHeader& header, std::size_t dimensions) {
  std::vector<double> identity(dimensions * dimensions, 0.0);
  for (std::size_t n = 0; n < dimensions; ++n) identity[n * dimensions + n] = 1.0;
  const std::vector<double> matrix =
      header.numbers({"TransformMatrix", "Orientation", "Rotation"}, dimensions * dimensions, identity);
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
  for (std::size_t row = 0; row < dimensions; ++row) {
    for (std::size_t column = 0; column < dimensions; ++column) {
      const double cosine = matrix[row * dimensions + column];
      if (row < 3 && column < 3)
        direction(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) = cosine;
      else if (row != column && cosine != 0.0)
        throw DataError(header.path.string() +
                        ": its TransformMatrix mixes the axes of space with others; correct its header");
    }
  }
  return direction;
}

/// The letter of the side that an axis comes from, in a world whose axes run to the left, to the back and up.
char letter_of(const Eigen::Vector3d& direction, bool of_origin) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const bool from_first = (direction[axis] > 0.0) == of_origin;
  return (from_first ? "RAI" : "LPS")[axis];
}

/// The letters repeat what the matrix states. Programs disagree on whether they name the sides that the axes come from
/// or lead to, so one of the two must fit.
void check_letters(MetaImageHeader& header, const Eigen::Matrix3d& direction) {
  std::string letters = header.text({"AnatomicalOrientation"}, "");
  if (letters.size() != 3 || letters.find_first_not_of("RLAPISrlapis") != std::string::npos) return;
  std::string from;
  std::string to;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    from.push_back(letter_of(direction.col(axis), true));
    to.push_back(letter_of(direction.col(axis), false));
  }
  if (lower_case(letters) == lower_case(from) || lower_case(letters) == lower_case(to)) return;
  header.note(
      fmt::format("its AnatomicalOrientation {} does not fit its TransformMatrix, whose axes come from {}; the "
                  "matrix was taken",
                  letters, from));
}

void check_intensity(MetaImageHeader& header) {
  const double slope = header.numbers({"ElementToIntensityFunctionSlope"}, 1, {1.0}).front();
  const double offset = header.numbers({"ElementToIntensityFunctionOffset"}, 1, {0.0}).front();
  if (slope == 1.0 && offset == 0.0) return;
  header.note(fmt::format("its ElementToIntensityFunction, {} · sample + {}, was not applied; values are as stored",
                          slope, offset));
}

}  // namespace

std::vector<ArrayAxis> metaimage_axes(const MetaImageHeader& header) {
  const std::size_t dimensions = dimensions_of(header);
  std::vector<ArrayAxis> axes;
  const std::size_t channels = whole_count(header, "ElementNumberOfChannels", 1.0, 1e9);
  if (channels > 1) axes.push_back({static_cast<long long>(channels), AxisKind::component});
  const std::vector<double> sizes = header.numbers({"DimSize"}, dimensions, {});
  if (sizes.empty()) throw DataError(header.path.string() + ": its header has no DimSize; copy or export it again");
  for (std::size_t n = 0; n < dimensions; ++n)
    axes.push_back({size_in(sizes[n]), n < 3 ? AxisKind::space : AxisKind::step});
  return axes;
}

Lattice metaimage_lattice(MetaImageHeader& header) {
  const std::size_t dimensions = dimensions_of(header);
  const std::vector<double> spacings = spacing_of(header, dimensions);
  const std::vector<double> offset =
      header.numbers({"Offset", "Position", "Origin"}, dimensions, std::vector<double>(dimensions, 0.0));
  const double unit = unit_in_mm(header.text({"DistanceUnits"}, "mm"), header.path);
  std::array<long long, 3> size{1, 1, 1};
  std::size_t next = 0;
  for (const ArrayAxis& axis : metaimage_axes(header)) {
    if (axis.kind == AxisKind::space) size[next++] = axis.size;
  }
  Eigen::Matrix3d direction = direction_of(header, dimensions);
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < std::min<std::size_t>(dimensions, 3); ++n) {
    spacing[static_cast<Eigen::Index>(n)] = unit * spacings[n];
    origin[static_cast<Eigen::Index>(n)] = unit * offset[n];
  }
  if (dimensions == 2) {
    const Eigen::Matrix3d steps = steps_of_slice(spacing[0] * direction.col(0), spacing[1] * direction.col(1));
    direction.col(2) = steps.col(2);
    spacing[2] = steps.col(2).norm();
    header.note(fmt::format("it is one 2-D slice; {:.4g} mm were taken as its thickness", spacing[2]));
  }
  Lattice lattice = make_lattice(header.path, size, spacing, direction, origin, "LPS");
  if (dimensions >= 3) check_letters(header, lattice.direction);
  check_intensity(header);
  return lattice;
}

}  // namespace isobench
