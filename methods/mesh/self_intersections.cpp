#include "isobench/methods/mesh/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "isobench/methods/mesh/box_tree.h"

namespace isobench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Pair = std::array<std::uint32_t, 2>;

Point point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The corners that two triangles have in common.
struct Shared {
  int count = 0;
  std::array<int, 3> in_first{};   ///< corner of the first triangle
  std::array<int, 3> in_second{};  ///< the same vertex's corner in the second
};

Shared shared_corners(const Triangle& a, const Triangle& b) {
  Shared shared;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[static_cast<std::size_t>(i)] != b[static_cast<std::size_t>(j)]) continue;
      shared.in_first[static_cast<std::size_t>(shared.count)] = i;
      shared.in_second[static_cast<std::size_t>(shared.count)] = j;
      ++shared.count;
      break;  // a triangle with area has three different vertices
    }
  }
  return shared;
}

class IntersectionTest {
 public:
  explicit IntersectionTest(const TriangleMesh& mesh) : mesh_(mesh) {}

  bool operator()(std::uint32_t first, std::uint32_t second) const {
    const Triangle& a = mesh_.triangles[first];
    const Triangle& b = mesh_.triangles[second];
    const Shared shared = shared_corners(a, b);
    if (shared.count == 0) return CGAL::do_intersect(triangle(a), triangle(b));
    if (shared.count == 1) {
      return opposite_edge_meets(a, shared.in_first[0], b) || opposite_edge_meets(b, shared.in_second[0], a);
    }
    if (shared.count == 2) return folded(a, b, shared);
    return true;
  }

 private:
  Point corner(const Triangle& t, int i) const { return point(mesh_.vertices[t[static_cast<std::size_t>(i % 3)]]); }
  Kernel::Triangle_3 triangle(const Triangle& t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }

  bool opposite_edge_meets(const Triangle& t, int i, const Triangle& other) const {
    return CGAL::do_intersect(triangle(other), Kernel::Segment_3(corner(t, i + 1), corner(t, i + 2)));
  }

  /// Two triangles with a common edge overlap only if they lie in one plane, on the same side of the edge.
  bool folded(const Triangle& a, const Triangle& b, const Shared& shared) const {
    const Point p = corner(a, shared.in_first[0]);
    const Point q = corner(a, shared.in_first[1]);
    const Point r = corner(a, 3 - shared.in_first[0] - shared.in_first[1]);
    const Point s = corner(b, 3 - shared.in_second[0] - shared.in_second[1]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
  }

  const TriangleMesh& mesh_;
};

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t v : mesh.triangles[triangle]) box.extend(mesh.vertices[v]);
  return box;
}

/// The triangles that may meet a marked one, those included.
std::vector<std::uint32_t> triangles_near(const TriangleMesh& mesh, const std::vector<std::uint8_t>& marked) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::uint32_t t = 0; t < marked.size(); ++t) {
    if (marked[t] != 0) boxes.push_back(box_of(mesh, t));
  }
  const BoxTree tree(boxes);
  std::vector<std::uint8_t> is_near(marked.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, is_near.size(), 1024), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t)
      is_near[t] = tree.meets(box_of(mesh, static_cast<std::uint32_t>(t))) ? 1 : 0;
  });
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < is_near.size(); ++t) {
    if (is_near[t] != 0) near.push_back(t);
  }
  return near;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> self_intersections(const TriangleMesh& mesh,
                                                             const std::vector<std::uint8_t>& marked) {
  const std::vector<std::uint32_t> near = triangles_near(mesh, marked);
  TriangleMesh part;
  if (!near.empty()) part.vertices = mesh.vertices;
  for (const std::uint32_t t : near) part.triangles.push_back(mesh.triangles[t]);
  std::vector<Pair> pairs = self_intersections(part);
  for (Pair& pair : pairs) pair = {near[pair[0]], near[pair[1]]};
  std::erase_if(pairs, [&](const Pair& pair) { return marked[pair[0]] == 0 && marked[pair[1]] == 0; });
  return pairs;
}

std::vector<std::array<std::uint32_t, 2>> self_intersections(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> has_area(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, has_area.size(), [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    has_area[t] = static_cast<std::uint8_t>(
        !CGAL::collinear(point(mesh.vertices[c[0]]), point(mesh.vertices[c[1]]), point(mesh.vertices[c[2]])));
  });
  std::vector<std::uint32_t> triangles;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (has_area[t] == 0) continue;
    triangles.push_back(t);
    boxes.push_back(box_of(mesh, t));
  }
  const BoxTree tree(boxes);
  const IntersectionTest meet(mesh);
  tbb::enumerable_thread_specific<std::vector<Pair>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size(), 256), [&](const auto& range) {
    std::vector<Pair>& mine = found.local();
    for (std::size_t place = range.begin(); place < range.end(); ++place) {
      tree.overlapping_later(place, [&](std::uint32_t m, std::uint32_t n) {
        const Pair pair{triangles[std::min(m, n)], triangles[std::max(m, n)]};
        if (meet(pair[0], pair[1])) mine.push_back(pair);
      });
    }
  });
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace isobench
