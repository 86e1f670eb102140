#include "isobench/metrics/measurement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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
  const Measurement measurement = measure(mesh, torus_surface(), SizingField(1.2), monitor);
  EXPECT_EQ(measurement.figure("vertices"), 3200.0);
  EXPECT_EQ(measurement.figure("triangles"), 6400.0);
  EXPECT_EQ(measurement.figure("euler"), 0.0);
  EXPECT_EQ(measurement.figure("euler_reference"), 0.0);
  EXPECT_EQ(measurement.figure("components_reference"), 1.0);
  EXPECT_EQ(measurement.figure("valence_6_percent"), 100.0);
  EXPECT_GT(measurement.number("radius_ratio_min"), 0.5);
  EXPECT_LT(measurement.number("angle_max"), 110.0);
  // The longest edges are the diagonals of the outer rim's quads: 1.41 mm.
  EXPECT_NEAR(measurement.number("edge_over_h0_max"), 1.41 / 1.2, 0.01);
  EXPECT_GT(measurement.number("distance_mean"), 0.0);
  EXPECT_LT(measurement.number("distance_max"), 0.1) << "the spline moves the torus by (κ1 + κ2)/6 voxel²";

  EXPECT_EQ(mesh.triangle_data.at("radius_ratio").size(), 6400U);
  EXPECT_EQ(mesh.vertex_data.at("valence"), std::vector<double>(3200, 6.0));
  EXPECT_EQ(mesh.vertex_data.at("h0"), std::vector<double>(3200, 1.2));
  const std::vector<double>& distance = mesh.vertex_data.at("distance");
  ASSERT_EQ(distance.size(), 3200U);
  EXPECT_EQ(*std::max_element(distance.begin(), distance.end()), measurement.number("distance_vertex_max"));
  for (const char* stage : {"shape", "topology", "distance", "reference"}) {
    EXPECT_GT(monitor.seconds(stage), 0.0) << stage;
  }
}

TEST(Measurement, AMeshAloneHasTheFiguresThatNeedNoSurface) {
  TriangleMesh mesh = torus_mesh();
  Monitor monitor;
  const Isosurface surface = torus_surface();
  const Measurement whole = measure(mesh, surface, SizingField(1.2), monitor);
  mesh.vertex_data.clear();
  const Measurement alone = measure(mesh, MeasuredAgainst{}, monitor);
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const std::string& name = declared_figures()[n].name;
    EXPECT_EQ(whole.at(n).has_value(), !name.starts_with("blow_up_")) << name;
    EXPECT_TRUE(alone.is_known(n)) << name;
    EXPECT_EQ(alone.at(n), metric_of_figure(n).needs == Needs::mesh ? whole.at(n) : std::nullopt) << name;
  }
  EXPECT_TRUE(alone.histogram("edge_over_h0").counts.empty());
  EXPECT_EQ(mesh.vertex_data.count("h0"), 0U);
  EXPECT_EQ(mesh.vertex_data.count("distance"), 0U);
  const Measurement unsized = measure(mesh, {.surface = &surface}, monitor);
  EXPECT_EQ(unsized.figure("edge_over_h0_exceed_count"), std::nullopt);
  EXPECT_EQ(unsized.figure("distance_mean"), whole.figure("distance_mean"));
}

TEST(Measurement, TellsNotMeasuredFromUnknown) {
  Measurement measurement;
  const std::size_t area = figure_index("area");
  EXPECT_TRUE(measurement.is_known(area));
  EXPECT_EQ(measurement.figure("area"), std::nullopt);
  EXPECT_TRUE(std::isnan(measurement.number("area")));
  measurement.set_unknown(area);
  measurement.set_unknown(figure_index("volume"));
  EXPECT_FALSE(measurement.is_known(area));
  measurement.set("area", 2.5);
  EXPECT_TRUE(measurement.is_known(area));
  EXPECT_FALSE(measurement.is_known(figure_index("volume")));
  EXPECT_EQ(measurement.figure("area"), 2.5);
  measurement.set("area", std::numeric_limits<double>::infinity());
  EXPECT_EQ(measurement.figure("area"), std::nullopt);
  EXPECT_THROW(measurement.set("vertices", 2.5), std::logic_error);
  EXPECT_THROW(measurement.set("vertices", -1.0), std::logic_error);
  measurement.set("euler", -14.0);
  EXPECT_EQ(measurement.figure("euler"), -14.0);
  EXPECT_THROW(measurement.number("eulre"), std::logic_error);
}

TEST(Measurement, AFigureThatAMeshLacksIsDeclaredAsSuch) {
  TriangleMesh collapsed = torus_mesh();
  collapsed.triangles = {{0, 0, 1}};
  Monitor monitor;
  const Measurement measurement = measure(collapsed, torus_surface(), SizingField(1.2), monitor);
  std::size_t missing = 0;
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    if (measurement.at(n)) continue;
    ++missing;
    EXPECT_FALSE(declared_figures()[n].unmeasured.empty()) << declared_figures()[n].name;
  }
  EXPECT_GT(missing, 15U);
}

void expect_refused(TriangleMesh mesh, const std::string& part) {
  Monitor monitor;
  try {
    measure(mesh, torus_surface(), SizingField(1.5), monitor);
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

TEST(Measurement, WhatTakesSecondsIsMeasuredOnRequest) {
  TriangleMesh mesh = torus_mesh();
  const Isosurface surface = torus_surface();
  Monitor monitor;
  const Measurement usual = measure(mesh, {.surface = &surface}, monitor, MetricChoice::usual);
  const Measurement all = measure(mesh, {.surface = &surface}, monitor, MetricChoice::all);
  std::size_t on_request = 0;
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const bool asked = metric_of_figure(n).when == When::on_request;
    on_request += asked ? 1 : 0;
    EXPECT_TRUE(all.is_known(n));
    EXPECT_EQ(usual.is_known(n), !asked) << declared_figures()[n].name;
    EXPECT_EQ(usual.at(n), asked ? std::nullopt : all.at(n)) << declared_figures()[n].name;
  }
  EXPECT_EQ(on_request, 14U);
}

TEST(Measurement, StopsWhenCancelled) {
  TriangleMesh mesh = torus_mesh();
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(measure(mesh, torus_surface(), SizingField(1.5), monitor), Cancelled);
}

// By hand, so that a figure that is no longer declared is noticed.
TEST(Measurement, HasTheFiguresOfTheFirstVersions) {
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
                           "boundary_edges",
                           "nonmanifold_edges",
                           "nonmanifold_vertices",
                           "self_intersections",
                           "distance_mean",
                           "distance_max"}) {
    EXPECT_NE(declared_figure(name).column, no_column) << name << " is a column of results.csv";
  }
}

}  // namespace

}  // namespace isobench
