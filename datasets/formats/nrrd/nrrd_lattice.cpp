// Where the nodes of an NRRD file lie.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "isobench/datasets/formats/nrrd/nrrd_axes.h"
#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr double not_stated = std::numeric_limits<double>::quiet_NaN();

enum class Centering { unknown, node, cell };

/// What the per-axis fields state of one axis, in mm; NaN where they state nothing.
struct AxisFields {
  double spacing = not_stated;
  double thickness = not_stated;
  double min = not_stated;
  double max = not_stated;
  Centering centering = Centering::unknown;
  double last = 0.0;  ///< the index of the last sample
};

/// Reads the fields of all axes of an array.
class AxisFieldsReader {
 public:
  AxisFieldsReader(const NrrdHeader& header, std::size_t dimension)
      : header_(header),
        spacings_(numbers("spacings", dimension)),
        thicknesses_(numbers("thicknesses", dimension)),
        mins_(numbers("axismins", dimension)),
        maxs_(numbers("axismaxs", dimension)),
        units_(header.words("units", dimension)),
        centerings_(header.words("centerings", dimension)) {}

  /// `unit` is that of the space's axis, for files that have only it.
  AxisFields read(std::size_t axis, long long size, double unit) const {
    if (!units_.empty()) unit = unit_in_mm(units_[axis], header_.path);
    AxisFields fields{unit * spacings_[axis], unit * thicknesses_[axis], unit * mins_[axis],
                      unit * maxs_[axis],     Centering::unknown,        static_cast<double>(size - 1)};
    const std::string centering = centerings_.empty() ? "" : lower_case(centerings_[axis]);
    if (centering == "node") fields.centering = Centering::node;
    if (centering == "cell") fields.centering = Centering::cell;
    return fields;
  }

 private:
  std::vector<double> numbers(const char* key, std::size_t dimension) const {
    return header_.has(key) ? header_.numbers(key, dimension) : std::vector<double>(dimension, not_stated);
  }

  const NrrdHeader& header_;
  std::vector<double> spacings_;
  std::vector<double> thicknesses_;
  std::vector<double> mins_;
  std::vector<double> maxs_;
  std::vector<std::string> units_;
  std::vector<std::string> centerings_;
};

/// From the first sample's place to the last one's there are `last` spacings between nodes; cells have one more between
/// their outer faces.
double spacing_of_extent(const AxisFields& axis, Centering centering) {
  const bool by_nodes = centering == Centering::node && axis.last > 0.0;
  return (axis.max - axis.min) / (by_nodes ? axis.last : axis.last + 1.0);
}

bool nearly_equal(double a, double b) {
  constexpr double rounding = 1e-3;  // of numbers that were written with few digits
  return std::abs(a - b) <= rounding * std::abs(b);
}

/// Completes the spacing and the centering of an axis; notes what is a guess.
void complete_axis(AxisFields& axis, std::size_t index, NrrdHeader& header) {
  const bool has_extent = !std::isnan(axis.min) && !std::isnan(axis.max);
  if (has_extent && !std::isnan(axis.spacing)) {
    const double cell = spacing_of_extent(axis, Centering::cell);
    const double node = spacing_of_extent(axis, Centering::node);
    if (axis.centering == Centering::unknown)
      axis.centering = nearly_equal(axis.spacing, cell) ? Centering::cell : Centering::node;
    if (!nearly_equal(axis.spacing, axis.centering == Centering::cell ? cell : node)) {
      header.note(fmt::format("axis {}: its spacing {} mm does not fit its ends {} and {}; the spacing was taken",
                              index, axis.spacing, axis.min, axis.max));
    }
  } else if (has_extent) {
    if (axis.centering == Centering::unknown) {
      header.note(fmt::format(
          "axis {}: its header does not say whether its samples are nodes or cells; cells were taken", index));
      axis.centering = Centering::cell;
    }
    axis.spacing = spacing_of_extent(axis, axis.centering);
  } else if (std::isnan(axis.spacing) && !std::isnan(axis.thickness)) {
    header.note(
        fmt::format("axis {}: its header has no spacing; its thickness {} mm was taken", index, axis.thickness));
    axis.spacing = axis.thickness;
  } else if (std::isnan(axis.spacing)) {
    header.note(fmt::format("axis {}: its header has no spacing; 1 mm was taken", index));
    axis.spacing = 1.0;
  }
}

/// The place of the first sample, which lies half a spacing behind the beginning of its cell.
double first_sample(const AxisFields& axis) {
  const double half = axis.centering == Centering::cell ? 0.5 * axis.spacing : 0.0;
  if (!std::isnan(axis.min)) return axis.min + half;
  if (!std::isnan(axis.max)) return axis.max - half - axis.last * axis.spacing;
  return 0.0;
}

struct Placement {
  std::vector<Eigen::Vector3d> steps;  ///< of the axes of space
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

Placement placed_by_axes(NrrdHeader& header, const NrrdSpace& space, const std::vector<ArrayAxis>& axes) {
  Placement placement;
  const AxisFieldsReader reader(header, axes.size());
  for (std::size_t n = 0; n < axes.size(); ++n) {
    if (axes[n].kind != AxisKind::space) continue;
    const auto axis = static_cast<Eigen::Index>(placement.steps.size());
    AxisFields fields = reader.read(n, axes[n].size, space.units[axis]);
    complete_axis(fields, n, header);
    placement.steps.push_back(space.flip[axis] * fields.spacing * Eigen::Vector3d::Unit(axis));
    placement.origin[axis] = space.flip[axis] * first_sample(fields);
  }
  if (!space.axes.empty())
    header.note("its header has a space but no space directions; its axes were taken as those of the space");
  return placement;
}

Placement placed_by_directions(const NrrdSpace& space, const std::vector<ArrayAxis>& axes) {
  Placement placement;
  for (std::size_t n = 0; n < axes.size(); ++n) {
    if (axes[n].kind == AxisKind::space) placement.steps.push_back(space.directions[n]->step);
  }
  return placement;
}

}  // namespace

Lattice nrrd_lattice(NrrdHeader& header, const NrrdSpace& space, const std::vector<ArrayAxis>& axes) {
  Placement placement =
      space.directions.empty() ? placed_by_axes(header, space, axes) : placed_by_directions(space, axes);
  if (space.origin) placement.origin = *space.origin;
  if (!space.origin && header.has("spaceorigin")) header.note("its origin is not known; (0, 0, 0) was taken");
  std::array<long long, 3> size{1, 1, 1};
  std::size_t next = 0;
  for (const ArrayAxis& axis : axes) {
    if (axis.kind == AxisKind::space) size[next++] = axis.size;
  }
  Eigen::Matrix3d steps = steps_of_slice(placement.steps[0], placement.steps[1]);
  if (placement.steps.size() == 3)
    steps.col(2) = placement.steps[2];
  else
    header.note(fmt::format("it is one 2-D slice; {:.4g} mm were taken as its thickness", steps.col(2).norm()));
  return make_lattice(header.path, size, steps.colwise().norm(), steps, placement.origin, space.axes);
}

}  // namespace isobench
