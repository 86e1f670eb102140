#include "isobench/experiments/runner/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/topology/surface_boxes.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/processes/available_memory.h"

namespace isobench {

namespace {

/// The mean area of a plane's part in a box, over all planes that meet it: its volume by its mean width (Cauchy).
double mean_section(const CellBox& box) {
  const Eigen::Vector3d size = box.high - box.low;
  return size.prod() / (0.5 * size.sum());
}

/// With an adaptive sizing, some methods place vertices closer than h.
double contraction_of(const MeshingTask& task) {
  const auto found = task.parameters.all().find("contraction");
  return task.sizing.uniform() || found == task.parameters.all().end() ? 1.0 : task.parameters.number("contraction");
}

/// Two digits of a number, as "640", "49,000" or "210 million".
std::string rough(double number) {
  if (number >= 1e6) return rough(number / 1e6) + " million";
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(number, 1.0))) - 1.0));
  const auto whole = std::llround(std::round(number / unit) * unit);
  return whole < 1000 ? fmt::format("{}", whole) : fmt::format("{},{:03}", whole / 1000, whole % 1000);
}

/// A number of bytes as "90 MB" or "2.5 GB".
std::string bytes_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

/// A number of seconds as "3.5 s", "12 minutes" or "4.5 hours".
std::string duration_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} minutes", seconds / 60.0);
  return fmt::format("{:.1f} hours", seconds / 3600.0);
}

}  // namespace

Estimate estimate(const MeshingTask& task, const Method& method, const SizingField& field, Monitor& monitor) {
  Estimate result;
  if (task.sizing.vertices) {
    result.vertices = *task.sizing.vertices;
  } else {
    const double contraction = contraction_of(task);
    task.topology(monitor).boxes->for_each([&](const SurfaceBox& box) {
      const double spacing = field.h(0.5 * (box.box.low + box.box.high)) / contraction;
      result.vertices += 2.0 / std::sqrt(3.0) * mean_section(box.box) / (spacing * spacing);
    });
  }
  if (method.microseconds_per_vertex > 0.0) result.seconds = 1e-6 * method.microseconds_per_vertex * result.vertices;
  result.bytes = method.bytes_per_vertex * result.vertices;
  return result;
}

std::string to_string(const Estimate& estimate) {
  std::string text = "about " + rough(estimate.vertices) + " vertices";
  if (estimate.seconds) text += ", " + duration_text(*estimate.seconds) + " on two cores";
  return text + ", " + bytes_text(estimate.bytes);
}

void refuse_if_too_large(const Estimate& estimate, const MeshingTask& task, std::optional<double> most) {
  const double voxel = task.surface.voxel();
  const std::string remedy = fmt::format(
      "ask for longer edges (voxels are {:.3g} mm, so lengths may be in another unit than you think), or for a number "
      "of vertices",
      voxel);
  if (most && estimate.vertices > *most) {
    throw UsageError(fmt::format("this sizing asks for {}, more than --max-vertices {:.0f}; {}", to_string(estimate),
                                 *most, remedy));
  }
  const double available = available_memory();
  if (estimate.bytes > available) {
    throw UsageError(fmt::format("this sizing asks for {}, and {} of memory are free; {}", to_string(estimate),
                                 bytes_text(available), remedy));
  }
}

}  // namespace isobench
