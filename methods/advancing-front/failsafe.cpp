#include "isobench/methods/advancing-front/failsafe.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace isobench::advancing_front {

namespace {

/// The angle between the edges at a node on the side that is not meshed, in (0, 2π).
double corner_angle(const Front& front, int node) {
  const Vertex& at = front.vertex(node);
  const Eigen::Vector3d out = front.vertex(front.next(node)).x - at.x;
  const Eigen::Vector3d in = front.vertex(front.previous(node)).x - at.x;
  const double angle = std::atan2(out.cross(in).norm(), out.dot(in));
  return at.normal.dot(out.cross(in)) < 0.0 ? 2.0 * std::numbers::pi - angle : angle;
}

/// The node with the smallest angle among those whose corner may be cut off; −1 if there is none.
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

/// Closes a loop with a fan of triangles round a new vertex and returns their number; does nothing and returns 0 if the
/// loop touches itself.
std::size_t fan(const Isosurface& surface, Front& front, int loop) {
  std::set<std::uint32_t> seen;
  int n = loop;
  do {
    if (!seen.insert(front.node(n).vertex).second) return 0;
    n = front.next(n);
  } while (n != loop);
  const Eigen::Vector3d centre = describe(front, loop).centre;
  const Eigen::Vector3d x = surface.project(centre).value_or(centre);
  const int hub = front.grow(loop, {x, outward_normal(surface.value_gradient(x).gradient), front.vertex(loop).step});
  std::size_t triangles = 1;
  std::vector<int> changed;
  while (front.connect(front.next(hub), hub, changed) != Link::closed) ++triangles;
  return triangles + 1;
}

/// Closes the loop through a node, or takes it off the front if that is impossible.
void close(const Isosurface& surface, Front& front, int loop, Hole& hole) {
  std::vector<int> changed;
  while (true) {
    const int corner = sharpest(front, loop);
    if (corner < 0) break;
    changed.clear();
    ++hole.triangles;
    if (front.connect(front.previous(corner), front.next(corner), changed) == Link::closed) return;
    loop = changed.front();
  }
  const std::size_t triangles = fan(surface, front, loop);
  hole.triangles += triangles;
  hole.closed = triangles > 0;
  if (!hole.closed) front.abandon(loop);
}

}  // namespace

std::vector<Hole> close_holes(const Isosurface& surface, Front& front) {
  std::vector<Hole> holes;
  for (int node = 0; node < front.node_count(); ++node) {
    if (!front.node(node).alive) continue;
    holes.push_back(describe(front, node));
    close(surface, front, node, holes.back());
  }
  return holes;
}

}  // namespace isobench::advancing_front
