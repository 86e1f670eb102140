#include "methods/advancing-front/failsafe.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

namespace isobench::advancing_front {

namespace {

/// The angle between the edges at a node, on the side that is not meshed; above π where that side is reflex.
double corner_angle(const Front& front, int node) {
  const Vertex& at = front.vertex(node);
  const Eigen::Vector3d out = front.vertex(front.next(node)).x - at.x;
  const Eigen::Vector3d in = front.vertex(front.previous(node)).x - at.x;
  const double angle = std::atan2(out.cross(in).norm(), out.dot(in));
  return at.normal.dot(out.cross(in)) < 0.0 ? 2.0 * std::numbers::pi - angle : angle;
}

/// The node with the smallest angle whose corner may be cut off; −1 if there is none.
int sharpest(const Front& front, int loop) {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  int n = loop;
  do {
    const double angle = corner_angle(front, n);
    if (angle < least && front.connectable(front.previous(n), front.next(n))) {
      least = angle;
      found = n;
    }
    n = front.next(n);
  } while (n != loop);
  return found;
}

Hole describe(const Front& front, int loop) {
  Hole hole{Eigen::Vector3d::Zero()};
  int n = loop;
  do {
    hole.centre += front.vertex(n).x;
    ++hole.edges;
    n = front.next(n);
  } while (n != loop);
  hole.centre /= static_cast<double>(hole.edges);
  return hole;
}

}  // namespace

std::vector<Hole> close_holes(Front& front) {
  std::vector<Hole> holes;
  std::vector<int> changed;
  for (int node = 0; node < front.node_count(); ++node) {
    if (!front.node(node).alive) continue;
    Hole hole = describe(front, node);
    for (int loop = node; loop >= 0;) {
      const int corner = sharpest(front, loop);
      if (corner < 0) {
        hole.closed = false;
        front.abandon(loop);
        break;
      }
      changed.clear();
      const Link link = front.connect(front.previous(corner), front.next(corner), changed);
      ++hole.triangles;
      loop = link == Link::closed ? -1 : changed.front();
    }
    holes.push_back(hole);
  }
  return holes;
}

}  // namespace isobench::advancing_front
