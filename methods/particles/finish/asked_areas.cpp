#include "isobench/methods/particles/finish/asked_areas.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>

namespace isobench::particles {

AskedAreas::AskedAreas(const SizedSurface& sized, const TriangleMesh& mesh) : sized_(sized) {
  std::vector<double> at_vertex(mesh.vertices.size());
  tbb::parallel_for(std::size_t{0}, at_vertex.size(), [&](std::size_t v) { at_vertex[v] = at(mesh.vertices[v]); });
  double asked = 0.0;
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    asked += (at_vertex[a] + at_vertex[b] + at_vertex[c]) / 3.0;
    area += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  if (asked > 0.0 && area > 0.0) factor_ = area / asked;
}

std::vector<double> AskedAreas::at_vertices(const EditableMesh& mesh) const {
  std::vector<double> areas(mesh.vertex_count(), 1.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, areas.size(), 1024), [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v) {
      if (mesh.alive(static_cast<EditableMesh::Index>(v))) areas[v] = at(mesh.points[v]);
    }
  });
  return areas;
}

}  // namespace isobench::particles
