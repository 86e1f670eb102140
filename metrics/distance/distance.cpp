#include "isobench/metrics/distance/distance.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isobench {

namespace {

struct Distances {
  std::vector<double> mm;
  std::vector<std::uint8_t> unprojected;

  explicit Distances(std::size_t count) : mm(count), unprojected(count, 0) {}
  std::size_t count_unprojected() const {
    return static_cast<std::size_t>(std::count(unprojected.begin(), unprojected.end(), 1));
  }
  double max() const { return mm.empty() ? 0.0 : *std::max_element(mm.begin(), mm.end()); }
};

/// |f|/|∇f|, but at most the lattice's diagonal: no point of the lattice is farther from the surface.
double first_order_distance(const Isosurface& surface, const Eigen::Vector3d& x) {
  const Jet jet = surface.value_gradient(x);
  const double farthest = surface.extent().norm();
  const double slope = jet.gradient.norm();
  return slope * farthest > std::abs(jet.value) ? std::abs(jet.value) / slope : farthest;
}

// A step is at most half a voxel, so the steps reach surfaces within 20 voxels.
constexpr double tolerance = 1e-6;
constexpr int max_steps = 40;

/// Distances of the points point(0) to point(count − 1).
template <class PointAt>
Distances distances(const Isosurface& surface, std::size_t count, PointAt point) {
  Distances result(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t n) {
    const Eigen::Vector3d x = point(n);
    if (const auto foot = surface.project(x, tolerance, max_steps)) {
      result.mm[n] = (x - *foot).norm();
    } else {
      result.mm[n] = first_order_distance(surface, x);
      result.unprojected[n] = 1;
    }
  });
  return result;
}

/// The vertices that a triangle uses, in order. The others are not part of the surface.
std::vector<std::uint32_t> used_vertices(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) used[v] = 1;
  }
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (used[v] != 0) vertices.push_back(v);
  }
  return vertices;
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t v : used_vertices(mesh)) box.extend(mesh.vertices[v]);
  return box;
}

Eigen::AlignedBox3d box_of(const Isosurface& surface) { return {Eigen::Vector3d::Zero(), surface.extent()}; }

}  // namespace

bool is_elsewhere(const TriangleMesh& mesh, const Isosurface& surface, const DistanceFigures& figures) {
  const Eigen::AlignedBox3d box = box_of(mesh);
  return figures.mean > box.diagonal().norm() || !box.intersects(box_of(surface));
}

std::string hint_of_boxes(const TriangleMesh& mesh, const Isosurface& surface) {
  const Eigen::AlignedBox3d box = box_of(mesh);
  if (box.isEmpty()) return "";
  const Eigen::AlignedBox3d volume = box_of(surface);
  const double length = box.diagonal().norm(), volume_length = volume.diagonal().norm();
  const std::string lengths = fmt::format(
      "; the diagonal of its bounding box is {:.3g} mm, and that of the volume {:.3g} mm", length, volume_length);
  // An object fills from a tenth to all of its volume: a factor of 1000 is between 100 and 10,000 of the diagonals.
  if (length * 300.0 < volume_length) return lengths + ": is the mesh in metres? Lengths must be in mm";
  if (volume_length * 100.0 < length) return lengths + ": is the mesh in micrometres? Lengths must be in mm";
  if (!box.intersects(volume)) {
    return "; its bounding box lies outside of the volume: is it in another frame (LPS or RAS, another origin)?";
  }
  return "";
}

DistanceFigures measure_distance(const TriangleMesh& mesh, const MeshEdges& edges, const Isosurface& surface,
                                 std::vector<double>* at_vertices) {
  const auto& x = mesh.vertices;
  const Distances of_vertices = distances(surface, x.size(), [&](std::size_t v) { return x[v]; });
  const Distances of_edges = distances(surface, edges.ends.size(), [&](std::size_t e) {
    return Eigen::Vector3d(0.5 * (x[edges.ends[e][0]] + x[edges.ends[e][1]]));
  });
  const Distances of_centroids = distances(surface, mesh.triangles.size(), [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    return Eigen::Vector3d((x[c[0]] + x[c[1]] + x[c[2]]) / 3.0);
  });

  DistanceFigures figures;
  figures.unprojected = of_edges.count_unprojected() + of_centroids.count_unprojected();
  figures.points = edges.ends.size() + mesh.triangles.size();
  for (const std::uint32_t v : used_vertices(mesh)) {
    ++figures.points;
    figures.vertex_max = std::max(figures.vertex_max, of_vertices.mm[v]);
    figures.unprojected += of_vertices.unprojected[v];
  }
  figures.max = std::max({figures.vertex_max, of_edges.max(), of_centroids.max()});
  double area_sum = 0.0;
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    if (is_collapsed(c)) continue;
    const double area = 0.5 * (x[c[1]] - x[c[0]]).cross(x[c[2]] - x[c[0]]).norm();
    double mean = 9.0 / 20.0 * of_centroids.mm[t];
    for (std::size_t i = 0; i < 3; ++i) {
      mean += of_vertices.mm[c[i]] / 20.0 + 2.0 / 15.0 * of_edges.mm[edges.of_triangle[t][i]];
    }
    area_sum += area;
    sum += area * mean;
  }
  figures.mean = area_sum > 0.0 ? sum / area_sum : std::numeric_limits<double>::quiet_NaN();
  figures.mean_voxels = figures.mean / surface.voxel();
  figures.max_voxels = figures.max / surface.voxel();
  if (at_vertices != nullptr) *at_vertices = of_vertices.mm;
  return figures;
}

}  // namespace isobench
