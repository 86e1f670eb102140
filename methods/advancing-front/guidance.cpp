#include "isobench/methods/advancing-front/guidance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/foundation/random.h"
#include "isobench/methods/sizing/band.h"
#include "isobench/methods/sizing/limit.h"

namespace isobench::advancing_front {

namespace {

constexpr int parts = 4;

/// The steps that the samples of one cell allow at its corners.
struct CellSteps {
  std::array<std::int32_t, 8> corner{};
  std::array<float, 8> step{};
  bool crossed = false;
};

class Sampler {
 public:
  Sampler(const Isosurface& surface, const Band& band, const GuidanceOptions& options, double largest)
      : surface_(surface), band_(band), options_(options), largest_(largest) {}

  /// The steps of the cell whose lowest corner is node n.
  CellSteps operator()(std::size_t n, const std::vector<char>& inside) const {
    CellSteps cell;
    const auto& [i, j, k] = band_.node(n);
    int inside_corners = 0;
    for (int c = 0; c < 8; ++c) {
      const std::int32_t corner = band_.find(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
      if (corner < 0) return cell;
      cell.corner[static_cast<std::size_t>(c)] = corner;
      inside_corners += inside[static_cast<std::size_t>(corner)];
    }
    if (inside_corners == 0 || inside_corners == 8) return cell;
    cell.crossed = true;
    cell.step.fill(static_cast<float>(largest_));
    for (int part = 0; part < parts * parts * parts; ++part) {
      if (const auto x = sample(n, part)) lower(cell, *x);
    }
    return cell;
  }

 private:
  std::optional<Eigen::Vector3d> sample(std::size_t n, int part) const {
    const Eigen::Vector3i at(part % parts, part / parts % parts, part / (parts * parts));
    Eigen::Vector3d x = band_.position(n);
    for (int axis = 0; axis < 3; ++axis) {
      const double jitter =
          uniform_random(options_.seed, n, 3 * static_cast<std::uint64_t>(part) + static_cast<std::uint64_t>(axis));
      x[axis] += band_.spacing()[axis] * (at[axis] + jitter) / parts;
    }
    // Parts far from the surface would project to points that nearer parts sample anyway.
    const Jet jet = surface_.value_gradient(x);
    if (!(std::abs(jet.value) < jet.gradient.norm() * band_.spacing().norm() / parts)) return std::nullopt;
    return surface_.project(x);
  }

  void lower(CellSteps& cell, const Eigen::Vector3d& x) const {
    const double bend = std::min(curvatures(surface_.jet(x)).max_abs(), 2.0 / surface_.voxel());
    const double length = options_.eta * 2.0 * std::sin(0.5 * options_.rho) / std::max(bend, 1e-12 / largest_);
    for (std::size_t c = 0; c < 8; ++c) {
      const double away = (band_.position(static_cast<std::size_t>(cell.corner[c])) - x).norm();
      const double step = std::max(options_.floor, length) + (1.0 - options_.eta) * away;
      cell.step[c] = std::min(cell.step[c], static_cast<float>(step));
    }
  }

  const Isosurface& surface_;
  const Band& band_;
  const GuidanceOptions& options_;
  double largest_;
};

template <typename Visit>
void for_each_node(const Band& band, const Monitor& monitor, const Visit& visit) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, band.size(), 1024), [&](const auto& range) {
    monitor.check();
    for (std::size_t n = range.begin(); n < range.end(); ++n) visit(n);
  });
}

}  // namespace

SizingField guidance_field(const Isosurface& surface, const GuidanceOptions& options, Monitor& monitor) {
  const auto stage = monitor.stage("guidance");
  const auto band = std::make_shared<const Band>(surface, 2);
  const double largest = 0.25 * surface.extent().minCoeff();
  std::vector<char> inside(band->size());
  for_each_node(*band, monitor, [&](std::size_t n) { inside[n] = surface.value(band->position(n)) > 0.0 ? 1 : 0; });
  const Sampler sampler(surface, *band, options, largest);
  std::vector<CellSteps> cells(band->size());
  for_each_node(*band, monitor, [&](std::size_t n) { cells[n] = sampler(n, inside); });

  std::vector<float> least(band->size(), static_cast<float>(largest));
  for (const CellSteps& cell : cells) {
    if (!cell.crossed) continue;
    for (std::size_t c = 0; c < 8; ++c) {
      float& at = least[static_cast<std::size_t>(cell.corner[c])];
      at = std::min(at, cell.step[c]);
    }
  }
  std::vector<float> steps = limit_gradient(*band, least, 1.0 - options.eta, monitor);
  return {band, std::move(least), std::move(steps), options.floor};
}

}  // namespace isobench::advancing_front
