#include "metrics/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace isobench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

Point point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Which corners two triangles have in common.
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
      break;  // the corners of a triangle with area are three vertices
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

  /// Two triangles on one edge overlap only where they lie in one plane, on the same side of the edge.
  bool folded(const Triangle& a, const Triangle& b, const Shared& shared) const {
    const Point p = corner(a, shared.in_first[0]);
    const Point q = corner(a, shared.in_first[1]);
    const Point r = corner(a, 3 - shared.in_first[0] - shared.in_first[1]);
    const Point s = corner(b, 3 - shared.in_second[0] - shared.in_second[1]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
  }

  const TriangleMesh& mesh_;
};

std::vector<Box> boxes_of_triangles(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> has_area(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, has_area.size(), [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    has_area[t] = static_cast<std::uint8_t>(
        !CGAL::collinear(point(mesh.vertices[c[0]]), point(mesh.vertices[c[1]]), point(mesh.vertices[c[2]])));
  });
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (has_area[t] == 0) continue;
    CGAL::Bbox_3 bounds;
    for (const std::uint32_t v : mesh.triangles[t]) bounds += point(mesh.vertices[v]).bbox();
    boxes.emplace_back(bounds, t);
  }
  return boxes;
}

}  // namespace

std::size_t count_self_intersections(const TriangleMesh& mesh) {
  std::vector<Box> boxes = boxes_of_triangles(mesh);
  const IntersectionTest meet(mesh);
  std::atomic<std::size_t> count{0};  // whole numbers: the order of additions does not matter
  CGAL::box_self_intersection_d<CGAL::Parallel_if_available_tag>(boxes.begin(), boxes.end(),
                                                                 [&](const Box& a, const Box& b) {
                                                                   if (meet(a.info(), b.info()))
                                                                     count.fetch_add(1, std::memory_order_relaxed);
                                                                 });
  return count.load();
}

}  // namespace isobench
