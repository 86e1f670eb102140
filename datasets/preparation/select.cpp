// Selecting nodes by their samples: every node becomes 1 or 0.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

template <class T, class Selected>
std::vector<std::uint8_t> selection(const std::vector<T>& samples, Selected selected) {
  std::vector<std::uint8_t> result(samples.size());
  std::transform(samples.begin(), samples.end(), result.begin(),
                 [&](T sample) -> std::uint8_t { return selected(sample) ? 1 : 0; });
  return result;
}

/// sample >= at, exactly. An integer is compared with `at` rounded up, as a double cannot hold all 64-bit integers.
template <class T>
std::vector<std::uint8_t> at_least(const std::vector<T>& samples, double at) {
  if constexpr (std::is_integral_v<T>) {
    const double least = std::ceil(at);
    if (least >= std::ldexp(1.0, std::numeric_limits<T>::digits)) {  // beyond the largest T
      return std::vector<std::uint8_t>(samples.size(), 0);
    }
    const bool all = least < static_cast<double>(std::numeric_limits<T>::min());
    const T limit = all ? std::numeric_limits<T>::min() : static_cast<T>(least);
    return selection(samples, [&](T sample) { return sample >= limit; });
  } else {
    return selection(samples, [&](T sample) { return static_cast<double>(sample) >= at; });
  }
}

/// The labels that a sample of type T can have.
template <class T>
std::vector<T> possible_labels(const std::vector<std::int64_t>& labels) {
  std::vector<T> possible;
  for (const std::int64_t label : labels) {
    if constexpr (std::is_integral_v<T>) {
      if (std::in_range<T>(label)) possible.push_back(static_cast<T>(label));
    } else {
      const T real = static_cast<T>(label);
      // 2^63 is a T, but cannot be a label.
      if (real < std::ldexp(T{1}, 63) && static_cast<std::int64_t>(real) == label) possible.push_back(real);
    }
  }
  return possible;
}

/// Replaces the samples by the selection. Throws DataError with `nothing`, the samples' range and the remedy if it is
/// empty.
void replace(Volume& volume, std::vector<std::uint8_t> selected, const std::string& nothing, const char* remedy) {
  if (std::find(selected.begin(), selected.end(), 1) == selected.end()) {
    throw DataError(fmt::format("{}: the samples lie in {}; {}", nothing, range_text(volume), remedy));
  }
  volume.samples = std::move(selected);
}

}  // namespace

void threshold(Volume& volume, double at) {
  std::vector<std::uint8_t> selected = volume.samples.visit([&](const auto& samples) { return at_least(samples, at); });
  replace(volume, std::move(selected), fmt::format("threshold: no sample reaches {}", at), "choose a smaller value");
}

void select_labels(Volume& volume, const std::vector<std::int64_t>& labels) {
  std::vector<std::uint8_t> selected = volume.samples.visit([&](const auto& samples) {
    using T = SampleOf<decltype(samples)>;
    const std::vector<T> possible = possible_labels<T>(labels);
    return selection(samples,
                     [&](T sample) { return std::find(possible.begin(), possible.end(), sample) != possible.end(); });
  });
  replace(volume, std::move(selected), fmt::format("labels: no sample is one of {}", fmt::join(labels, ", ")),
          "choose labels that the volume has");
}

}  // namespace isobench
