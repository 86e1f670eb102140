#include "isobench/datasets/formats/nrrd/nrrd_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

/// What a kind says about its axis; nothing for kinds that space may have.
std::optional<AxisKind> axis_of_kind(const std::string& word) {
  const std::string kind = lower_case(word);
  if (kind == "time") return AxisKind::step;
  for (const char* name :
       {"list", "point", "vector", "covariant-vector", "normal", "stub", "scalar", "complex", "quaternion"}) {
    if (kind == name) return AxisKind::component;
  }
  for (const char* ending : {"-color", "-vector", "-gradient", "-normal", "-matrix"}) {
    if (kind.ends_with(ending)) return AxisKind::component;
  }
  return std::nullopt;
}

std::vector<std::size_t> indices_of(const std::vector<ArrayAxis>& axes, AxisKind kind) {
  std::vector<std::size_t> indices;
  for (std::size_t n = 0; n < axes.size(); ++n) {
    if (axes[n].kind == kind) indices.push_back(n);
  }
  return indices;
}

/// An axis that is no space: its kind says what it is, or else its place. Components lie before the axes of space,
/// steps after them.
void name_axis(std::vector<ArrayAxis>& axes, std::size_t axis, const std::vector<std::string>& kinds,
               const std::vector<bool>& is_space) {
  const auto known = kinds.empty() ? std::nullopt : axis_of_kind(kinds[axis]);
  const bool is_last =
      std::find(is_space.begin() + static_cast<std::ptrdiff_t>(axis), is_space.end(), true) == is_space.end();
  axes[axis].kind = known.value_or(is_last ? AxisKind::step : AxisKind::component);
}

/// Without directions: the axes whose kinds do not say otherwise. Of more than three, those without a spacing are no
/// space; then the first, if it has as few places as colours have, or else the last ones.
std::vector<bool> space_by_kinds(NrrdHeader& header, const std::vector<ArrayAxis>& axes,
                                 const std::vector<std::string>& kinds) {
  std::vector<bool> is_space(axes.size(), true);
  for (std::size_t n = 0; n < kinds.size(); ++n) is_space[n] = !axis_of_kind(kinds[n]);
  const auto count = [&] { return std::count(is_space.begin(), is_space.end(), true); };
  if (count() <= 3) return is_space;
  if (header.has("spacings")) {
    std::vector<bool> with_spacing = is_space;
    const std::vector<double> spacings = header.numbers("spacings", axes.size());
    for (std::size_t n = 0; n < axes.size(); ++n) with_spacing[n] = is_space[n] && !std::isnan(spacings[n]);
    const auto left = std::count(with_spacing.begin(), with_spacing.end(), true);
    if (left == 2 || left == 3) return with_spacing;
  }
  constexpr long long most_colours = 4;
  if (count() == 4 && is_space[0] && axes.front().size <= most_colours && axes.back().size > most_colours) {
    is_space[0] = false;
    header.note("its header does not say which of its axes are space; the first was taken as components");
    return is_space;
  }
  for (std::size_t n = axes.size(); count() > 3; --n) is_space[n - 1] = false;
  header.note("its header does not say which of its axes are space; the first three were taken");
  return is_space;
}

std::vector<bool> space_by_directions(const NrrdSpace& space) {
  std::vector<bool> is_space;
  for (const auto& direction : space.directions) is_space.push_back(direction && !direction->is_time);
  return is_space;
}

}  // namespace

std::size_t nrrd_dimension(const NrrdHeader& header) {
  const double dimension = header.number("dimension", 0.0);
  if (dimension >= 1.0 && dimension <= 16.0 && dimension == std::floor(dimension))
    return static_cast<std::size_t>(dimension);
  throw DataError(fmt::format("{}: its dimension is '{}', not a whole number from 1 to 16; correct its header",
                              header.path.string(), header.text("dimension").substr(0, 60)));
}

std::vector<ArrayAxis> nrrd_axes(NrrdHeader& header, const NrrdSpace& space) {
  const std::size_t dimension = nrrd_dimension(header);
  std::vector<ArrayAxis> axes;
  for (const double size : header.numbers("sizes", dimension)) axes.push_back({size_in(size), AxisKind::space});
  const std::vector<std::string> kinds = header.words("kinds", dimension);
  const std::vector<bool> is_space =
      space.directions.empty() ? space_by_kinds(header, axes, kinds) : space_by_directions(space);
  for (std::size_t n = 0; n < dimension; ++n) {
    if (is_space[n]) continue;
    if (!space.directions.empty() && space.directions[n])
      axes[n].kind = AxisKind::step;
    else
      name_axis(axes, n, kinds, is_space);
  }
  const std::size_t count = indices_of(axes, AxisKind::space).size();
  if (count < 2 || count > 3) {
    throw DataError(
        fmt::format("{}: {} of the {} axes of its array {} space, but a volume has three such axes and a slice has "
                    "two; correct its "
                    "header",
                    header.path.string(), count, dimension, count == 1 ? "is" : "are"));
  }
  // A list of vectors: the list is chosen as steps are.
  std::vector<std::size_t> components = indices_of(axes, AxisKind::component);
  components.erase(
      std::remove_if(components.begin(), components.end(), [&](std::size_t n) { return axes[n].size == 1; }),
      components.end());
  if (components.size() == 2 && indices_of(axes, AxisKind::step).empty()) {
    axes[components.back()].kind = AxisKind::step;
    header.note(fmt::format("axis {} of its array is chosen with --step", components.back()));
  }
  return axes;
}

}  // namespace isobench
