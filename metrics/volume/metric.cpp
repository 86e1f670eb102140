// The volume that the mesh encloses, by the divergence theorem: a sixth of det(a, b, c) for each triangle.
#include <Eigen/Geometry>

#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

/// Whether as many triangles run through each edge one way as the other way. Then they bound a volume, also where more
/// than two triangles meet at an edge.
bool closed_and_oriented(const std::vector<HalfEdge>& sides) {
  for (std::size_t begin = 0; begin < sides.size();) {
    const std::size_t end = edge_end(sides, begin);
    int balance = 0;
    for (std::size_t s = begin; s < end; ++s) balance += sides[s].forward ? 1 : -1;
    if (balance != 0) return false;
    begin = end;
  }
  return !sides.empty();
}

void measure(MetricInput& input, MetricOutput& output) {
  if (!closed_and_oriented(input.half_edges())) return;
  const std::vector<Eigen::Vector3d>& x = input.mesh().vertices;
  // Tetrahedra from a point of the mesh: from a far origin, their volumes would cancel and lose digits.
  const Eigen::Vector3d& origin = x[input.mesh().triangles.front()[0]];
  double six_volumes = 0.0;
  for (const Triangle& t : input.mesh().triangles) {
    six_volumes += (x[t[0]] - origin).dot((x[t[1]] - origin).cross(x[t[2]] - origin));
  }
  output.set("volume", six_volumes / 6.0);
}

}  // namespace

Metric metric_volume() {
  Metric metric;
  metric.name = "volume";
  metric.stage = "shape";
  metric.figures = {{.name = "volume",
                     .unit = "mm³",
                     .definition = "Volume that the mesh encloses. It is negative if the triangles are "
                                   "counter-clockwise seen from inside.",
                     .unmeasured = "the mesh is not closed or its triangles are not oriented alike",
                     .column = 904}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
