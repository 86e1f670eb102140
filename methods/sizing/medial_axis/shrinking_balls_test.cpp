#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/datasets/phantoms/vessel_tree.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

/// λ estimated on the surface of a phantom that is sampled with `nodes` nodes along its longest axis.
struct Estimate {
  Isosurface surface;
  SurfaceSamples samples;
  FeatureSize feature_size;

  Estimate(const Phantom& shape, int nodes) : Estimate(Isosurface(sample_phantom(shape, nodes), 0.0)) {}

 private:
  explicit Estimate(Isosurface made) : Estimate(std::move(made), Monitor()) {}
  Estimate(Isosurface made, Monitor&& monitor)
      : surface(std::move(made)),
        samples(surface_samples(surface, marching_cubes(surface, monitor).vertices)),
        feature_size(shrinking_balls(samples, surface.voxel(), 0.5 * surface.extent().minCoeff(), monitor),
                     surface.voxel()) {}
};

struct Errors {
  double median = 0.0;
  double p95 = 0.0;
};

Errors quantiles(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors[errors.size() * 95 / 100]};
}

struct Case {
  std::string phantom;
  int nodes;  // along the longest axis; the resolution at which the tolerances hold
};

class FeatureSizeOfPhantom : public testing::TestWithParam<Case> {};

// The tolerances are those that the project claims: 2 % for the median and 5 % for the 95th percentile.
TEST_P(FeatureSizeOfPhantom, AgreesWithTheClosedForm) {
  const Phantom& shape = phantom(GetParam().phantom);
  ASSERT_TRUE(shape.feature_size);
  const Estimate estimate(shape, GetParam().nodes);
  const double cap = 0.5 * estimate.surface.extent().minCoeff();
  std::vector<double> errors;
  for (const Eigen::Vector3d& x : estimate.samples.points) {
    const double truth = std::min(cap, shape.feature_size(estimate.surface.lattice().to_world(x)));
    errors.push_back(std::abs(estimate.feature_size(x) / truth - 1.0));
  }
  const Errors found = quantiles(errors);
  RecordProperty("median", std::to_string(found.median));
  RecordProperty("p95", std::to_string(found.p95));
  EXPECT_LE(found.median, 0.02) << "of " << errors.size() << " samples";
  EXPECT_LE(found.p95, 0.05) << "of " << errors.size() << " samples";
}

INSTANTIATE_TEST_SUITE_P(Phantoms, FeatureSizeOfPhantom,
                         testing::Values(Case{"sphere", 64}, Case{"torus", 96}, Case{"ellipsoid", 128},
                                         Case{"slab", 96}, Case{"two-spheres", 128}, Case{"capsule", 96},
                                         Case{"rounded-box", 96}, Case{"thin-sheets", 128}, Case{"near-spheres", 128}),
                         [](const auto& chosen) {
                           std::string name = chosen.param.phantom + "_" + std::to_string(chosen.param.nodes);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(FeatureSizeOfPhantoms, EveryPhantomWithAClosedFormIsTested) {
  std::vector<std::string> known;
  for (const Phantom& shape : phantoms()) {
    if (shape.feature_size) known.push_back(shape.name);
  }
  EXPECT_EQ(known, (std::vector<std::string>{"sphere", "torus", "ellipsoid", "slab", "two-spheres", "capsule",
                                             "rounded-box", "thin-sheets", "near-spheres"}));
}

// Near the tips of the last branches, the nearest part of the axis is in the branch itself, so λ is its radius.
TEST(FeatureSizeOfPhantoms, OfTheVesselTreeIsTheRadiusOfItsTips) {
  const Phantom& shape = phantom("vessel-tree");
  const Estimate estimate(shape, 128);
  const std::vector<VesselSegment>& tree = vessel_tree();
  std::vector<double> errors;
  double smallest = 100.0;
  for (const Eigen::Vector3d& x : estimate.samples.points) {
    const Eigen::Vector3d world = estimate.surface.lattice().to_world(x);
    for (int n = 0; n < static_cast<int>(tree.size()); ++n) {
      if (std::any_of(tree.begin(), tree.end(), [n](const VesselSegment& s) { return s.parent == n; })) continue;
      const VesselSegment& s = tree[static_cast<std::size_t>(n)];
      const double along = (world - s.from).dot(s.to - s.from) / (s.to - s.from).squaredNorm();
      const double across = (world - s.from - along * (s.to - s.from)).norm();
      if (along < 0.8 || along > 0.95 || across > s.radius_from) continue;
      errors.push_back(std::abs(estimate.feature_size(x) / across - 1.0));
      smallest = std::min(smallest, estimate.feature_size(x));
    }
  }
  ASSERT_GT(errors.size(), 500U);
  const Errors found = quantiles(errors);
  EXPECT_LE(found.median, 0.02) << "of " << errors.size() << " samples";
  EXPECT_LE(found.p95, 0.05) << "of " << errors.size() << " samples";
  // At 95 % of the length, the taper still adds 0.03 mm to the smallest radius, and the spline reduces the radius by
  // about as much, voxel²/(6r).
  EXPECT_NEAR(smallest, *shape.smallest_radius, 0.05);
}

// There is no closed form. The reference is the same shape on a lattice twice as fine.
TEST(FeatureSizeOfPhantoms, GyroidBallAgreesWithATwiceRefinedReference) {
  const Phantom& shape = phantom("gyroid-ball");
  const Estimate coarse(shape, 128);
  const Estimate fine(shape, 256);
  std::vector<double> errors;
  for (const Eigen::Vector3d& x : coarse.samples.points) {
    const Eigen::Vector3d world = coarse.surface.lattice().to_world(x);
    const auto foot = fine.surface.project(fine.surface.lattice().to_local(world));
    ASSERT_TRUE(foot);
    errors.push_back(std::abs(coarse.feature_size(x) / fine.feature_size(*foot) - 1.0));
  }
  const Errors found = quantiles(errors);
  EXPECT_LE(found.median, 0.02) << "of " << errors.size() << " samples";
  EXPECT_LE(found.p95, 0.05) << "of " << errors.size() << " samples";
}

TEST(SurfaceSamples, LieOnTheSurfaceAndApart) {
  const Estimate estimate(phantom("torus"), 48);
  const double voxel = estimate.surface.voxel();
  ASSERT_GT(estimate.samples.points.size(), 1000U);
  for (std::size_t n = 0; n < estimate.samples.points.size(); ++n) {
    const Jet jet = estimate.surface.value_gradient(estimate.samples.points[n]);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-9 * voxel);
    for (std::size_t m = 0; m < n; ++m) {
      ASSERT_GE((estimate.samples.points[n] - estimate.samples.points[m]).norm(), 0.1 * voxel);
    }
  }
}

TEST(ShrinkingBalls, AreEmptyAndTouchTheirSample) {
  const Estimate estimate(phantom("capsule"), 40);
  Monitor monitor;
  const MedialBalls balls = shrinking_balls(estimate.samples, estimate.surface.voxel(), 50.0, monitor);
  ASSERT_EQ(balls.radii.size(), 2 * estimate.samples.points.size());
  for (std::size_t b = 0; b < balls.radii.size(); ++b) {
    double nearest = 1e300;
    for (const Eigen::Vector3d& x : estimate.samples.points) {
      nearest = std::min(nearest, (x - balls.centres[b]).norm());
    }
    EXPECT_NEAR(nearest, balls.radii[b], 1e-5 * balls.radii[b]);
    EXPECT_NEAR((estimate.samples.points[b / 2] - balls.centres[b]).norm(), balls.radii[b], 1e-9);
  }
}

}  // namespace
}  // namespace isobench
