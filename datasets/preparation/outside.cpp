// Samples that say nothing: they count as outside the object.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

double value_outside(const Volume& volume, const FillOutside& step) {
  const double sign = step.object_below ? -1.0 : 1.0;
  // Of sign · (sample − c), which is positive inside.
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  volume.samples.visit([&](const auto& samples) {
    for (const auto sample : samples) {
      const double value = sign * (static_cast<double>(sample) - step.isovalue);
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  });
  if (!(least <= most)) throw DataError("no sample of the volume is a finite number; export it again");
  // Where the file holds nothing but the object, its surface lies about half a voxel beyond its outermost nodes.
  const double outside = least > 0.0 ? -0.5 * (least + most) : least;
  return step.isovalue + sign * std::min(outside, -0.1 * (most - least));
}

void fill_outside(Volume& volume, const FillOutside& step, Monitor& monitor) {
  if (is_finite(volume)) return;
  const double value = value_outside(volume, step);
  std::size_t filled = 0;
  volume.samples.visit([&](auto& samples) {
    using T = SampleOf<decltype(samples)>;
    if constexpr (std::is_floating_point_v<T>) {
      const T object_side =
          step.object_below ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity();
      for (T& sample : samples) {
        // One on the object's side stays, so that check_finite() names its node.
        if (std::isfinite(sample) || sample == object_side) continue;
        sample = static_cast<T>(value);
        ++filled;
      }
    }
  });
  check_finite(volume);
  monitor.note(fmt::format("{} of {} samples are no finite numbers; they count as outside the object", filled,
                           volume.samples.size()));
}

}  // namespace isobench
