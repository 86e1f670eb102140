#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

void cut(Volume& volume, const Cut& step) {
  const Lattice before = volume.lattice;
  Lattice& after = volume.lattice;
  Eigen::Vector3d first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const long long end = static_cast<long long>(step.from[axis]) + step.size[axis];
    if (step.from[axis] < 0 || step.size[axis] < 1 || end > before.size[axis]) {
      throw DataError(
          fmt::format("cut: nodes {} to {} are asked for along axis {}, but the volume has nodes 0 to {}; "
                      "correct from or size",
                      step.from[axis], end - 1, "ijk"[axis], before.size[axis] - 1));
    }
    first[static_cast<int>(axis)] = step.from[axis];
  }
  after.size = step.size;
  after.origin = before.to_world(first.cwiseProduct(before.spacing));
  volume.samples = volume.samples.visit([&](const auto& samples) -> Samples {
    std::vector<SampleOf<decltype(samples)>> kept(after.nodes());
    for (int k = 0; k < after.size[2]; ++k) {
      for (int j = 0; j < after.size[1]; ++j) {
        std::copy_n(&samples[before.index(step.from[0], step.from[1] + j, step.from[2] + k)], after.size[0],
                    &kept[after.index(0, j, k)]);
      }
    }
    return kept;
  });
}

}  // namespace isobench
