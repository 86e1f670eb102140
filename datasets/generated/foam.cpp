#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/datasets/generated/generators.h"
#include "isobench/foundation/random.h"

namespace isobench {

namespace {

constexpr double border_clearance = 0.5;  // voxels between the foam's cut and the layers that are outside

/// The middle of the volume and half its extent without the border; voxels.
struct FoamBox {
  Eigen::Vector3d middle;
  Eigen::Vector3d half;
};

FoamBox foam_box(const std::array<int, 3>& size) {
  const Eigen::Vector3d last(size[0] - 1.0, size[1] - 1.0, size[2] - 1.0);
  return {0.5 * last, ((0.5 * last).array() - (generated_border + border_clearance)).matrix()};
}

std::vector<Eigen::Vector3d> bubble_centres(const GeneratedRequest& request, const FoamBox& box) {
  std::vector<Eigen::Vector3d> centres;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(request.bubbles); ++n) {
    Eigen::Vector3d place;
    for (std::uint64_t axis = 0; axis < 3; ++axis)
      place[static_cast<int>(axis)] = 2.0 * uniform_random(request.seed, 3 * n + axis, 1) - 1.0;
    centres.emplace_back(box.middle + box.half.cwiseProduct(place));
  }
  return centres;
}

/// The distance to the second-nearest centre less that to the nearest one.
double between_cells(const std::vector<Eigen::Vector3d>& centres, const Eigen::Vector3d& voxel) {
  double nearest = std::numeric_limits<double>::infinity();
  double second = nearest;
  for (const Eigen::Vector3d& centre : centres) {
    const double square = (voxel - centre).squaredNorm();
    second = std::min(second, std::max(nearest, square));
    nearest = std::min(nearest, square);
  }
  return std::sqrt(second) - std::sqrt(nearest);
}

double depth_in_box(const FoamBox& box, const Eigen::Vector3d& voxel) {
  const double fourth_powers = (voxel - box.middle).cwiseQuotient(box.half).array().square().square().sum();
  return box.half.minCoeff() * (1.0 - std::sqrt(std::sqrt(fourth_powers)));
}

}  // namespace

FloatVolume foam(const GeneratedRequest& request) {
  const FoamBox box = foam_box(request.size);
  const std::vector<Eigen::Vector3d> centres = bubble_centres(request, box);
  return sampled(request, [&](const Eigen::Vector3d& voxel) {
    return std::min(request.wall - between_cells(centres, voxel), depth_in_box(box, voxel));
  });
}

}  // namespace isobench
