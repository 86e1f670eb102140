#include "isobench/methods/advancing-front/guidance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench::advancing_front {
namespace {

TEST(AdvancingFrontGuidance, OnASphereIsTheChordOfTheAngleTimesEta) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 48), 0.0);
  Monitor monitor;
  const SizingField field = guidance_field(surface, {}, monitor);
  const auto vertices = marching_cubes(surface, monitor).vertices;
  for (std::size_t n = 0; n < vertices.size(); n += 50) {
    const double bend = curvatures(surface.jet(vertices[n])).max_abs();
    const double tightest = 0.8 * 2.0 * std::sin(0.19634954 / 2.0) / bend;
    // Tolerance: samples nearby may bend more, and the slope 0.2 acts over half a cell's diagonal to either side.
    EXPECT_NEAR(field.h(vertices[n]), tightest, 0.2 * surface.voxel()) << n;
  }
}

TEST(AdvancingFrontGuidance, IsShortWhereTheSurfaceBendsAndGrowsNoFasterThanItsSlope) {
  const Isosurface surface(sample_phantom(phantom("ellipsoid"), 64), 0.0);
  Monitor monitor;
  GuidanceOptions options;
  options.floor = 0.3 * surface.voxel();
  const SizingField field = guidance_field(surface, options, monitor);
  const auto vertices = marching_cubes(surface, monitor).vertices;
  double steepest = 0.0;
  for (std::size_t n = 0; n < vertices.size(); n += 7) {
    const double bend = curvatures(surface.jet(vertices[n])).max_abs();
    const double ideal = std::max(options.floor, 1.6 * std::sin(options.rho / 2.0) / bend);
    EXPECT_LT(field.h(vertices[n]), ideal + 0.2 * surface.voxel());
    for (std::size_t m = n + 7; m < vertices.size(); m += 700) {
      const double away = (vertices[n] - vertices[m]).norm();
      if (away < 2.0 * surface.voxel()) continue;
      steepest = std::max(steepest, std::abs(field.h(vertices[n]) - field.h(vertices[m])) / away);
    }
  }
  EXPECT_LT(steepest, 1.3 * 0.2);  // the discrete limiter reaches 1.3 times its slope between diagonal neighbours
  EXPECT_GT(field.largest(), 2.0 * field.smallest());
}

TEST(AdvancingFrontGuidance, IsTheSameForAnyNumberOfThreads) {
  const Isosurface surface(sample_phantom(phantom("torus"), 40), 0.0);
  std::vector<float> first;
  for (const std::size_t threads : {1U, 3U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Monitor monitor;
    const SizingField field = guidance_field(surface, {}, monitor);
    if (threads == 1U) first = field.h_nodes();
    EXPECT_EQ(field.h_nodes(), first);
  }
}

}  // namespace
}  // namespace isobench::advancing_front
