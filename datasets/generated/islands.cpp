#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "isobench/datasets/generated/generators.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/random.h"

namespace isobench {

namespace {

constexpr std::uint64_t places_tried = 200;  // of each island

/// Random numbers of one island: the n-th try has numbers of its own, whatever the others need.
class IslandNumbers {
 public:
  IslandNumbers(std::uint64_t seed, std::size_t island) : seed_(seed), stream_(2 + island) {}
  double uniform(std::uint64_t index) const { return uniform_random(seed_, index, stream_); }
  Eigen::Vector3d in_cube(std::uint64_t attempt) const {
    return {uniform(4 * attempt + 1), uniform(4 * attempt + 2), uniform(4 * attempt + 3)};
  }
  double besides(std::uint64_t attempt) const { return uniform(4 * attempt + 4); }

 private:
  std::uint64_t seed_;
  std::uint64_t stream_;
};

/// Largest first.
std::vector<double> island_radii(const GeneratedRequest& request) {
  const auto [least, most] = request.radii;
  const int shortest = *std::min_element(request.size.begin(), request.size.end());
  const double room = 0.25 * (shortest - 1 - 2 * generated_border);
  std::vector<double> radii;
  for (std::size_t n = 0; n < static_cast<std::size_t>(request.islands); ++n) {
    // The inverse of the distribution whose density is r⁻³.
    const double share = IslandNumbers(request.seed, n).uniform(0);
    const double inverse_square = 1.0 / (most * most) + share * (1.0 / (least * least) - 1.0 / (most * most));
    radii.push_back(std::min(room, 1.0 / std::sqrt(inverse_square)));
  }
  std::sort(radii.begin(), radii.end(), std::greater<>());
  return radii;
}

bool island_fits(const std::vector<Island>& islands, const Eigen::Vector3d& centre, double radius, double gap,
                 const std::array<int, 3>& size) {
  for (int axis = 0; axis < 3; ++axis) {
    const double least = generated_border + radius;
    if (centre[axis] < least || centre[axis] > size[static_cast<std::size_t>(axis)] - 1 - least) return false;
  }
  return std::all_of(islands.begin(), islands.end(), [&](const Island& other) {
    return (centre - other.centre).norm() >= radius + other.radius + gap;
  });
}

std::optional<Eigen::Vector3d> free_place(const GeneratedRequest& request, const std::vector<Island>& islands,
                                          double radius, const IslandNumbers& numbers) {
  const bool beside_another = islands.size() % 2 == 1;
  for (std::uint64_t attempt = 0; attempt < places_tried; ++attempt) {
    const Eigen::Vector3d cube = numbers.in_cube(attempt);
    if (!beside_another) {
      const Eigen::Vector3d last(request.size[0] - 1.0, request.size[1] - 1.0, request.size[2] - 1.0);
      Eigen::Vector3d centre = cube.cwiseProduct(last);
      if (island_fits(islands, centre, radius, widest_gap, request.size)) return centre;
      continue;
    }
    const Eigen::Vector3d direction = (2.0 * cube.array() - 1.0).matrix();
    if (direction.norm() < 0.1 || direction.norm() > 1.0) continue;  // uniform over the sphere
    const Island& other = islands[static_cast<std::size_t>(attempt) % islands.size()];
    const double gap = narrowest_gap + numbers.besides(attempt) * (widest_gap - narrowest_gap);
    Eigen::Vector3d centre = other.centre + direction.normalized() * (other.radius + radius + gap);
    if (island_fits(islands, centre, radius, narrowest_gap, request.size)) return centre;
  }
  return std::nullopt;
}

double depth_in_islands(const std::vector<Island>& islands, const Eigen::Vector3d& voxel) {
  double depth = -std::numeric_limits<double>::infinity();
  for (const Island& island : islands) {
    const double distance = (voxel - island.centre).norm();
    const double shell = island.hollow > 0.0 ? distance - island.hollow : std::numeric_limits<double>::infinity();
    depth = std::max(depth, std::min(island.radius - distance, shell));
  }
  return depth;
}

}  // namespace

std::vector<Island> place_islands(const GeneratedRequest& request) {
  std::vector<Island> islands;
  const std::vector<double> radii = island_radii(request);
  for (std::size_t n = 0; n < radii.size(); ++n) {
    const auto centre = free_place(request, islands, radii[n], IslandNumbers(request.seed, radii.size() + n));
    if (!centre) continue;
    const bool is_hollow = radii[n] >= least_hollow && islands.size() % 3 == 0;
    islands.push_back({*centre, radii[n], is_hollow ? 0.5 * radii[n] : 0.0});
  }
  return islands;
}

FloatVolume islands_volume(const GeneratedRequest& request) {
  const std::vector<Island> islands = place_islands(request);
  if (islands.empty())
    throw DataError("islands: none of them has room in this volume; give smaller radii or more nodes");
  return sampled(request, [&](const Eigen::Vector3d& voxel) { return depth_in_islands(islands, voxel); });
}

}  // namespace isobench
