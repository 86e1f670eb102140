#include "isobench/methods/advancing-front/fences.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isobench::advancing_front {

namespace {

using Eigen::Vector3d;

/// The least cosine between the normals of an edge and of a triangle on one sheet. Below it, they are on different
/// sheets.
constexpr double least_agreement = -0.7;
/// The height of a fence to either side, relative to the longer of the two edges.
constexpr double fence_height = 0.7;

double distance_to_segment(const Vector3d& x, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (x - a - t * along).norm();
}

/// Whether p→q and u→v cross when seen along the unit vector m, at a distance below `height` along m.
bool cross(const Vector3d& p, const Vector3d& q, const Vector3d& u, const Vector3d& v, const Vector3d& m,
           double height) {
  const Vector3d pq = q - p, uv = v - u;
  const double u_side = m.dot(pq.cross(u - p)), v_side = m.dot(pq.cross(v - p));
  if ((u_side > 0.0) == (v_side > 0.0)) return false;
  const double p_side = m.dot(uv.cross(p - u)), q_side = m.dot(uv.cross(q - u));
  if ((p_side > 0.0) == (q_side > 0.0)) return false;
  const Vector3d on_pq = p + p_side / (p_side - q_side) * pq;
  const Vector3d on_uv = u + u_side / (u_side - v_side) * uv;
  return std::abs(m.dot(on_pq - on_uv)) < height;
}

/// The angle about n from `from` counter-clockwise to `to`, in [0, 2π).
double angle_about(const Vector3d& n, const Vector3d& from, const Vector3d& to) {
  const Vector3d f = from - n * n.dot(from), t = to - n * n.dot(to);
  const double angle = std::atan2(n.dot(f.cross(t)), f.dot(t));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// The gap at a node, between the edge that leaves it and the edge that arrives. Directions are angles about the
/// normal, counter-clockwise from the edge that leaves.
struct Gap {
  const Vertex& at;
  Vector3d out;
  double end;
  Gap(const Front& front, int node) : at(front.vertex(node)), out(front.vertex(front.next(node)).x - at.x) {
    end = angle_about(at.normal, out, front.vertex(front.previous(node)).x - at.x);
  }
  double angle(const Vector3d& x) const { return angle_about(at.normal, out, x - at.x); }
};

class FenceCheck {
 public:
  FenceCheck(const Front& front, const Tentative& t, double margin) : front_(front), t_(t), margin_(margin) {
    const Vector3d &a = corner(0), &b = corner(1), &c = corner(2);
    normal_ = (b - a).cross(c - a).normalized();
    length_ = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    end_side_is_new_ = t.apex < 0 || front.next(front.next(t.base)) != t.apex;
    start_side_is_new_ = t.apex < 0 || front.next(t.apex) != t.base;
  }

  Fence operator()(int edge) const {
    if (edge == t_.base) return Fence::clear;
    const Vertex& u = front_.vertex(edge);
    const Vertex& v = front_.vertex(front_.next(edge));
    const Vector3d along = (u.normal + v.normal).normalized();
    if (along.dot(normal_) <= least_agreement) return Fence::clear;
    const Vector3d m = (along + normal_).normalized();
    const double height = fence_height * std::max(length_, (v.x - u.x).norm());
    const bool u_shared = is_corner(&u), v_shared = is_corner(&v);
    if (!u_shared && !v_shared) {
      if (end_side_is_new_ && cross(corner(1), corner(2), u.x, v.x, m, height)) return Fence::crossed;
      if (start_side_is_new_ && cross(corner(2), corner(0), u.x, v.x, m, height)) return Fence::crossed;
    } else if (u_shared != v_shared) {
      // An edge that starts at a corner of the triangle may cross the opposite side.
      if (crosses_opposite_side(u_shared ? u : v, u_shared ? v : u, m, height)) return Fence::crossed;
    }
    if (!u_shared && contains(u.x, m, height)) return Fence::crossed;
    if (!v_shared && contains(v.x, m, height)) return Fence::crossed;
    return margin_ > 0.0 && is_near(u, u_shared, v, v_shared) ? Fence::near : Fence::clear;
  }

 private:
  const Vector3d& corner(std::size_t n) const { return t_.corners[n]->x; }
  bool is_corner(const Vertex* v) const { return v == t_.corners[0] || v == t_.corners[1] || v == t_.corners[2]; }

  bool crosses_opposite_side(const Vertex& shared, const Vertex& other, const Vector3d& m, double height) const {
    if (&shared == t_.corners[0]) {
      return end_side_is_new_ && cross(corner(1), corner(2), shared.x, other.x, m, height);
    }
    if (&shared == t_.corners[1]) {
      return start_side_is_new_ && cross(corner(2), corner(0), shared.x, other.x, m, height);
    }
    return false;  // the opposite side is the base: no edge of the front crosses another
  }

  bool contains(const Vector3d& x, const Vector3d& m, double height) const {
    for (std::size_t n = 0; n < 3; ++n) {
      const Vector3d& from = corner(n);
      if (m.dot((corner((n + 1) % 3) - from).cross(x - from)) <= 0.0) return false;
    }
    return std::abs(normal_.dot(x - corner(0))) < height;
  }

  bool is_near(const Vertex& u, bool u_shared, const Vertex& v, bool v_shared) const {
    const auto near_new_edge = [&](const Vertex& end) {
      return distance_to_segment(end.x, corner(1), corner(2)) < margin_ ||
             distance_to_segment(end.x, corner(2), corner(0)) < margin_;
    };
    return distance_to_segment(corner(2), u.x, v.x) < margin_ || (!u_shared && near_new_edge(u)) ||
           (!v_shared && near_new_edge(v));
  }

  const Front& front_;
  const Tentative& t_;
  double margin_;
  Vector3d normal_;
  double length_ = 0.0;
  bool end_side_is_new_ = true;
  bool start_side_is_new_ = true;
};

}  // namespace

double smallest_angle(const Tentative& t) {
  double smallest = std::numbers::pi;
  for (std::size_t n = 0; n < 3; ++n) {
    const Vector3d p = t.corners[(n + 1) % 3]->x - t.corners[n]->x, q = t.corners[(n + 2) % 3]->x - t.corners[n]->x;
    smallest = std::min(smallest, std::atan2(p.cross(q).norm(), p.dot(q)));
  }
  return smallest;
}

double circumradius_over_inradius(const Tentative& t) {
  const Vector3d &a = t.corners[0]->x, &b = t.corners[1]->x, &c = t.corners[2]->x;
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double double_area = (b - a).cross(c - a).norm();
  const double circumradius = 0.5 * ab * bc * ca / double_area;
  const double inradius = double_area / (ab + bc + ca);
  return double_area > 0.0 ? circumradius / inradius : std::numeric_limits<double>::infinity();
}

double normal_agreement(const Tentative& t) {
  const Vector3d n = (t.corners[1]->x - t.corners[0]->x).cross(t.corners[2]->x - t.corners[0]->x).normalized();
  return std::min({n.dot(t.corners[0]->normal), n.dot(t.corners[1]->normal), n.dot(t.corners[2]->normal)});
}

double gap_angle(const Front& front, int node) { return Gap(front, node).end; }

std::optional<double> gaps_left(const Front& front, const Tentative& t) {
  const int start = t.base, end = front.next(t.base);
  const bool ear_at_start = t.apex >= 0 && front.next(t.apex) == start;
  const bool ear_at_end = t.apex >= 0 && front.next(end) == t.apex;
  double least = std::numbers::pi;
  const Gap at_start(front, start);
  const double to_apex = at_start.angle(t.corners[2]->x);
  if (!(to_apex > 0.0)) return std::nullopt;
  if (!ear_at_start) least = std::min(least, at_start.end - to_apex);
  const Gap at_end(front, end);
  if (!ear_at_end) {
    const double from_apex = at_end.angle(t.corners[2]->x);
    if (from_apex >= at_end.end) return std::nullopt;
    least = std::min(least, from_apex);
  }
  if (t.apex >= 0) {
    const Gap at_apex(front, t.apex);
    const double to_start = ear_at_start ? 0.0 : at_apex.angle(t.corners[0]->x);
    const double to_end = ear_at_end ? at_apex.end : at_apex.angle(t.corners[1]->x);
    if (to_start >= to_end) return std::nullopt;
    if (!ear_at_start) least = std::min(least, to_start);
    if (!ear_at_end) least = std::min(least, at_apex.end - to_end);
  }
  return least > 1e-3 ? std::optional(least) : std::nullopt;
}

Fence fences(const Front& front, const Tentative& t, const std::vector<int>& edges, double margin) {
  const FenceCheck check(front, t, margin);
  Fence worst = Fence::clear;
  for (const int edge : edges) {
    const Fence found = check(edge);
    if (found == Fence::crossed) return found;
    if (found == Fence::near) worst = found;
  }
  return worst;
}

}  // namespace isobench::advancing_front
