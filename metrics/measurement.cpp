#include "isobench/metrics/measurement.h"

#include <fmt/format.h>

#include <utility>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

void check_mesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw DataError("the mesh has no triangles; there is nothing to measure");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw DataError(fmt::format("vertex {} of the mesh is at ({}, {}, {}); coordinates must be finite numbers", v,
                                  mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()));
    }
    // A million kilometres: no mesh in mm reaches there, and figures far beyond would not be numbers any more.
    if (mesh.vertices[v].cwiseAbs().maxCoeff() > 1e12) {
      throw DataError(
          fmt::format("vertex {} of the mesh is at ({}, {}, {}); coordinates must be in mm, within 1e12 of 0", v,
                      mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.vertices.size()) continue;
      throw DataError(fmt::format("triangle {} of the mesh names vertex {}, but there are {} vertices, counted from 0",
                                  t, v, mesh.vertices.size()));
    }
  }
}

void measure_shape(TriangleMesh& mesh, Measurement& measurement) {
  std::vector<double> ratios = radius_ratios(mesh);
  measurement.radius_ratio = summarize_radius_ratios(ratios);
  mesh.triangle_data["radius_ratio"] = std::move(ratios);
  measurement.angles = measure_angles(mesh);
  const std::vector<int> valence = valences(mesh);
  measurement.valence = summarize_valences(valence);
  mesh.vertex_data["valence"].assign(valence.begin(), valence.end());
}

}  // namespace

Measurement measure(TriangleMesh& mesh, const Isosurface& surface, const SizingField& sizing, int reference_k,
                    Monitor& monitor) {
  check_mesh(mesh);
  Measurement measurement;
  measurement.vertices = mesh.vertices.size();
  measurement.triangles = mesh.triangles.size();
  {
    const auto stage = monitor.stage("shape");
    measure_shape(mesh, measurement);
    measurement.edges = measure_edge_lengths(mesh, sizing, &mesh.vertex_data["h0"]);
  }
  monitor.check();
  {
    const auto stage = monitor.stage("topology");
    measurement.topology = measure_topology(mesh);
  }
  monitor.check();
  {
    const auto stage = monitor.stage("distance");
    measurement.distance = measure_distance(mesh, surface, &mesh.vertex_data["distance"]);
    measurement.distance_from_surface = measure_distance_from_surface(mesh, surface, monitor);
  }
  monitor.check();
  {
    const auto stage = monitor.stage("reference");
    measurement.reference = reference_topology(surface, reference_k, monitor);
  }
  return measurement;
}

}  // namespace isobench
