#include "isobench/methods/particles/mesh_edits/asked_areas.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>

namespace isobench::particles {

AskedAreas::AskedAreas(const SizedSurface& sized, const TriangleMesh& mesh) : sized_(&sized) {
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

AskedAreas AskedAreas::with_bounds(std::vector<RaisedBound> kept) const {
  AskedAreas areas = *this;
  areas.kept_ = std::move(kept);
  return areas;
}

double AskedAreas::spacing(const Eigen::Vector3d& x) const {
  if (!kept_) return sized_->spacing(x);
  double h = sized_->field().h(x);
  for (const auto& [n, least_h] : *kept_) h = std::min(h, std::max(least_h, sized_->bounds().bound(n, x)));
  return h / sized_->contraction();
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

std::vector<double> area_shares(const EditableMesh& mesh, const AskedAreas& areas) {
  std::vector<double> shares(mesh.vertex_count(), 0.0);
  for (std::uint32_t t = 0; 3 * t < mesh.half_edge_count(); ++t) {
    if (!mesh.triangle_alive(t)) continue;
    const auto [a, b, c] = mesh.triangle(t);
    const double third = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 6.0;
    for (const std::uint32_t v : {a, b, c}) shares[v] += third;
  }
  const std::vector<double> asked = areas.at_vertices(mesh);
  tbb::parallel_for(std::size_t{0}, shares.size(), [&](std::size_t v) {
    shares[v] = mesh.alive(static_cast<std::uint32_t>(v)) ? shares[v] / (2.0 * asked[v]) : 1.0;
  });
  return shares;
}

}  // namespace isobench::particles
