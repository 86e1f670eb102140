#include "isobench/datasets/formats/nrrd/nrrd_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

struct NamedSpace {
  const char* name;
  const char* short_name;
  const char* axes;
  std::size_t dimension;
};

constexpr NamedSpace named_spaces[] = {
    {"right-anterior-superior", "ras", "RAS", 3},
    {"left-anterior-superior", "las", "LAS", 3},
    {"left-posterior-superior", "lps", "LPS", 3},
    {"right-anterior-superior-time", "rast", "RAS", 4},
    {"left-anterior-superior-time", "last", "LAS", 4},
    {"left-posterior-superior-time", "lpst", "LPS", 4},
    {"scanner-xyz", "scannerxyz", "", 3},
    {"scanner-xyz-time", "scannerxyztime", "", 4},
    {"3d-right-handed", "3dright", "", 3},
    {"3d-left-handed", "3dleft", "left", 3},
    {"3d-right-handed-time", "3drighttime", "", 4},
    {"3d-left-handed-time", "3dlefttime", "left", 4},
};

/// Sets the world's axes and the dimension of the space.
void name_space(NrrdHeader& header, NrrdSpace& space) {
  const double stated = header.number("spacedimension", 0.0);
  if (header.has("spacedimension")) {
    if (!(stated >= 1.0 && stated <= 16.0 && stated == std::floor(stated))) {
      throw DataError(
          fmt::format("{}: its space dimension is '{}', not a whole number from 1 to 16; correct its header",
                      header.path.string(), header.text("spacedimension")));
    }
    space.dimension = static_cast<std::size_t>(stated);
  }
  const std::string name = lower_case(header.text("space"));
  if (name.empty()) return;
  for (const NamedSpace& named : named_spaces) {
    if (name != named.name && name != named.short_name) continue;
    space.dimension = named.dimension;
    const std::string axes = named.axes;
    if (axes == "left") {
      header.note(
          "its space is left-handed; its coordinates were taken as they are, so most viewers show a mirror image");
      return;
    }
    space.axes = axes == "LAS" ? "RAS" : axes;
    if (axes == "LAS") space.flip.x() = -1.0;
    return;
  }
  header.note(fmt::format("its space '{}' is none of the format's; its coordinates were taken as they are",
                          name.substr(0, 60)));
}

/// The vectors of a field; an empty one for "none".
std::vector<std::vector<double>> vectors_of(const NrrdHeader& header, const std::string& key) {
  const std::string text = header.text(key);
  std::vector<std::vector<double>> vectors;
  for (std::size_t at = text.find_first_not_of(" \t"); at < text.size(); at = text.find_first_not_of(" \t", at)) {
    const std::size_t end =
        text[at] == '(' ? text.find(')', at) : std::min(text.find_first_of(" \t(", at), text.size());
    const std::string word = text.substr(at, end - at);
    if (end == std::string::npos || (text[at] != '(' && lower_case(word) != "none" && word != "???" && word != "nan")) {
      throw DataError(fmt::format("{}: '{}' is '{}', but vectors such as (1,0,0) are expected; correct its header",
                                  header.path.string(), key, text.substr(0, 60)));
    }
    vectors.emplace_back();
    if (text[at] == '(') vectors.back() = all_numbers_in(word, header.path, key);
    at = text[at] == '(' ? end + 1 : end;
  }
  return vectors;
}

/// How many mm the units of the space's axes have. Some programs write `units`, which belongs to `spacings`, instead.
Eigen::Vector3d space_units(NrrdHeader& header, const NrrdSpace& space, std::size_t dimension) {
  Eigen::Vector3d units = Eigen::Vector3d::Ones();
  const std::vector<std::string> names = header.words("spaceunits", space.dimension);
  for (std::size_t axis = 0; axis < std::min<std::size_t>(names.size(), 3); ++axis)
    units[static_cast<Eigen::Index>(axis)] = unit_in_mm(names[axis], header.path);
  if (header.has("spaceunits") || !header.has("units") || !header.has("spacedirections")) return units;
  std::string only;
  const std::vector<std::string> array_units = header.words("units", dimension);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const std::string& unit = array_units[axis];
    if (!space.directions[axis] || space.directions[axis]->is_time || unit.empty() || unit == only) continue;
    if (!only.empty()) {
      throw DataError(header.path.string() +
                      ": its axes have different units; write them as 'space units', one for each axis of its space");
    }
    only = unit;
  }
  if (only.empty()) return units;
  header.note(fmt::format("its unit '{}' was taken as that of its space directions, too", only.substr(0, 60)));
  return units * unit_in_mm(only, header.path);
}

/// A vector of the file as one of three dimensions.
Eigen::Vector3d in_three_dimensions(const std::vector<double>& vector) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < std::min<std::size_t>(vector.size(), 3); ++n)
    result[static_cast<Eigen::Index>(n)] = vector[n];
  return result;
}

std::optional<NrrdSpace::Direction> direction_of(const NrrdHeader& header, const NrrdSpace& space,
                                                 const std::vector<double>& vector) {
  const auto unknown = [](double number) { return std::isnan(number); };
  if (vector.empty() || std::all_of(vector.begin(), vector.end(), unknown)) return std::nullopt;
  if (vector.size() != space.dimension) {
    throw DataError(
        fmt::format("{}: a space direction has {} numbers, but its space has {} dimensions; correct its header",
                    header.path.string(), vector.size(), space.dimension));
  }
  NrrdSpace::Direction direction{in_three_dimensions(vector), false};
  const bool moves_in_time =
      vector.size() > 3 && std::any_of(vector.begin() + 3, vector.end(), [](double number) { return number != 0.0; });
  if (!moves_in_time) return direction;
  if (!direction.step.isZero()) {
    throw DataError(header.path.string() + ": an axis moves both in space and in time; correct its space directions");
  }
  direction.is_time = true;
  return direction;
}

}  // namespace

NrrdSpace nrrd_space(NrrdHeader& header, std::size_t dimension) {
  NrrdSpace space;
  name_space(header, space);
  const std::vector<std::vector<double>> directions = vectors_of(header, "spacedirections");
  if (header.has("spacedirections") && directions.size() != dimension) {
    throw DataError(fmt::format("{}: it has {} space directions for its {} axes; correct its header",
                                header.path.string(), directions.size(), dimension));
  }
  const std::vector<std::vector<double>> origins = vectors_of(header, "spaceorigin");
  for (const auto* vectors : {&directions, &origins}) {
    for (const std::vector<double>& vector : *vectors) {
      if (space.dimension == 0) space.dimension = vector.size();
    }
  }
  for (const std::vector<double>& vector : directions) space.directions.push_back(direction_of(header, space, vector));
  space.units = space_units(header, space, dimension);
  const Eigen::Vector3d factor = space.flip.cwiseProduct(space.units);
  for (auto& direction : space.directions) {
    if (direction) direction->step = factor.cwiseProduct(direction->step);
  }
  if (!header.has("spaceorigin")) return space;
  if (origins.size() != 1 || (!origins[0].empty() && origins[0].size() != space.dimension)) {
    throw DataError(fmt::format("{}: its space origin '{}' is not one point of its space; correct its header",
                                header.path.string(), header.text("spaceorigin").substr(0, 60)));
  }
  const Eigen::Vector3d origin = in_three_dimensions(origins[0]);
  if (!origins[0].empty() && !origin.hasNaN()) space.origin = factor.cwiseProduct(origin);
  return space;
}

}  // namespace isobench
