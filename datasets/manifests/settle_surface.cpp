#include "isobench/datasets/manifests/settle_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "isobench/datasets/topology/component_volumes.h"
#include "isobench/datasets/topology/regular_value.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// A new isovalue should leave room for triangles; the sizing's floor is half a voxel unless something else is asked.
constexpr double narrowest_place = 0.5;  // voxels

std::pair<double, double> range_at_nodes(const Isosurface& surface) {
  std::vector<float> slab;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (int k = 0; k < surface.lattice().size[2]; ++k) {
    surface.node_values(k, slab);
    const auto [least, most] = std::minmax_element(slab.begin(), slab.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const double sign = surface.inside() == Inside::above ? 1.0 : -1.0;
  const double first = surface.isovalue() + sign * low;
  const double second = surface.isovalue() + sign * high;
  return {std::min(first, second), std::max(first, second)};
}

[[noreturn]] void refuse_without_surface(const Isosurface& surface) {
  const auto [least, most] = range_at_nodes(surface);
  const std::string remedy =
      surface.kernel() == Kernel::bspline
          ? " (the spline smooths: single voxels and thin sheets reach only a part of their sample's value)"
          : "";
  throw DataError(fmt::format(
      "no surface: the smooth function F reconstructed from the samples stays within {:.6g} to {:.6g} at the nodes and "
      "never crosses isovalue {}{}; choose one between them",
      least, most, surface.isovalue(), remedy));
}

/// For example " in 15 cells, near (7.98, 7.98, 11) mm for example"; "" where rounding hides the places.
std::string places_text(const Isosurface& surface, const std::vector<CellBox>& places) {
  if (places.empty()) return "";
  const CellBox& first = places[places.size() / 2];
  const Eigen::Vector3d at = surface.lattice().to_world(0.5 * (first.low + first.high));
  return fmt::format(" in {} cell{}, near ({:.4g}, {:.4g}, {:.4g}) mm{}", places.size(), places.size() == 1 ? "" : "s",
                     at[0], at[1], at[2], places.size() == 1 ? "" : " for example");
}

void move(Dataset& dataset, const RegularValue& regular, Monitor& monitor) {
  Isosurface& surface = *dataset.surface;
  const double asked = surface.isovalue();
  const double sign = surface.inside() == Inside::above ? 1.0 : -1.0;
  surface.move_isovalue(asked + sign * regular.value);
  dataset.asked_isovalue = asked;
  monitor.note(fmt::format("{}: F = {} touches itself or fills space{}; F = {:.10g} is taken instead{}", dataset.title,
                           asked, places_text(surface, regular.singular), surface.isovalue(),
                           regular.passes_others ? ", whose topology differs at other places, too" : ""));
}

void leave_out(Dataset& dataset, double least, CertifiedTopology& topology, Monitor& monitor) {
  const std::size_t count = leave_out_below(least, component_volumes(*dataset.surface, topology), topology);
  if (count == topology.components.size()) {
    throw DataError(
        fmt::format("each of the {} components of F = {} encloses less than {} mm³ and would be left out; "
                    "choose a smaller min_component",
                    count, dataset.surface->isovalue(), least));
  }
  dataset.preparation.push_back(fmt::format("components below {} mm³ left out: {}", least, count));
  monitor.note(fmt::format("{}: {} of {} components of F = c enclose less than {} mm³ and are left out", dataset.title,
                           count, topology.components.size(), least));
}

void record_small_boxes(const CertifiedTopology& topology, Monitor& monitor) {
  if (!monitor.keeps_artefacts()) return;
  Artefact boxes;
  topology.boxes->for_each([&boxes](const SurfaceBox& box) {
    if (box.depth == 0) return;
    boxes.points.emplace_back(0.5 * (box.box.low + box.box.high));
    boxes.data["size"].push_back((box.box.high - box.box.low).maxCoeff());
    boxes.data["depth"].push_back(box.depth);
    boxes.data["component"].push_back(box.component);
  });
  monitor.artefact("topology", std::move(boxes));
}

}  // namespace

void settle_surface(Dataset& dataset, const SurfaceChoices& choices, Monitor& monitor) {
  const auto stage = monitor.stage("topology");
  RegularValue regular = find_regular_value(*dataset.surface, narrowest_place, monitor);
  if (regular.value != 0.0) {
    if (choices.exact_isovalue) {
      throw DataError(
          fmt::format("isovalue {} is no regular value of F: F = c touches itself or fills space{}; "
                      "choose another isovalue, or let the nearest one that gives a surface be taken",
                      dataset.surface->isovalue(), places_text(*dataset.surface, regular.singular)));
    }
    move(dataset, regular, monitor);
    // The samples as floats are rounded differently at the new isovalue, so the proof is made for them.
    regular.topology = certified_topology(*dataset.surface, monitor);
    if (!regular.topology.is_regular)
      throw DataError("no isovalue near the one asked for gives a surface; choose another, or smooth the volume");
  }
  if (regular.topology.is_open) {
    throw DataError(
        "the surface leaves the volume, and surfaces with a border are not meshed; add the step close-border to the "
        "manifest");
  }
  if (regular.topology.components.empty()) refuse_without_surface(*dataset.surface);
  if (choices.min_component > 0.0) leave_out(dataset, choices.min_component, regular.topology, monitor);
  record_small_boxes(regular.topology, monitor);
  dataset.topology = std::make_shared<const CertifiedTopology>(std::move(regular.topology));
}

}  // namespace isobench
