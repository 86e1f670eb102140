#include "isobench/datasets/isosurface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Samples of a function of lattice-frame millimetres.
FloatVolume sampled(const std::array<int, 3>& size, const Vector3d& spacing,
                    const std::function<double(const Vector3d&)>& function) {
  FloatVolume v;
  v.lattice.size = size;
  v.lattice.spacing = spacing;
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        v.at(i, j, k) = static_cast<float>(function(spacing.cwiseProduct(Vector3d(i, j, k))));
      }
    }
  }
  return v;
}

const Vector3d anisotropic(0.5, 1.25, 2.0);

FloatVolume noise(const std::array<int, 3>& size = {9, 8, 7}) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return sampled(size, anisotropic, [&](const Vector3d&) { return unit(random); });
}

/// Random points in the lattice's box, at least `margin` nodes from its border.
std::vector<Vector3d> points_in(const Lattice& lattice, int margin, int count = 200) {
  std::mt19937_64 random(11);
  std::vector<Vector3d> points;
  for (int n = 0; n < count; ++n) {
    Vector3d x;
    for (int axis = 0; axis < 3; ++axis) {
      std::uniform_real_distribution<double> node(margin, lattice.size[static_cast<std::size_t>(axis)] - 1.0 - margin);
      x[axis] = lattice.spacing[axis] * node(random);
    }
    points.push_back(x);
  }
  return points;
}

/// A quadratic with its derivatives: x'Ax/2 + b'x + c.
struct Quadratic {
  Matrix3d a;
  Vector3d b{0.5, -1.0, 0.25};
  double c = 1.0;
  Quadratic() { a << 0.5, 0.25, -0.125, 0.25, -0.75, 0.5, -0.125, 0.5, 0.25; }
  double operator()(const Vector3d& x) const { return 0.5 * x.dot(a * x) + b.dot(x) + c; }
  Vector3d gradient(const Vector3d& x) const { return a * x + b; }
};

TEST(IsosurfaceTest, BsplineReproducesQuadraticsUpToAConstant) {
  const Quadratic q;
  const Isosurface surface(sampled({12, 10, 9}, anisotropic, q), 0.75);
  // Σ i² β(u − i) = u² + 1/3: each axis adds spacing²/6 times the second derivative.
  const double constant = (anisotropic.cwiseAbs2().array() * q.a.diagonal().array()).sum() / 6.0 - 0.75;
  for (const Vector3d& x : points_in(surface.lattice(), 1)) {
    const Jet jet = surface.jet(x);
    // The samples are floats of up to about 100, whose rounding error is below 1e-5.
    EXPECT_NEAR(jet.value, q(x) + constant, 3e-5);
    EXPECT_LT((jet.gradient - q.gradient(x)).norm(), 1e-4);
    EXPECT_LT((jet.hessian - q.a).norm(), 5e-4);
  }
}

TEST(IsosurfaceTest, BsplineSmoothsCubicsByTheirSecondDerivative) {
  const auto cubic = [](double u) { return 0.02 * u * u * u - 0.3 * u * u + 0.5 * u; };
  const double spacing = 1.5;
  const Isosurface surface(
      sampled({12, 5, 5}, Vector3d::Constant(spacing), [&](const Vector3d& x) { return cubic(x[0]); }), 0.0);
  for (double u = spacing; u <= 10.0 * spacing; u += 0.37) {
    const Jet jet = surface.jet({u, 2.0 * spacing, 2.0 * spacing});
    EXPECT_NEAR(jet.value, cubic(u) + spacing * spacing / 6.0 * (0.12 * u - 0.6), 1e-5);
    EXPECT_NEAR(jet.gradient[0], 0.06 * u * u - 0.6 * u + 0.5 + spacing * spacing / 6.0 * 0.12, 1e-5);
    EXPECT_NEAR(jet.hessian(0, 0), 0.12 * u - 0.6, 1e-5);
  }
}

TEST(IsosurfaceTest, DerivativesAreThoseOfTheValue) {
  const Isosurface surface(noise(), 0.1);
  const double h = 1e-5;
  for (const Vector3d& x : points_in(surface.lattice(), 0)) {
    // Coordinates outside the box are clamped, so differences must stay inside it.
    if ((x.array() < h).any() || ((surface.extent() - x).array() < h).any()) continue;
    const Jet jet = surface.jet(x);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = h * Vector3d::Unit(axis);
      const double slope = (surface.value(x + step) - surface.value(x - step)) / (2.0 * h);
      EXPECT_NEAR(jet.gradient[axis], slope, 1e-6);
      const Vector3d bend =
          (surface.value_gradient(x + step).gradient - surface.value_gradient(x - step).gradient) / (2.0 * h);
      // The third derivative jumps at the cells' borders, where a difference has an error of order h.
      EXPECT_LT((jet.hessian.col(axis) - bend).norm(), 1e-3);
    }
  }
}

