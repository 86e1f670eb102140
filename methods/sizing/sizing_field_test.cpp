#include "isobench/methods/sizing/sizing_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

SizingRequest request() {
  SizingRequest asked;
  asked.epsilon = 0.5;
  asked.delta = 0.3;
  return asked;
}

Isosurface torus() { return Isosurface(sample_phantom(phantom("torus"), 48), 0.0); }

/// Relative differences of two fields' h over the band, sorted.
std::vector<double> differences(const SizingField& a, const SizingField& b) {
  std::vector<double> result;
  for (std::size_t n = 0; n < a.h_nodes().size(); ++n) {
    result.push_back(std::abs(a.h_nodes()[n] / b.h_nodes()[n] - 1.0));
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(SizingStages, TheIterationComesNearTheFastLimiter) {
  const Isosurface surface = torus();
  Monitor monitor;
  const SizingField fast = make_sizing_field(surface, request(), monitor);
  const SizingField slow =
      make_sizing_field(surface, request(), monitor, {MedialAxis::shrinking_balls, Limiter::iteration});
  EXPECT_GT(monitor.counters().at("limiter/passes"), 10.0);
  EXPECT_EQ(fast.h0_nodes(), slow.h0_nodes());
  // The published stop criterion leaves some distance to the fixed point.
  EXPECT_LT(differences(fast, slow).back(), 1e-3);
}

TEST(SizingStages, FootPointsGiveTheSizesOfShrinkingBalls) {
  const Isosurface surface = torus();
  Monitor monitor;
  const SizingField balls = make_sizing_field(surface, request(), monitor);
  const SizingField feet =
      make_sizing_field(surface, request(), monitor, {MedialAxis::foot_points, Limiter::fast_iterative});
  const std::vector<double> apart = differences(feet, balls);
  EXPECT_LT(apart[apart.size() / 2], 0.02);
  EXPECT_GT(apart.back(), 0.0) << "the stage must change something";
}

TEST(SizingStages, NodesThatBoundTheSurfaceGiveSmallerSizesOnIt) {
  const Isosurface surface = torus();
  Monitor monitor;
  const SizingField usual = make_sizing_field(surface, request(), monitor);
  SizingStages stages;
  stages.nodes = SizingNodes::bounding;
  const SizingField bounding = make_sizing_field(surface, request(), monitor, stages);
  EXPECT_LT(bounding.band()->size(), usual.band()->size());
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  double ratio_of_h0 = 0.0;
  double ratio_of_h = 0.0;
  for (const Eigen::Vector3d& x : lattice_mesh.vertices) {
    ratio_of_h0 += bounding.h0(x) / usual.h0(x) / static_cast<double>(lattice_mesh.vertices.size());
    ratio_of_h += bounding.h(x) / usual.h(x) / static_cast<double>(lattice_mesh.vertices.size());
  }
  // λ is linear across the surface, and trilinear interpolation reproduces it. The limiter sees a slope of 1 there.
  EXPECT_NEAR(ratio_of_h0, 1.0, 0.02);
  EXPECT_LT(ratio_of_h, 0.97);
  EXPECT_GT(ratio_of_h, 0.8);
}

TEST(SizingStages, LeaveTheMedialAxisBehindWhereAsked) {
  const Isosurface surface = torus();
  for (const MedialAxis kind : {MedialAxis::shrinking_balls, MedialAxis::foot_points}) {
    Monitor silent;
    make_sizing_field(surface, request(), silent, {kind, Limiter::fast_iterative});
    EXPECT_TRUE(silent.artefacts().empty());
    Monitor keeping;
    keeping.keep_artefacts(true);
    make_sizing_field(surface, request(), keeping, {kind, Limiter::fast_iterative});
    const Artefact& axis = keeping.artefacts().at("medial-axis");
    EXPECT_GT(axis.points.size(), 100U);
    EXPECT_EQ(axis.data.at("radius").size(), axis.points.size());
    const Artefact& sizing = keeping.artefacts().at("sizing");
    EXPECT_EQ(sizing.data.at("h0").size(), sizing.points.size());
    EXPECT_EQ(sizing.data.at("h").size(), sizing.points.size());
  }
}

}  // namespace
}  // namespace isobench
