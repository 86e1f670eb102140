#include "isobench/methods/particles/sampling/component_seeds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

constexpr std::size_t least_seeds = 12;         // the vertices of an icosahedron
constexpr double spacing_of_width = 2.0 / 3.0;  // a sphere then has about 33 particles

/// The size and the place of a component, from points on it.
struct Extent {
  Vector3d middle = Vector3d::Zero();
  double radius = 0.0;      // of a sphere around the middle that contains the points
  double half_width = 0.0;  // along the axis along which the points extend least
};

Extent extent_of(const std::vector<Vector3d>& points) {
  Extent extent;
  for (const Vector3d& x : points) extent.middle += x / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& x : points) {
    const Vector3d from = x - extent.middle;
    spread += from * from.transpose();
    extent.radius = std::max(extent.radius, from.norm());
  }
  const Vector3d thin = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  double least = 0.0;
  double most = 0.0;
  for (const Vector3d& x : points) {
    const double along = thin.dot(x - extent.middle);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  extent.half_width = 0.5 * (most - least);
  return extent;
}

/// The h that gives a component its seeds. A wide thin one would get very many if they were as close as it is thin: it
/// gets some thousands, and the cure adds what is missing at its rim.
double h_for_seeds(const Extent& extent, double area, double contraction) {
  constexpr double most_seeds = 2000.0;
  const double least = std::sqrt(2.0 / std::sqrt(3.0) * area / most_seeds);
  return std::max(spacing_of_width * extent.half_width, least) * contraction;
}

/// About the area of each component, mm²: a disc in a box is about as large as a side of the box.
std::vector<double> areas_of(const CertifiedTopology& topology) {
  std::vector<double> areas(topology.components.size(), 0.0);
  topology.boxes->for_each([&areas](const SurfaceBox& box) {
    areas[box.component] += std::pow((box.box.high - box.box.low).prod(), 2.0 / 3.0);
  });
  return areas;
}

/// Adds points to the seeds, as long as each keeps 0.75 times the spacing from those before. A point on a sheet that
/// faces the other way does not count.
void add_spaced(const std::vector<Vector3d>& points, const std::vector<Vector3d>& standing, const SizedSurface& sized,
                std::vector<Vector3d>& seeds) {
  constexpr double share_of_spacing = 0.75;
  const auto normal_at = [&](const Vector3d& x) { return outward_normal(sized.surface().value_gradient(x).gradient); };
  std::vector<std::pair<Vector3d, Vector3d>> placed;
  for (const Vector3d& x : standing) placed.emplace_back(x, normal_at(x));
  for (const Vector3d& x : points) {
    const double reach = share_of_spacing * sized.spacing(x);
    const Vector3d normal = normal_at(x);
    const bool has_room = std::none_of(placed.begin(), placed.end(), [&](const auto& other) {
      return (other.first - x).squaredNorm() < reach * reach && other.second.dot(normal) > 0.0;
    });
    if (!has_room) continue;
    placed.emplace_back(x, normal);
    seeds.push_back(x);
  }
}

}  // namespace

std::vector<std::uint32_t> components_at(const CertifiedTopology& topology, const std::vector<Vector3d>& points) {
  std::vector<std::uint32_t> result(points.size(), 0);
  if (topology.components.size() < 2) return result;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n)
      result[n] = topology.boxes->component_at(points[n]).value_or(0);
  });
  return result;
}

std::vector<std::vector<Vector3d>> points_on_components(const Isosurface& surface, const CertifiedTopology& topology,
                                                        const std::vector<char>& chosen) {
  std::vector<std::vector<CellBox>> boxes(chosen.size());
  topology.boxes->for_each([&](const SurfaceBox& box) {
    if (chosen[box.component] != 0) boxes[box.component].push_back(box.box);
  });
  std::vector<std::uint32_t> components;
  for (std::uint32_t c = 0; c < chosen.size(); ++c) {
    if (chosen[c] != 0) components.push_back(c);
  }
  std::vector<std::vector<Vector3d>> points(components.size());
  tbb::parallel_for(std::size_t{0}, components.size(), [&](std::size_t n) {
    for (const CellBox& box : boxes[components[n]]) {
      // From the middles of the box's eighths, so that boxes of one size give points at half their distance.
      for (unsigned eighth = 0; eighth < 8; ++eighth) {
        Vector3d x = 0.75 * box.low + 0.25 * box.high;
        for (unsigned axis = 0; axis < 3; ++axis) {
          if ((eighth >> axis & 1U) != 0) x[axis] = 0.25 * box.low[axis] + 0.75 * box.high[axis];
        }
        const auto foot = surface.project(x);
        if (foot && topology.boxes->component_at(*foot) == components[n]) points[n].push_back(*foot);
      }
    }
  });
  return points;
}

std::size_t add_component_seeds(const CertifiedTopology& topology, SizedSurface& sized, std::vector<Vector3d>& seeds) {
  const std::size_t components = topology.components.size();
  std::vector<std::vector<std::uint32_t>> of_component(components);
  const std::vector<std::uint32_t> component = components_at(topology, seeds);
  for (std::uint32_t n = 0; n < seeds.size(); ++n) of_component[component[n]].push_back(n);
  std::vector<char> lacks(components, 0);
  std::vector<std::uint32_t> lacking;
  for (std::uint32_t c = 0; c < components; ++c) {
    if (of_component[c].size() >= least_seeds || topology.components[c].is_left_out) continue;
    lacks[c] = 1;
    lacking.push_back(c);
  }
  if (lacking.empty()) return 0;
  const std::vector<std::vector<Vector3d>> points = points_on_components(sized.surface(), topology, lacks);
  const std::vector<double> areas = areas_of(topology);
  std::vector<SizeBound> bounds;
  for (std::size_t n = 0; n < lacking.size(); ++n) {
    if (points[n].empty()) continue;
    const Extent extent = extent_of(points[n]);
    const double h = h_for_seeds(extent, areas[lacking[n]], sized.contraction());
    bounds.push_back({extent.middle, h, extent.radius, h});
  }
  sized.add_bounds(bounds);
  for (std::size_t n = 0; n < lacking.size(); ++n) {
    std::vector<Vector3d> standing;
    for (const std::uint32_t s : of_component[lacking[n]]) standing.push_back(seeds[s]);
    add_spaced(points[n], standing, sized, seeds);
  }
  return lacking.size();
}

}  // namespace isobench::particles