TEST(IsosurfaceTest, TheThreeEvaluatorsAgree) {
  for (const Kernel kernel : {Kernel::bspline, Kernel::catmull_rom}) {
    const Isosurface surface(noise(), 0.1, Inside::above, kernel);
    for (const Vector3d& x : points_in(surface.lattice(), 0)) {
      const Jet full = surface.jet(x);
      const Jet first = surface.value_gradient(x);
      EXPECT_NEAR(full.value, surface.value(x), 1e-14);
      EXPECT_NEAR(full.value, first.value, 1e-14);
      EXPECT_LT((full.gradient - first.gradient).norm(), 1e-13);
      EXPECT_EQ(first.hessian, Matrix3d::Zero());
    }
  }
}

TEST(IsosurfaceTest, CatmullRomInterpolatesAndTakesDerivativesOfTheBspline) {
  const FloatVolume volume = noise();
  const Isosurface mixed(volume, 0.1, Inside::above, Kernel::catmull_rom);
  const Isosurface spline(volume, 0.1);
  const Lattice& l = volume.lattice;
  for (int k = 0; k < l.size[2]; ++k) {
    for (int j = 0; j < l.size[1]; ++j) {
      for (int i = 0; i < l.size[0]; ++i) {
        EXPECT_NEAR(mixed.value(l.spacing.cwiseProduct(Vector3d(i, j, k))), volume.at(i, j, k) - 0.1, 1e-6);
      }
    }
  }
  for (const Vector3d& x : points_in(l, 0)) {
    EXPECT_EQ(mixed.jet(x).gradient, spline.jet(x).gradient);
    EXPECT_EQ(mixed.jet(x).hessian, spline.jet(x).hessian);
  }
  const Quadratic q;
  const Isosurface exact(sampled({8, 8, 8}, anisotropic, q), 0.75, Inside::above, Kernel::catmull_rom);
  for (const Vector3d& x : points_in(exact.lattice(), 1)) EXPECT_NEAR(exact.value(x), q(x) - 0.75, 3e-5);
}

TEST(IsosurfaceTest, NodeValuesAreTheValuesAtNodes) {
  for (const Kernel kernel : {Kernel::bspline, Kernel::catmull_rom}) {
    const Isosurface surface(noise(), 0.1, Inside::below, kernel);
    const Lattice& l = surface.lattice();
    std::vector<float> slab(3, 99.0F);  // whatever it held before
    for (int k = 0; k < l.size[2]; ++k) {
      surface.node_values(k, slab);
      ASSERT_EQ(slab.size(), static_cast<std::size_t>(l.size[0] * l.size[1]));
      for (int j = 0; j < l.size[1]; ++j) {
        for (int i = 0; i < l.size[0]; ++i) {
          const double value = surface.value(l.spacing.cwiseProduct(Vector3d(i, j, k)));
          EXPECT_NEAR(slab[l.index(i, j, 0)], value, 2e-7);
        }
      }
    }
  }
}

TEST(IsosurfaceTest, CoefficientsAreSignedAndClampedSamples) {
  const FloatVolume volume = noise();
  const Isosurface below(volume, 0.25, Inside::below);
  EXPECT_FLOAT_EQ(below.coefficient(3, 2, 1), 0.25F - volume.at(3, 2, 1));
  EXPECT_FLOAT_EQ(below.coefficient(-5, 2, 1), 0.25F - volume.at(0, 2, 1));
  EXPECT_FLOAT_EQ(below.coefficient(99, 99, 99), 0.25F - volume.at(8, 7, 6));
}

TEST(IsosurfaceTest, InsideBelowMirrorsTheSign) {
  const FloatVolume volume = noise();
  const Isosurface above(volume, 0.1, Inside::above);
  const Isosurface below(volume, 0.1, Inside::below);
  for (const Vector3d& x : points_in(volume.lattice, 0, 50)) {
    EXPECT_EQ(above.jet(x).value, -below.jet(x).value);
    EXPECT_EQ(above.jet(x).gradient, -below.jet(x).gradient);
    EXPECT_EQ(above.jet(x).hessian, -below.jet(x).hessian);
  }
}

