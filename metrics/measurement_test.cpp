#include "isobench/metrics/measurement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh/sample_meshes.h"

namespace isobench {

namespace {

/// A torus around the z axis, radii 2 and 1 times 5 mm, as sample_meshes::torus.
Isosurface torus_surface() {
  FloatVolume volume;
  volume.lattice.size = {41, 41, 25};
  for (int k = 0; k < 25; ++k) {
    for (int j = 0; j < 41; ++j) {
      for (int i = 0; i < 41; ++i) {
        volume.samples.push_back(static_cast<float>(5.0 - std::hypot(std::hypot(i - 20.0, j - 20.0) - 10.0, k - 12.0)));
      }
    }
  }
  return {std::move(volume), 0.0};
}

TriangleMesh torus_mesh() {
  TriangleMesh mesh = sample_meshes::torus(40);
  for (Eigen::Vector3d& v : mesh.vertices) v = 5.0 * v + Eigen::Vector3d(20, 20, 12);
  return mesh;
}

TEST(Measurement, AllFiguresOfATorus) {
  TriangleMesh mesh = torus_mesh();
  Monitor monitor;
  const Measurement measurement = measure(mesh, torus_surface(), SizingField(1.2), 2, monitor);
  EXPECT_EQ(measurement.vertices, 3200U);
  EXPECT_EQ(measurement.triangles, 6400U);
  EXPECT_EQ(measurement.topology.euler, 0);
  EXPECT_EQ(measurement.reference.euler, 0);
  EXPECT_EQ(measurement.reference.components, 1U);
  EXPECT_EQ(measurement.reference.k, 2);
  EXPECT_EQ(measurement.valence.v6_percent, 100.0);
  EXPECT_GT(measurement.radius_ratio.min, 0.5);
  EXPECT_LT(measurement.angles.max, 110.0);
  // The longest edges are the diagonals of the outer rim's quads: 1.41 mm.
  EXPECT_NEAR(measurement.edges.over_h0_max, 1.41 / 1.2, 0.01);
  EXPECT_GT(measurement.distance.mean, 0.0);
  EXPECT_LT(measurement.distance.max, 0.1) << "the spline moves the torus by κ/6 voxel² a curvature";

  EXPECT_EQ(mesh.triangle_data.at("radius_ratio").size(), 6400U);
  EXPECT_EQ(mesh.vertex_data.at("valence"), std::vector<double>(3200, 6.0));
  EXPECT_EQ(mesh.vertex_data.at("h0"), std::vector<double>(3200, 1.2));
  const std::vector<double>& distance = mesh.vertex_data.at("distance");
  ASSERT_EQ(distance.size(), 3200U);
  EXPECT_EQ(*std::max_element(distance.begin(), distance.end()), measurement.distance.vertex_max);
  for (const char* stage : {"shape", "topology", "distance", "reference"}) {
    EXPECT_GT(monitor.seconds(stage), 0.0) << stage;
  }
}

// A method whose own field was larger by a half than the one that was asked for.
TEST(Measurement, TakesEdgesAgainstTheMethodsOwnH0Too) {
  TriangleMesh mesh = torus_mesh();
  Monitor monitor;
  const EdgeLengthFigures alone = measure_edge_lengths(mesh, SizingField(1.2));
  EXPECT_GT(alone.exceed_percent, 0.0);
  EXPECT_EQ(alone.over_own_h0_max, alone.over_h0_max);
  EXPECT_EQ(alone.own_exceed_percent, alone.exceed_percent);
  EXPECT_EQ(alone.own_exceed_triangle_percent, alone.exceed_triangle_percent);
  mesh.vertex_data[own_h0].assign(mesh.vertices.size(), 1.8);
  const EdgeLengthFigures both = measure_edge_lengths(mesh, SizingField(1.2));
  EXPECT_EQ(both.over_h0_max, alone.over_h0_max);
  EXPECT_EQ(both.exceed_percent, alone.exceed_percent);
  EXPECT_NEAR(both.over_own_h0_max, alone.over_h0_max / 1.5, 1e-12);
  EXPECT_EQ(both.own_exceed_percent, 0.0);
  EXPECT_EQ(both.own_exceed_triangle_percent, 0.0);
}

void expect_refused(TriangleMesh mesh, const std::string& part) {
  Monitor monitor;
  try {
    measure(mesh, torus_surface(), SizingField(1.5), 1, monitor);
    FAIL() << "measured without complaint";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Measurement, RefusesWhatIsNoMesh) {
  expect_refused({}, "no triangles");
  TriangleMesh mesh = torus_mesh();
  mesh.triangles[17][2] = 3200;
  expect_refused(mesh, "triangle 17 of the mesh names vertex 3200");
  mesh = torus_mesh();
  mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
  expect_refused(mesh, "vertex 5");
}

TEST(Measurement, StopsWhenCancelled) {
  TriangleMesh mesh = torus_mesh();
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(measure(mesh, torus_surface(), SizingField(1.5), 1, monitor), Cancelled);
}

TEST(Measurement, EveryMetricIsDefinedOnce) {
  std::set<std::string> names;
  for (const MetricDefinition& metric : metric_definitions()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_GT(metric.definition.size(), 20U) << metric.name;
    EXPECT_EQ(metric.definition.back(), '.') << metric.name;
  }
  for (const char* name : {"vertices",
                           "triangles",
                           "radius_ratio_min",
                           "radius_ratio_p01",
                           "radius_ratio_avg",
                           "angle_min",
                           "angle_max",
                           "valence_lt5_percent",
                           "valence_5_percent",
                           "valence_6_percent",
                           "valence_7_percent",
                           "valence_gt7_percent",
                           "valence_extreme_count",
                           "edge_over_h0_max",
                           "edge_over_h0_exceed_percent",
                           "edge_over_h0_exceed_count",
                           "floor_area_percent",
                           "components",
                           "components_reference",
                           "euler",
                           "euler_reference",
                           "reference_k",
                           "boundary_edges",
                           "nonmanifold_edges",
                           "nonmanifold_vertices",
                           "self_intersections",
                           "distance_mean",
                           "distance_max"}) {
    EXPECT_EQ(names.count(name), 1U) << name << " is a column of results.csv";
  }
}

}  // namespace

}  // namespace isobench
