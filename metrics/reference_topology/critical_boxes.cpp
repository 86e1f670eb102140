#include "isobench/metrics/reference_topology/critical_boxes.h"

#include <algorithm>

#include "isobench/methods/sizing/band.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench {

namespace {

constexpr int margin = 2;  // cells around the cell of a point

bool meet(const NodeBox& a, const NodeBox& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
  }
  return true;
}

void widen(CriticalBox& one, const CriticalBox& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    one.box.low[axis] = std::min(one.box.low[axis], other.box.low[axis]);
    one.box.high[axis] = std::max(one.box.high[axis], other.box.high[axis]);
  }
  one.distance = std::min(one.distance, other.distance);
}

CriticalBox box_around(const CriticalPoint& point, const Isosurface& surface) {
  CriticalBox result;
  result.distance = point.distance / surface.voxel();
  const Lattice& lattice = surface.lattice();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto coordinate = static_cast<Eigen::Index>(axis);
    const int cell = static_cast<int>(point.position[coordinate] / lattice.spacing[coordinate]);
    result.box.low[axis] = std::max(0, cell - margin);
    result.box.high[axis] = std::min(lattice.size[axis] - 1, cell + 1 + margin);
  }
  return result;
}

}  // namespace

std::vector<CriticalBox> critical_boxes(const Isosurface& surface, double reach) {
  std::vector<CriticalBox> boxes;
  for (const CriticalPoint& point : critical_points(surface, Band(surface, 2), reach * surface.voxel())) {
    CriticalBox box = box_around(point, surface);
    // A box that has grown may meet further boxes, so the search starts again.
    for (auto other = boxes.begin(); other != boxes.end();) {
      if (meet(box.box, other->box)) {
        widen(box, *other);
        boxes.erase(other);
        other = boxes.begin();
      } else {
        ++other;
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace isobench
