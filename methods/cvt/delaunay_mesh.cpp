#include "isobench/methods/cvt/delaunay_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

namespace isobench::cvt {

namespace {

constexpr std::uint32_t turn(std::uint32_t half_edge, std::uint32_t by) {
  return half_edge - half_edge % 3 + (half_edge + by) % 3;
}

double cotangent(const Eigen::Vector3d& at, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - at).dot(b - at) / std::max((a - at).cross(b - at).norm(), 1e-300);
}

}  // namespace

DelaunayMesh::DelaunayMesh(std::vector<Triangle> triangles, std::size_t points)
    : triangles_(std::move(triangles)), across_(3 * triangles_.size(), none), pinched_(points, 0) {
  struct Edge {
    std::uint32_t low, high, half;
    bool forward;
  };
  std::vector<Edge> edges;
  edges.reserve(across_.size());
  std::vector<std::uint32_t> count(points, 0);
  std::vector<std::uint32_t> some(points, none);  // for each point, one half-edge opposite to it
  for (std::uint32_t half = 0; half < across_.size(); ++half) {
    const std::uint32_t from = corner(turn(half, 1)), to = corner(turn(half, 2));
    edges.push_back({std::min(from, to), std::max(from, to), half, from < to});
    ++count[corner(half)];
    some[corner(half)] = half;
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
  });
  for (std::size_t n = 0; n < edges.size();) {
    std::size_t end = n + 1;
    while (end < edges.size() && edges[end].low == edges[n].low && edges[end].high == edges[n].high) ++end;
    if (end - n == 2 && edges[n].forward != edges[n + 1].forward) link(edges[n].half, edges[n + 1].half);
    n = end;
  }
  for (std::uint32_t point = 0; point < points; ++point) {
    if (some[point] == none) continue;
    std::uint32_t walked = 0;
    std::uint32_t half = some[point];
    do {
      ++walked;
      half = across_[turn(half, 1)];
      if (half == none) break;
      half = turn(half, 1);  // opposite to the point again, in the next triangle
    } while (half != some[point]);
    pinched_[point] = half == none || walked != count[point] ? 1 : 0;
  }
}

void DelaunayMesh::link(std::uint32_t a, std::uint32_t b) {
  if (a != none) across_[a] = b;
  if (b != none) across_[b] = a;
}

bool DelaunayMesh::is_bad(const std::vector<Eigen::Vector3d>& points, std::uint32_t half) const {
  const std::uint32_t other = across_[half];
  if (other == none) return false;
  const Eigen::Vector3d& a = points[corner(turn(half, 1))];
  const Eigen::Vector3d& b = points[corner(turn(half, 2))];
  return cotangent(points[corner(half)], a, b) + cotangent(points[corner(other)], a, b) < -1e-9;
}

bool DelaunayMesh::joined(std::uint32_t half, std::uint32_t to) const {
  const std::uint32_t start = half;
  do {
    if (corner(turn(half, 1)) == to) return true;
    half = turn(across_[turn(half, 1)], 1);
  } while (half != start);
  return false;
}

bool DelaunayMesh::may_flip(const std::vector<Eigen::Vector3d>& points, std::uint32_t half) const {
  const std::uint32_t c = corner(half), d = corner(across_[half]);
  if (pinched_[c] != 0 || pinched_[d] != 0 || joined(half, d)) return false;
  const Eigen::Vector3d &pc = points[c], &pd = points[d];
  const Eigen::Vector3d &a = points[corner(turn(half, 1))], &b = points[corner(turn(half, 2))];
  const Eigen::Vector3d normal = (a - pc).cross(b - pc) + (b - pd).cross(a - pd);
  return (a - pc).cross(pd - pc).dot(normal) > 0.0 && (b - pd).cross(pc - pd).dot(normal) > 0.0;
}

void DelaunayMesh::flip_edge(std::uint32_t half) {
  // Triangles (c, a, b) and (d, b, a) become (c, a, d) and (d, b, c).
  const std::uint32_t other = across_[half];
  const std::uint32_t beyond_ad = across_[turn(other, 1)], beyond_bc = across_[turn(half, 1)];
  const std::uint32_t c = corner(half), d = corner(other);
  triangles_[half / 3][(half + 2) % 3] = d;
  triangles_[other / 3][(other + 2) % 3] = c;
  across_[half] = across_[other] = none;
  link(half, beyond_ad);
  link(other, beyond_bc);
  link(turn(half, 1), turn(other, 1));
}

std::size_t DelaunayMesh::flip(const std::vector<Eigen::Vector3d>& points) {
  std::vector<char> bad(across_.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, across_.size(), 4096), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto half = static_cast<std::uint32_t>(n);
      bad[n] = half < across_[n] && is_bad(points, half) ? 1 : 0;
    }
  });
  std::vector<std::uint32_t> open;
  for (std::uint32_t half = 0; half < across_.size(); ++half) {
    if (bad[half] != 0) open.push_back(half);
  }
  // On a curved surface, a flip changes edge lengths, so in theory flips might repeat without end. Hence the limit.
  const std::size_t most = across_.size();
  std::size_t flipped = 0;
  while (!open.empty() && flipped < most) {
    const std::uint32_t half = open.back();
    open.pop_back();
    if (!is_bad(points, half) || !may_flip(points, half)) continue;
    const std::uint32_t other = across_[half];
    flip_edge(half);
    ++flipped;
    for (const std::uint32_t changed : {half, turn(half, 2), other, turn(other, 2)}) open.push_back(changed);
  }
  return flipped;
}

}  // namespace isobench::cvt