TEST(IsosurfaceTest, TheLatticeFrameKnowsNothingOfOriginAndDirection) {
  FloatVolume plain = noise();
  FloatVolume oblique = plain;
  oblique.lattice.origin = {1e5, -3e4, 77.0};
  oblique.lattice.direction = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  oblique.lattice.direction.col(1) *= -1.0;
  const Isosurface a(plain, 0.1);
  const Isosurface b(oblique, 0.1);
  for (const Vector3d& x : points_in(plain.lattice, 0, 50)) {
    EXPECT_EQ(a.jet(x).value, b.jet(x).value);
    EXPECT_EQ(a.jet(x).gradient, b.jet(x).gradient);
  }
}

TEST(IsosurfaceTest, ProjectionEndsOnTheSurfaceAtTheFoot) {
  const FloatVolume volume = sample_phantom(phantom("sphere"), 48);
  const Lattice lattice = volume.lattice;
  const Isosurface surface(volume, 0.0);
  const double r = 20.0;
  const double moved = r - bspline_shift(1.0 / r, 1.0 / r, surface.voxel());
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 100; ++n) {
    const Vector3d direction = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const double from = r + 2.5 * surface.voxel() * std::sin(n);
    const Vector3d start = lattice.to_local(from * direction);
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const auto foot = surface.project(start, tolerance);
      ASSERT_TRUE(foot.has_value());
      const Jet jet = surface.value_gradient(*foot);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), tolerance * surface.voxel());
    }
    const Vector3d foot = lattice.to_world(*surface.project(start, 1e-9));
    // The shift is known to leading order. The rest is of fourth order, here (voxel/r)³/100 of a voxel.
    EXPECT_NEAR(foot.norm(), moved, 1e-3 * surface.voxel());
    EXPECT_LT((foot.normalized() - direction).norm(), 2e-3);
  }
}

TEST(IsosurfaceTest, ProjectionSaysWhereItFails) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 48), 0.0);
  const Vector3d start = surface.lattice().to_local({20.0 + 4.0 * surface.voxel(), 0.0, 0.0});
  EXPECT_FALSE(surface.project(start, 1e-6, 3).has_value()) << "steps of half a voxel cannot get there in three";
  EXPECT_TRUE(surface.project(start, 1e-6, 20).has_value());
  // A plateau: the gradient vanishes.
  const Isosurface step(sampled({20, 5, 5}, Vector3d::Ones(), [](const Vector3d& x) { return x[0] < 5.0 ? 1.0 : 0.0; }),
                        0.5);
  EXPECT_FALSE(step.project({14.0, 2.0, 2.0}).has_value());
}

TEST(CurvatureTest, SphereTorusAndCylinder) {
  {
    const Isosurface surface(sample_phantom(phantom("sphere"), 64), 0.0);
    const double r = 20.0 - bspline_shift(0.05, 0.05, surface.voxel());
    for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(1, 2, 3), Vector3d(-1, 0.1, -1)}) {
      const auto x = surface.project(surface.lattice().to_local(20.0 * direction.normalized()), 1e-9);
      const Curvatures k = curvatures(surface.jet(*x));
      EXPECT_NEAR(k.k1 * r, 1.0, 2e-3);
      EXPECT_NEAR(k.k2 * r, 1.0, 2e-3);
    }
  }
  {
    const Isosurface surface(sample_phantom(phantom("torus"), 100), 0.0);
    for (double v = 0.0; v < 6.3; v += 0.3) {
      const Vector3d on((14.0 + 8.0 * std::cos(v)) * std::cos(2.0), (14.0 + 8.0 * std::cos(v)) * std::sin(2.0),
                        8.0 * std::sin(v));
      const auto x = surface.project(surface.lattice().to_local(on), 1e-9);
      const Curvatures k = curvatures(surface.jet(*x));
      const double tube = 8.0 - bspline_shift(1.0 / 8.0, std::cos(v) / (14.0 + 8.0 * std::cos(v)), surface.voxel());
      const double ring = std::cos(v) / (14.0 + tube * std::cos(v));
      EXPECT_NEAR(k.k1, 1.0 / tube, 2e-3 / tube) << v;
      EXPECT_NEAR(k.k2, ring, 1e-3) << v;
      EXPECT_EQ(k.max_abs(), std::max(std::abs(k.k1), std::abs(k.k2)));
    }
  }
}

TEST(CurvatureTest, AnisotropicSpacingBendsNothing) {
  // A cylinder along x, and its hollow: the same curvatures with the other sign.
  const Vector3d spacing(2.0, 0.5, 0.8);
  const auto cylinder = [](const Vector3d& x) { return 8.0 - std::hypot(x[1] - 11.0, x[2] - 11.0); };
  for (const Inside inside : {Inside::above, Inside::below}) {
    const Isosurface surface(sampled({6, 45, 28}, spacing, cylinder), 0.0, inside);
    for (double v = 0.0; v < 6.3; v += 0.4) {
      const auto x = surface.project({4.7, 11.0 + 8.0 * std::cos(v), 11.0 + 8.0 * std::sin(v)}, 1e-9);
      const Curvatures k = curvatures(surface.jet(*x));
      const double sign = inside == Inside::above ? 1.0 : -1.0;
      EXPECT_NEAR(inside == Inside::above ? k.k1 : k.k2, sign / 8.0, 0.005 / 8.0);
      EXPECT_NEAR(inside == Inside::above ? k.k2 : k.k1, 0.0, 1e-6);
    }
  }
}

