// Generated volumes: surfaces that nobody has tuned a method for, as many as wanted. A generator, its seed and a few
// numbers determine every sample.
//
// All lengths but the spacing are in voxels: a voxel that is 7 times as long as wide stretches the object, too. On each
// side, at least 3 layers of nodes are outside the object, so the surface of a spline over 4 nodes a direction is
// closed and does not touch the volume's border.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// random_field  white noise, smoothed; its isovalue is a quantile of its own samples
/// mask          1 where the random field is inside, 0 elsewhere; isovalue 0.5. F is decided between the nodes.
/// foam          walls between the cells of random points; isovalue 0
/// islands       separate balls of very different radii, some hollow, some nearly touching; isovalue 0
enum class Generator { random_field, mask, foam, islands };

const char* to_string(Generator generator);  ///< "random-field", "mask", "foam" or "islands"

struct GeneratedRequest {
  Generator generator = Generator::random_field;
  std::uint64_t seed = 0;
  std::array<int, 3> size{32, 32, 32};                ///< nodes, least_generated_size to most_generated_size
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();  ///< mm

  // random_field and mask
  double correlation = 2.0;  ///< voxels: sigma of the Gaussian that smooths the noise; a larger one gives larger shapes
  double quantile = 0.5;     ///< share of the samples below the isovalue, where the field is not faded out

  // foam
  int bubbles = 20;
  double wall = 2.0;  ///< voxels: thickness of a wall before the spline smooths it, which takes about one voxel off

  // islands
  int islands = 20;
  std::array<double, 2> radii{1.0, 6.0};  ///< voxels: the smallest and the largest
};

inline constexpr int generated_border = 3;       ///< layers of nodes on each side that are outside
inline constexpr int least_generated_size = 16;  ///< nodes: fewer leave no room for an object
inline constexpr int most_generated_size = 512;  ///< nodes: more are most likely a mistake

struct GeneratedVolume {
  Volume volume;
  double isovalue = 0.0;
};

/// With Inside::below, the object is where samples are below the isovalue; the quantile is still the share of samples
/// below it. Threaded; the same bits for any number of threads. Cost: linear in the nodes, times the correlation,
/// bubbles or islands; 64³ nodes take well below a second. Throws DataError if no bubble or island has room.
GeneratedVolume generate(const GeneratedRequest& request, Inside inside, Monitor& monitor);

/// Everything that determines the samples, in one line: "random-field, revision 1, seed 17, size 32 × 32 × 32, …".
std::string describe(const GeneratedRequest& request);

}  // namespace isobench
