#include "isobench/datasets/formats/reading/axis_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// The number of places on the one axis of this kind that has several; 1 if none has.
std::size_t places_of_kind(std::span<const ArrayAxis> axes, AxisKind kind, const std::filesystem::path& path) {
  std::size_t places = 1;
  for (const ArrayAxis& axis : axes) {
    if (axis.kind != kind || axis.size == 1) continue;
    if (places > 1) {
      throw DataError(fmt::format("{}: it has two axes of {}s, of {} and {} places; export a part with one of them",
                                  path.string(), kind == AxisKind::step ? "step" : "component", places, axis.size));
    }
    places = static_cast<std::size_t>(axis.size);
  }
  return places;
}

void check_array_size(std::span<const ArrayAxis> axes, const std::filesystem::path& path) {
  constexpr long long limit = 1LL << 40;  // as in make_lattice()
  long long samples = 1;
  for (const ArrayAxis& axis : axes) {
    if (axis.size < 1 || samples > limit / axis.size) {
      std::string sizes;
      for (const ArrayAxis& each : axes) sizes += fmt::format("{}{}", sizes.empty() ? "" : " × ", each.size);
      throw DataError(
          fmt::format("{}: its size {} is not that of a volume; the header is damaged, copy or export it again",
                      path.string(), sizes));
    }
    samples *= axis.size;
  }
}

/// A choice of the other kind than the file has is an easy mistake.
void check_kind(const std::optional<std::size_t>& choice, std::size_t places, std::size_t other_places,
                const char* what, const char* other, const std::filesystem::path& path) {
  if (!choice || places > 1 || other_places == 1) return;
  throw DataError(fmt::format("{}: it has no {}s but {} {}s; choose one with --{} 0 to {}", path.string(), what,
                              other_places, other, other, other_places - 1));
}

}  // namespace

std::vector<FileAxis> choose_places(std::span<const ArrayAxis> axes, const VolumeChoice& choice,
                                    const std::filesystem::path& path) {
  check_array_size(axes, path);
  const std::size_t steps = places_of_kind(axes, AxisKind::step, path);
  const std::size_t components = places_of_kind(axes, AxisKind::component, path);
  check_kind(choice.step, steps, choice.component ? 1 : components, "step", "component", path);
  check_kind(choice.component, components, choice.step ? 1 : steps, "component", "step", path);
  const std::size_t step = place_on_axis(choice.step, steps, "step", path);
  const std::size_t component = place_on_axis(choice.component, components, "component", path);
  std::vector<FileAxis> places;
  for (const ArrayAxis& axis : axes) {
    FileAxis place{static_cast<std::size_t>(axis.size), {}};
    if (axis.kind == AxisKind::step) place.chosen = axis.size == 1 ? 0 : step;
    if (axis.kind == AxisKind::component) place.chosen = axis.size == 1 ? 0 : component;
    places.push_back(place);
  }
  return places;
}

}  // namespace isobench
