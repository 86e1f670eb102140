#include "isobench/datasets/manifests/file_surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "isobench/foundation/error.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

constexpr double mask_isovalue = 0.5;
constexpr int mask_margin = 4;         // voxels around the labels, so that the surface is closed within the volume
constexpr double thick_slices = 1.5;   // times the least spacing
constexpr double most_nodes = 2.56e8;  // of a volume that nobody has asked for: 1 GiB of floats

void check(const FileSurface& asked) {
  if (asked.labels.empty() && !asked.isovalue) throw UsageError("neither an isovalue nor labels are given; give one");
  if (!asked.labels.empty() && asked.isovalue)
    throw UsageError(
        "an isovalue and labels are given; give one of them: the surface of labels is where their mask is 0.5");
  if (!asked.labels.empty() && asked.inside == Inside::below)
    throw UsageError("labels are the inside; leave out --inside below, or give the other labels");
  if (asked.isovalue && !std::isfinite(*asked.isovalue))
    throw UsageError("the isovalue is not a finite number; give one that is");
  const double smooth = asked.smooth_voxels.value_or(0.0);
  if (!(smooth >= 0.0 && smooth < 1000.0)) {
    throw UsageError(fmt::format("smoothing by {} voxels is not possible; give a number >= 0 and < 1000", smooth));
  }
  if (asked.resample && !(asked.resample->minCoeff() > 0.0 && asked.resample->allFinite()))
    throw UsageError("the spacing to resample at is not > 0 mm; give one that is");
}

void smooth_by(double voxels, std::vector<PrepareStep>& steps) {
  if (voxels > 0.0) steps.emplace_back(Gaussian{Eigen::Vector3d::Constant(voxels)});
}

/// The spacing at which a mask with thick slices is interpolated: the least one, unless that makes too many nodes.
Eigen::Vector3d spacing_for(const Lattice& lattice) {
  double volume = 1.0;
  for (int axis = 0; axis < 3; ++axis) volume *= lattice.spacing[axis] * lattice.size[static_cast<std::size_t>(axis)];
  return Eigen::Vector3d::Constant(std::max(lattice.spacing.minCoeff(), std::cbrt(volume / most_nodes)));
}

std::string key_if(const char* key, bool given, const std::string& value) {
  return given ? fmt::format("{} = {}\n", key, value) : "";
}

/// A string as TOML writes it.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string triple_text(const Eigen::Vector3d& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

/// A step as manifest_steps.cpp reads it; only of steps that steps_of() gives.
std::string toml_of(const PrepareStep& step) {
  if (const auto* labels = std::get_if<SelectLabels>(&step))
    return fmt::format("{{ step = \"labels\", labels = [{}] }}", fmt::join(labels->labels, ", "));
  if (std::holds_alternative<CloseBorder>(step)) return "{ step = \"close-border\" }";
  if (std::holds_alternative<Crop>(step)) return "{ step = \"crop\" }";
  if (const auto* padding = std::get_if<Pad>(&step))
    return fmt::format("{{ step = \"pad\", voxels = {} }}", padding->voxels);
  if (std::holds_alternative<SignedDistance>(step)) return "{ step = \"signed-distance\" }";
  if (const auto* spacing = std::get_if<Resample>(&step))
    return fmt::format("{{ step = \"resample\", spacing = {} }}", triple_text(spacing->spacing));
  if (const auto* threshold = std::get_if<Threshold>(&step))
    return fmt::format("{{ step = \"threshold\", at = {} }}", threshold->at);
  return fmt::format("{{ step = \"gaussian\", sigma = {} }}", std::get<Gaussian>(step).sigma[0]);
}

std::string part_text(const VolumeChoice& part) {
  return key_if("step", part.step.has_value(), fmt::format("{}", part.step.value_or(0))) +
         key_if("component", part.component.has_value(), fmt::format("{}", part.component.value_or(0))) +
         key_if("array", !part.array.empty(), quoted(part.array)) +
         key_if("segment", !part.segment.empty(), quoted(part.segment)) +
         key_if("series", !part.series.empty(), quoted(part.series));
}

}  // namespace

std::vector<PrepareStep> steps_of(const FileSurface& asked, const Lattice& lattice) {
  check(asked);
  std::vector<PrepareStep> steps;
  if (asked.labels.empty()) {
    if (asked.resample) steps.emplace_back(Resample{*asked.resample});
    smooth_by(asked.smooth_voxels.value_or(0.0), steps);
    steps.emplace_back(CloseBorder{*asked.isovalue, asked.inside == Inside::below});
    return steps;
  }
  steps.emplace_back(SelectLabels{asked.labels});
  steps.emplace_back(CloseBorder{mask_isovalue, false});
  steps.emplace_back(Crop{});
  steps.emplace_back(Pad{mask_margin});
  if (asked.resample || lattice.spacing.maxCoeff() >= thick_slices * lattice.spacing.minCoeff()) {
    steps.emplace_back(SignedDistance{});
    steps.emplace_back(Resample{asked.resample.value_or(spacing_for(lattice))});
    // Between two nodes the interpolated distance may be 0 up to rounding. Such a node is not inside.
    steps.emplace_back(Threshold{1e-6});
  }
  smooth_by(asked.smooth_voxels.value_or(label_smoothing), steps);
  return steps;
}

std::string manifest_text(const std::filesystem::path& path, const FileSurface& asked, const Lattice& lattice) {
  std::string text = fmt::format("title = {}\n", quoted(path.filename().string()));
  text += fmt::format("isovalue = {}\n", asked.isovalue.value_or(mask_isovalue));
  text += fmt::format("inside = \"{}\"\n", to_string(asked.inside));
  text += key_if("kernel", asked.kernel != Kernel::bspline, quoted(to_string(asked.kernel)));
  text += key_if("exact-isovalue", asked.choices.exact_isovalue, "true");
  text += key_if("min-component", asked.choices.min_component > 0.0, fmt::format("{}", asked.choices.min_component));
  text += "prepare = [\n";
  for (const PrepareStep& step : steps_of(asked, lattice)) text += "  " + toml_of(step) + ",\n";
  text += "]\n\n[data]\n" + part_text(asked.part);
  const std::string sum = std::filesystem::is_regular_file(path) ? sha256_of_file(path) : "";
  text += fmt::format("files = [ {{ name = {}{} }} ]\n", quoted(path.filename().string()),
                      sum.empty() ? "" : fmt::format(", sha256 = \"{}\"", sum));
  return text;
}

}  // namespace isobench
