#include "isobench/datasets/preparation/prepare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
// C++20 needs no such guide, but clang before version 17 does.
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

std::string triple(const Eigen::Vector3d& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

// Gives the volume to `change` as floats, or as doubles if floats would round samples: labels of thirty bits, or values
// on a large pedestal.
template <class Change>
void compute(Volume& volume, const Change& change) {
  if (needs_double(volume))
    volume = change(as_real<double>(std::move(volume)));
  else
    volume = change(as_real<float>(std::move(volume)));
}

void apply(Volume& volume, const PrepareStep& step, Monitor& monitor) {
  std::visit(
      Overloaded{
          [&](const Threshold& s) { threshold(volume, s.at); },
          [&](const SelectLabels& s) { select_labels(volume, s.labels); },
          [&](const LargestComponent&) { keep_largest_component(volume); },
          [&](const Crop& s) { crop(volume, s.margin); },
          [&](const Pad& s) { pad(volume, s.voxels, s.value); },
          [&](const Resample& s) { compute(volume, [&](const auto& reals) { return resample(reals, s.spacing); }); },
          [&](const SignedDistance&) { volume = signed_distance(std::move(volume), monitor); },
          [&](const Gaussian& s) {
            compute(volume, [&](auto reals) {
              gaussian(reals, s.sigma, monitor);
              return reals;
            });
          },
          [&](const CloseBorder& s) { close_border(volume, s, monitor); },
          [&](const Subsample& s) { compute(volume, [&](const auto& reals) { return subsample(reals, s.factor); }); },
          [&](const Cut& s) { cut(volume, s); },
          [&](const FillOutside& s) { fill_outside(volume, s, monitor); },
          [&](const Rectangular& s) {
            const double outside = value_outside(volume, {s.isovalue, s.object_below});
            compute(volume, [&](const auto& reals) { return rectangular(reals, outside, monitor); });
          },
      },
      step);
}

const char* name_of(const PrepareStep& step) {
  static constexpr const char* names[] = {
      "threshold", "labels",       "largest-component", "crop", "pad",          "resample",   "signed-distance",
      "gaussian",  "close-border", "subsample",         "cut",  "fill-outside", "rectangular"};
  static_assert(std::size(names) == std::variant_size_v<PrepareStep>);
  return names[step.index()];
}

}  // namespace

std::string describe(const PrepareStep& step) {
  const std::string name = name_of(step);
  return std::visit(
      Overloaded{
          [&](const Threshold& s) { return fmt::format("{} >= {}", name, s.at); },
          [&](const SelectLabels& s) { return fmt::format("{} {{{}}}", name, fmt::join(s.labels, ", ")); },
          [&](const LargestComponent&) { return name + ", 26-connected"; },
          [&](const Crop& s) { return fmt::format("{} to the object and {} voxels around it", name, s.margin); },
          [&](const Pad& s) { return fmt::format("{} {} voxels of {}", name, s.voxels, s.value); },
          [&](const Resample& s) { return fmt::format("{} to {} mm, linear", name, triple(s.spacing)); },
          [&](const SignedDistance&) { return name + " in mm, positive inside"; },
          [&](const Gaussian& s) { return fmt::format("{} sigma = {} voxels", name, triple(s.sigma)); },
          [&](const CloseBorder& s) {
            return fmt::format("{}: layers added where the object, {} {}, reaches the border", name,
                               s.object_below ? "below" : "above", s.isovalue);
          },
          [&](const Subsample& s) { return fmt::format("{} by {}", name, s.factor); },
          [&](const Cut& s) {
            return fmt::format("{} {} nodes from node ({})", name, fmt::join(s.size, " × "), fmt::join(s.from, ", "));
          },
          [&](const FillOutside&) { return name + ": samples that are not finite"; },
          [&](const Rectangular&) { return name + ": sampled on perpendicular axes, linear"; },
      },
      step);
}

Volume prepare(Volume volume, const std::vector<PrepareStep>& steps, Monitor& monitor) {
  const auto stage = monitor.stage("prepare");
  for (const PrepareStep& step : steps) {
    const auto step_stage = monitor.stage(name_of(step));
    monitor.check();
    apply(volume, step, monitor);
  }
  return volume;
}

}  // namespace isobench