/// The message of the error that the constructor throws; "" if it throws none.
std::string refusal(FloatVolume volume, double isovalue) {
  try {
    const Isosurface surface(std::move(volume), isovalue);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(IsosurfaceErrorTest, AnIsovalueOutsideTheRangeIsToldTheRange) {
  const FloatVolume ramp = sampled({6, 6, 6}, Vector3d::Ones(), [](const Vector3d& x) { return 10.0 + x[0]; });
  for (const double isovalue : {9.0, 16.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string message = refusal(ramp, isovalue);
    EXPECT_TRUE(contains(message, "10") && contains(message, "15")) << message;
  }
}

TEST(IsosurfaceTest, AnotherIsovalueMovesTheSurface) {
  for (const Inside inside : {Inside::above, Inside::below}) {
    Isosurface surface(noise(), 0.1, inside);
    const Isosurface other(noise(), 0.3, inside);
    surface.move_isovalue(0.3);
    EXPECT_EQ(surface.isovalue(), 0.3);
    for (double x = 0.5; x < 5.0; x += 0.7) EXPECT_NEAR(surface.value({x, 3.2, 2.9}), other.value({x, 3.2, 2.9}), 1e-6);
  }
}

TEST(IsosurfaceErrorTest, ANodeThatIsNotFiniteIsNamed) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    FloatVolume volume = noise();
    volume.at(3, 4, 5) = bad;
    const std::string message = refusal(volume, 0.1);
    EXPECT_TRUE(contains(message, "(3, 4, 5)")) << message;
  }
}

TEST(IsosurfaceTest, SamplesOfEveryTypeGiveTheSurfaceOfTheirFloats) {
  Volume bytes;
  bytes.lattice.size = {9, 8, 7};
  std::vector<std::uint8_t> samples;
  for (std::size_t n = 0; n < bytes.lattice.nodes(); ++n) samples.push_back(static_cast<std::uint8_t>(n * n % 251));
  bytes.samples = samples;
  for (const Kernel kernel : {Kernel::bspline, Kernel::interpolating_bspline}) {
    const Isosurface surface(bytes, 100.5, Inside::above, kernel);
    const Isosurface of_floats(as_float(bytes), 100.5, Inside::above, kernel);
    const Isosurface of_shorts({bytes.lattice, std::vector<std::int16_t>(samples.begin(), samples.end())}, 100.5,
                               Inside::above, kernel);
    for (const Vector3d& x : points_in(bytes.lattice, 0, 50)) {
      EXPECT_EQ(surface.value(x), of_floats.value(x));
      EXPECT_EQ(surface.value(x), of_shorts.value(x));
    }
  }
}

TEST(IsosurfaceErrorTest, FewerThanFourNodesAreTooFew) {
  const std::string message = refusal(noise({9, 3, 7}), 0.1);
  EXPECT_TRUE(contains(message, "9×3×7") && contains(message, "4")) << message;
}

// Also along the lattice's border, where the spline repeats the outermost coefficients. 3e-6: coefficients are floats.
TEST(IsosurfaceTest, InterpolatingBsplinePassesThroughTheSamples) {
  FloatVolume volume;
  volume.lattice.size = {9, 7, 6};
  volume.lattice.spacing = {1.0, 0.5, 2.0};
  for (std::size_t n = 0; n < volume.lattice.nodes(); ++n) {
    volume.samples.push_back(static_cast<float>(std::sin(1.7 * static_cast<double>(n * n % 101))));
  }
  const Isosurface surface(volume, 0.0, Inside::above, Kernel::interpolating_bspline);
  std::vector<float> given;
  for (int k = 0; k < 6; ++k) {
    surface.sample_values(k, given);
    for (int j = 0; j < 7; ++j) {
      for (int i = 0; i < 9; ++i) {
        const Eigen::Vector3d node = volume.lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
        EXPECT_NEAR(surface.value(node), volume.at(i, j, k), 3e-6);
        EXPECT_NEAR(given[volume.lattice.index(i, j, 0)], volume.at(i, j, k), 3e-6);
      }
    }
  }
}

}  // namespace
}  // namespace isobench
