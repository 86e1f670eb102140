#include "isobench/datasets/phantoms/phantoms.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "isobench/datasets/phantoms/ellipsoid.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/union_find.h"

namespace isobench {

void PrintTo(const Phantom& p, std::ostream* out) { *out << p.name; }

namespace {

using Eigen::Vector3d;

Vector3d gradient(const Phantom& p, const Vector3d& x) {
  constexpr double h = 1e-4;
  Vector3d g;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = h * Vector3d::Unit(axis);
    g[axis] = (p.function(x + step) - p.function(x - step)) / (2.0 * h);
  }
  return g;
}

struct SurfacePoint {
  Vector3d x;
  Vector3d inward;
};

/// Random points, evenly spread on the surface: points in a thin shell of constant thickness, projected to the surface.
std::vector<SurfacePoint> surface_points(const Phantom& p, std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<SurfacePoint> points;
  while (points.size() < count) {
    Vector3d x = Vector3d(unit(random), unit(random), unit(random)).cwiseProduct(p.half_extent + Vector3d::Ones());
    if (std::abs(p.function(x)) > 1.0) continue;
    for (int step = 0; step < 4; ++step) {
      const Vector3d g = gradient(p, x);
      x -= p.function(x) * g / g.squaredNorm();
    }
    if (std::abs(p.function(x)) < 1e-9) points.push_back({x, gradient(p, x).normalized()});
  }
  return points;
}

/// The centres of the largest balls on both sides that touch the surface at each sample and have no other sample
/// inside: a ball of radius R touching at p passes through q if R = |p − q|²/(2 n·(q − p)).
std::vector<Vector3d> medial_centres(const std::vector<SurfacePoint>& samples, double too_near) {
  const double none = std::numeric_limits<double>::infinity();
  std::vector<Vector3d> centres(2 * samples.size(), Vector3d::Constant(1e9));
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t n) {
    const auto& [x, inward] = samples[n];
    double inner = none;
    double outer = none;
    for (const SurfacePoint& other : samples) {
      const Vector3d d = other.x - x;
      const double squared = d.squaredNorm();
      if (squared < too_near * too_near) continue;
      const double height = 2.0 * inward.dot(d);
      (height > 0.0 ? inner : outer) = std::min(height > 0.0 ? inner : outer, squared / std::abs(height));
    }
    if (inner < none) centres[2 * n] = x + inner * inward;
    if (outer < none) centres[2 * n + 1] = x - outer * inward;
  });
  return centres;
}

class EveryPhantom : public testing::TestWithParam<Phantom> {};
/// The phantoms of which everything is known.
class ClosedForm : public testing::TestWithParam<Phantom> {};

/// The same phantoms with wider gaps, so that samples 0.5–0.8 mm apart find the balls in the gaps.
std::vector<Phantom> widened(std::vector<Phantom> all) {
  for (Phantom& p : all) {
    if (p.name == "thin-sheets") p = phantom(p.name, {{"thickness", 10.0}, {"gap", 8.0}});
    if (p.name == "near-spheres") p = phantom(p.name, {{"gap", 4.0}});
  }
  return all;
}

/// Every pair of 10000 samples: 0.3 s a shape when optimised, but half a minute under sanitizers.
class FeatureSizeByEmptyBalls : public ClosedForm {};

std::vector<Phantom> closed_forms() {
  std::vector<Phantom> known;
  for (const Phantom& p : phantoms()) {
    if (p.feature_size && p.exact_distance && p.area && p.volume) known.push_back(p);
  }
  return known;
}

std::string test_name(const testing::TestParamInfo<Phantom>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST_P(FeatureSizeByEmptyBalls, IsTheDistanceToTheCentresOfEmptyBalls) {
  const Phantom& p = GetParam();
  const auto samples = surface_points(p, 10000);
  const double spacing = std::sqrt(*p.area / static_cast<double>(samples.size()));
  const auto centres = medial_centres(samples, 0.1 * spacing);
  double mean_error = 0.0;
  for (std::size_t n = 0; n < 300; ++n) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3d& c : centres) nearest = std::min(nearest, (c - samples[n].x).norm());
    const double lambda = p.feature_size(samples[n].x);
    // With samples 0.5–0.8 mm apart, balls may be spacing²/(2R) too large and axis points half a spacing off.
    EXPECT_NEAR(nearest / lambda, 1.0, 0.03) << samples[n].x.transpose();
    mean_error += std::abs(nearest / lambda - 1.0) / 300.0;
  }
  EXPECT_LT(mean_error, 0.01);
}

