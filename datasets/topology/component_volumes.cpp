#include "isobench/datasets/topology/component_volumes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

namespace isobench {

namespace {

using Eigen::Vector3d;

struct Corner {
  Vector3d point;
  double value;
};

Vector3d crossing(const Corner& a, const Corner& b) {
  return a.point + a.value / (a.value - b.value) * (b.point - a.point);
}

/// Six times the volume between the origin and the part of f = 0 in a tetrahedron, where f is taken as linear. The sign
/// is that of the side to which f falls.
double six_volumes(const std::array<Corner, 4>& tetrahedron) {
  std::array<const Corner*, 4> inside{};
  std::array<const Corner*, 4> outside{};
  std::size_t in = 0;
  std::size_t out = 0;
  for (const Corner& corner : tetrahedron) (corner.value > 0.0 ? inside[in++] : outside[out++]) = &corner;
  if (in == 0 || out == 0) return 0.0;
  const auto triangle = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d normal = (b - a).cross(c - a);
    const double six = a.dot(b.cross(c));
    return normal.dot(outside[0]->point - inside[0]->point) >= 0.0 ? six : -six;
  };
  if (in == 2) {
    const Vector3d a = crossing(*inside[0], *outside[0]);
    const Vector3d b = crossing(*inside[0], *outside[1]);
    const Vector3d c = crossing(*inside[1], *outside[1]);
    const Vector3d d = crossing(*inside[1], *outside[0]);
    return triangle(a, b, c) + triangle(a, c, d);
  }
  const Corner& tip = in == 1 ? *inside[0] : *outside[0];
  const auto& others = in == 1 ? outside : inside;
  return triangle(crossing(tip, *others[0]), crossing(tip, *others[1]), crossing(tip, *others[2]));
}

/// The same for a box that is cut into parts³ equal boxes, each of them into six tetrahedra around its diagonal.
double six_volumes(const Isosurface& surface, const CellBox& box, int parts, const Vector3d& origin, double offset) {
  const int nodes = parts + 1;
  std::vector<Corner> corners;
  const Vector3d step = (box.high - box.low) / parts;
  for (int k = 0; k < nodes; ++k) {
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i) {
        const Vector3d x = box.low + step.cwiseProduct(Vector3d(i, j, k));
        corners.push_back({x - origin, surface.value(x) - offset});
      }
    }
  }
  // Paths along edges from corner 0 to corner 7; bit 0 of a corner is x, bit 1 is y, bit 2 is z.
  constexpr std::array<std::array<int, 2>, 6> paths{{{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts; ++i) {
        const auto at = [&](int corner) {
          const int row = j + (corner >> 1 & 1) + nodes * (k + (corner >> 2));
          const int index = i + (corner & 1) + nodes * row;
          return corners[static_cast<std::size_t>(index)];
        };
        for (const std::array<int, 2>& path : paths) sum += six_volumes({at(0), at(path[0]), at(path[1]), at(7)});
      }
    }
  }
  return sum;
}

/// Small components have few boxes, which must be cut for the same accuracy.
int parts_for(std::size_t boxes) { return boxes < 500 ? 4 : boxes < 5000 ? 2 : 1; }

}  // namespace

std::vector<double> component_volumes(const Isosurface& surface, const CertifiedTopology& topology) {
  std::vector<SurfaceBox> boxes;
  topology.boxes->for_each([&boxes](const SurfaceBox& box) { boxes.push_back(box); });
  // Measured from a point of the component itself: where boxes of different size meet, the triangles leave slits, whose
  // effect grows with the distance.
  std::vector<Vector3d> origin(topology.components.size(), Vector3d::Zero());
  for (const SurfaceBox& box : boxes) origin[box.component] = box.box.low;
  std::vector<double> six(boxes.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 256), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const std::uint32_t component = boxes[n].component;
      six[n] = six_volumes(surface, boxes[n].box, parts_for(topology.components[component].boxes), origin[component],
                           topology.counted_at);
    }
  });
  std::vector<double> volumes(topology.components.size(), 0.0);
  for (std::size_t n = 0; n < boxes.size(); ++n) volumes[boxes[n].component] += six[n] / 6.0;
  return volumes;
}

std::size_t leave_out_below(double least, const std::vector<double>& volumes, CertifiedTopology& topology) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c) {
    SurfaceComponent& component = topology.components[c];
    if (component.is_left_out || std::abs(volumes[c]) >= least) continue;
    component.is_left_out = true;
    topology.euler -= component.euler;
    ++count;
  }
  return count;
}

}  // namespace isobench
