#include "isobench/datasets/preparation/needed_steps.h"

#include <algorithm>
#include <utility>

namespace isobench {

namespace {

template <class... Steps>
bool is_one_of(const PrepareStep& step) {
  return (std::holds_alternative<Steps>(step) || ...);
}

/// The surface's isovalue means nothing before a step after which samples mean something else.
FillOutside outside_before(std::vector<PrepareStep>::const_iterator step, std::vector<PrepareStep>::const_iterator end,
                           double isovalue, bool object_below) {
  for (; step != end; ++step) {
    if (const auto* threshold = std::get_if<Threshold>(&*step)) return {threshold->at, false};
    if (is_one_of<SelectLabels, SignedDistance>(*step)) return {0.5, false};
  }
  return {isovalue, object_below};
}

}  // namespace

std::vector<PrepareStep> with_needed_steps(std::vector<PrepareStep> steps, const Volume& volume, double isovalue,
                                           bool object_below) {
  if (!volume.lattice.is_rectangular()) {
    const auto at =
        std::find_if(steps.begin(), steps.end(), is_one_of<Resample, SignedDistance, Gaussian, CloseBorder, Subsample>);
    const FillOutside outside = outside_before(at, steps.end(), isovalue, object_below);
    steps.insert(at, Rectangular{outside.isovalue, outside.object_below});
  }
  if (!is_finite(volume)) {
    const auto at = std::find_if(
        steps.begin(), steps.end(),
        is_one_of<Threshold, SelectLabels, Resample, SignedDistance, Gaussian, CloseBorder, Subsample, Rectangular>);
    const bool selects = at != steps.end() && is_one_of<Threshold, SelectLabels, SignedDistance>(*at);
    if (!selects) steps.insert(at, outside_before(at, steps.end(), isovalue, object_below));
  }
  return steps;
}

}  // namespace isobench