TEST_P(ClosedForm, ExactDistancesHaveUnitGradientsAndReachTheSurface) {
  const Phantom& p = GetParam();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int tried = 0;
  while (tried < 500) {
    const Vector3d x = 1.2 * Vector3d(unit(random), unit(random), unit(random)).cwiseProduct(p.half_extent);
    const double distance = p.function(x);
    const Vector3d g = gradient(p, x);
    // The distance has a crease on the medial axis; a central difference across it is too short.
    if (p.feature_size(x) < 1e-3) continue;
    ++tried;
    EXPECT_NEAR(g.norm(), 1.0, 1e-6) << x.transpose();
    EXPECT_NEAR(p.function(x - distance * g), 0.0, 1e-6) << x.transpose();
  }
}

TEST_P(EveryPhantom, LiesWithinItsHalfExtentAndTouchesIt) {
  const Phantom& p = GetParam();
  Vector3d reach = Vector3d::Zero();
  for (const SurfacePoint& point : surface_points(p, 20000)) reach = reach.cwiseMax(point.x.cwiseAbs());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(reach[axis], p.half_extent[axis] + 1e-6);
    EXPECT_GE(reach[axis], 0.95 * p.half_extent[axis]);
  }
}

/// Volume and area from samples on a fine lattice. The area is the volume of the shell |f| < w divided by 2w. The steps
/// at the shell's borders are softened over one voxel: the flat faces are parallel to the lattice, and a sharp step
/// would count whole layers of nodes.
TEST_P(ClosedForm, AreaAndVolumeAgreeWithSampling) {
  const Phantom& p = GetParam();
  // The shell must not reach the medial axis; else Steiner's formula does not hold.
  const double width = std::min(1.5, 0.6 * p.smallest_feature.value_or(4.0));
  const FloatVolume v = sample_phantom(p, 160, 12);
  const double cell = v.lattice.spacing.prod();
  const double voxel = v.lattice.spacing[0];
  const auto step = [&](double f) { return std::clamp(0.5 + f / voxel, 0.0, 1.0); };
  double volume = 0.0;
  double shell = 0.0;
  for (const double f : v.samples) {
    volume += cell * step(f);
    shell += cell * (step(f + width) - step(f - width));
  }
  // Softening adds voxel²/24 ∫(κ1 + κ2), for the two spheres 3e-4 of the volume.
  EXPECT_NEAR(volume / *p.volume, 1.0, 0.001);
  // Steiner: the shell's volume is 2wA + (2/3)w³∫k1 k2. Gauss and Bonnet: the integral is 2πχ.
  const double bend = 2.0 / 3.0 * width * width * width * 2.0 * std::numbers::pi * p.euler;
  EXPECT_NEAR((shell - bend) / (2.0 * width) / *p.area, 1.0, 0.001);
}

/// χ of the surface and its number of components from the signs on Kuhn's tetrahedra (six a cell, around the diagonal):
/// χ = bichromatic edges − triangles + tetrahedra, and a closed surface separates one region more than it has pieces.
struct Topology {
  long euler = 0;
  long components = 0;
};

Topology kuhn_topology(const FloatVolume& v) {
  const auto& size = v.lattice.size;
  UnionFind regions(v.samples.size());
  const auto mixed = [](std::initializer_list<bool> signs) {
    return std::any_of(signs.begin(), signs.end(), [&](bool s) { return s != *signs.begin(); });
  };
  Topology result;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const auto exists = [&](int c) {
          return i + (c & 1) < size[0] && j + (c >> 1 & 1) < size[1] && k + (c >> 2) < size[2];
        };
        const auto index = [&](int c) { return v.lattice.index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); };
        const auto sign = [&](int c) { return v.samples[index(c)] > 0.0F; };
        // Simplices of Kuhn's triangulation are the chains 0 ⊂ a ⊂ b ⊂ 7 of corner sets that start at this node.
        for (int a = 1; a < 8; ++a) {
          if (!exists(a)) continue;
          if (sign(0) != sign(a)) {
            ++result.euler;
          } else {
            regions.unite(static_cast<std::uint32_t>(index(a)), static_cast<std::uint32_t>(index(0)));
          }
          for (int b = a + 1; b < 8; ++b) {
            if ((a & b) != a || !exists(b)) continue;
            result.euler -= mixed({sign(0), sign(a), sign(b)});
            if (b != 7 && exists(7)) result.euler += mixed({sign(0), sign(a), sign(b), sign(7)});
          }
        }
      }
    }
  }
  for (std::uint32_t n = 0; n < v.samples.size(); ++n) result.components += regions.is_root(n) ? 1 : 0;
  --result.components;
  return result;
}

TEST_P(EveryPhantom, TopologyAgreesWithAnIndependentCount) {
  const Phantom& p = GetParam();
  for (const int nodes : {48, 100}) {
    const Topology counted = kuhn_topology(sample_phantom(p, nodes, 2));
    EXPECT_EQ(counted.euler, p.euler) << nodes;
    EXPECT_EQ(counted.components, p.components) << nodes;
  }
}

TEST_P(EveryPhantom, IsSampledInItsOwnCoordinatesWithItsMargin) {
  const Phantom& p = GetParam();
  const FloatVolume v = sample_phantom(p, 40, 4);
  const Lattice& l = v.lattice;
  EXPECT_EQ(*std::max_element(l.size.begin(), l.size.end()), 40);
  EXPECT_EQ(v.samples.size(), l.nodes());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(l.spacing[axis], l.spacing[0]);
    const double before = (-p.half_extent[axis] - l.origin[axis]) / l.spacing[axis];
    const double after =
        l.size[static_cast<std::size_t>(axis)] - 1 - before - 2.0 * p.half_extent[axis] / l.spacing[axis];
    EXPECT_GE(before, 4.0 - 1e-9);
    EXPECT_GE(after, 4.0 - 1e-9);
    EXPECT_LT(before, 5.0);
    EXPECT_LT(after, 5.0);
  }
  const Vector3d world = l.to_world(l.spacing.cwiseProduct(Vector3d(11, 7, 9)));
  EXPECT_EQ(v.at(11, 7, 9), static_cast<float>(p.function(world)));
}

INSTANTIATE_TEST_SUITE_P(Phantoms, EveryPhantom, testing::ValuesIn(phantoms()), test_name);
INSTANTIATE_TEST_SUITE_P(Phantoms, FeatureSizeByEmptyBalls, testing::ValuesIn(widened(closed_forms())), test_name);
INSTANTIATE_TEST_SUITE_P(Phantoms, ClosedForm, testing::ValuesIn(closed_forms()), test_name);

TEST(Phantoms, AllButTheGyroidBallAndTheVesselTreeHaveClosedForms) {
  EXPECT_EQ(closed_forms().size() + 2, phantoms().size());
}

TEST(Phantoms, AreFoundByName) {
  EXPECT_EQ(phantom("rounded-box").name, "rounded-box");
  try {
    phantom("tours");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("'torus'"), std::string::npos) << error.what();
  }
}

TEST(Phantoms, TooCoarseALatticeIsRefused) { EXPECT_THROW(sample_phantom(phantom("sphere"), 15, 5), UsageError); }

TEST(Phantoms, RoundedBoxFollowsThePapersFormula) {
  const Phantom& p = phantom("rounded-box");
  const double rho = 5.0;
  // On the largest face (z = 12), t inside the flat part's edge x = 17, far from its other edges.
  for (double t = 0.0; t <= 9.0; t += 0.5) {
    const double expected = t <= rho ? std::hypot(rho, t) : (rho + t) / std::sqrt(2.0);
    EXPECT_NEAR(p.feature_size({17.0 - t, 0.0, 12.0}), std::min(expected, 12.0), 1e-12) << t;
  }
  EXPECT_NEAR(p.feature_size({0.0, 0.0, 12.0}), 12.0, 1e-12);  // half the thickness
  const double diagonal = rho / std::sqrt(2.0);
  EXPECT_NEAR(p.feature_size({17.0 + diagonal, 3.0, 7.0 + diagonal}), rho, 1e-12);  // on an edge
  EXPECT_NEAR(p.feature_size(Vector3d(17.0, 12.0, 7.0) + Vector3d::Constant(rho / std::sqrt(3.0))), rho, 1e-12);
}

TEST(Phantoms, TorusTakesItsOuterAxisIntoAccount) {
  const Phantom& p = phantom("torus");
  EXPECT_NEAR(p.feature_size({22.0, 0.0, 0.0}), 8.0, 1e-12);
  EXPECT_NEAR(p.feature_size({6.0, 0.0, 0.0}), 6.0, 1e-12);  // R − r < r
}

TEST(NearestOnEllipsoid, AgreesWithADenseSearchInsideAndOutside) {
  const Eigen::Vector2d axes(5.0, 2.0);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-7.0, 7.0);
  for (int n = 0; n < 200; ++n) {
    Eigen::Vector2d y(unit(random), unit(random));
    if (n % 5 == 0) y[1] = 0.0;
    if (n % 7 == 0) y[0] = 0.0;
    const Eigen::Vector2d x = nearest_on_ellipsoid<2>(axes, y);
    EXPECT_NEAR(x.cwiseQuotient(axes).norm(), 1.0, 1e-12);
    double best = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 20000; ++step) {
      const double angle = step * 2.0 * std::numbers::pi / 20000.0;
      best = std::min(best, (y - Eigen::Vector2d(5.0 * std::cos(angle), 2.0 * std::sin(angle))).norm());
    }
    EXPECT_LE((x - y).norm(), best + 1e-12) << y.transpose();
    EXPECT_GE((x - y).norm(), best - 1e-5) << y.transpose();
  }
}

}  // namespace
}  // namespace isobench
