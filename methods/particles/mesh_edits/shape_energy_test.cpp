#include "isobench/methods/particles/mesh_edits/shape_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace isobench::particles {
namespace {

/// A fan of `size` triangles that is neither regular nor flat.
Ring uneven_ring(std::size_t size) {
  Ring ring;
  ring.size = size;
  for (std::size_t k = 0; k < size; ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size);
    const double radius = 1.0 + 0.25 * std::sin(3.0 * static_cast<double>(k) + 1.0);
    ring.points[k] = {radius * std::cos(angle), radius * std::sin(angle), 0.1 * std::cos(2.0 * static_cast<double>(k))};
    ring.normals[k] = Eigen::Vector3d::UnitZ();
    ring.areas[k] = 0.5 + 0.1 * std::cos(static_cast<double>(k));
  }
  ring.points[size] = ring.points[0];
  ring.normals[size] = ring.normals[0];
  ring.areas[size] = ring.areas[0];
  ring.area = 0.6;
  return ring;
}

TEST(RadiusRatio, IsOneForEquilateralAndZeroWithoutArea) {
  EXPECT_NEAR(radius_ratio({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1.0, 1e-14);
  EXPECT_NEAR(radius_ratio({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0.0, 1e-14);
  // 3-4-5: r = 1, R = 2.5.
  EXPECT_NEAR(radius_ratio({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 0.8, 1e-14);
}

TEST(ShapeEnergy, HasTheDerivativesOfItsValue) {
  const Eigen::Vector3d n = Eigen::Vector3d(0.2, -0.3, 1.0).normalized();
  const Eigen::Vector3d u = n.unitOrthogonal();
  const Eigen::Vector3d v = n.cross(u);
  const Eigen::Vector3d x(0.11, -0.07, 0.05);
  constexpr double step = 1e-4;
  for (const int doublings : {0, 1, 2}) {
    const ShapeEnergy energy{doublings + 1, doublings, 0.7};
    for (const std::size_t size : {3U, 5U, 6U, 9U}) {
      const Ring ring = uneven_ring(size);
      const EnergyJet jet = shape_energy(energy, ring, x, u, v);
      const auto value = [&](double s, double t) { return fan_state(energy, ring, x + s * u + t * v, n).energy; };
      const double scale = std::abs(jet.value) * (1 << doublings);
      EXPECT_NEAR(jet.value, value(0, 0), 1e-10 * scale);
      // The error of central differences is step² times third and fourth derivatives, which grow like p³ and p⁴.
      const double tolerance = 1e-5 * scale * std::pow(4.0, doublings);
      EXPECT_NEAR(jet.gradient[0], (value(step, 0) - value(-step, 0)) / (2 * step), tolerance);
      EXPECT_NEAR(jet.gradient[1], (value(0, step) - value(0, -step)) / (2 * step), tolerance);
      const double uu = (value(step, 0) - 2 * value(0, 0) + value(-step, 0)) / (step * step);
      const double vv = (value(0, step) - 2 * value(0, 0) + value(0, -step)) / (step * step);
      const double uv =
          (value(step, step) - value(step, -step) - value(-step, step) + value(-step, -step)) / (4 * step * step);
      EXPECT_NEAR(jet.hessian(0, 0), uu, 100 * tolerance);
      EXPECT_NEAR(jet.hessian(1, 1), vv, 100 * tolerance);
      EXPECT_NEAR(jet.hessian(0, 1), uv, 100 * tolerance);
    }
  }
}

/// A regular hexagon of equilateral triangles with area 1, flat.
Ring even_ring() {
  Ring ring;
  ring.size = 6;
  const double edge = std::sqrt(4.0 / std::numbers::sqrt3);
  for (std::size_t k = 0; k <= 6; ++k) {
    const double angle = std::numbers::pi / 3.0 * static_cast<double>(k);
    ring.points[k] = {edge * std::cos(angle), edge * std::sin(angle), 0.0};
    ring.normals[k] = Eigen::Vector3d::UnitZ();
    ring.areas[k] = 1.0;
  }
  return ring;
}

TEST(ShapeEnergy, IsLeastForEquilateralTrianglesOfTheAreasAsked) {
  const ShapeEnergy energy{5, 4, 0.04};
  const auto jet_of = [&](const Ring& ring, const Eigen::Vector3d& x) {
    return shape_energy(energy, ring, x, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  };
  Ring ring = even_ring();
  const EnergyJet even = jet_of(ring, Eigen::Vector3d::Zero());
  EXPECT_NEAR(even.value, 6.0 * (1.0 + 2.0 * 0.04), 1e-12);
  EXPECT_NEAR(even.gradient.norm(), 0.0, 1e-12);
  EXPECT_GT(jet_of(ring, {0.1, 0.0, 0.0}).value, even.value);
  // Larger triangles asked for on the right: the vertex should move to the left, which makes those larger.
  ring.areas[0] = ring.areas[6] = 1.5;
  EXPECT_GT(jet_of(ring, Eigen::Vector3d::Zero()).gradient[0], 0.0);
}

TEST(ShapeEnergy, WithoutWeightDoesNotSeeAreas) {
  const ShapeEnergy energy{5, 4, 0.0};
  Ring ring = even_ring();
  const auto value = [&] { return fan_state(energy, ring, {0.1, 0.2, 0.0}, Eigen::Vector3d::UnitZ()).energy; };
  const double before = value();
  ring.areas.fill(3.0);
  EXPECT_EQ(value(), before);
}

TEST(NewtonStep, IsExactWhereTheHessianIsPositiveAndDescendsElsewhere) {
  EnergyJet jet;
  jet.gradient = {1.0, -2.0};
  jet.hessian << 3.0, 1.0, 1.0, 2.0;
  EXPECT_NEAR((newton_step(jet) + jet.hessian.inverse() * jet.gradient).norm(), 0.0, 1e-13);
  jet.hessian << 1.0, 3.0, 3.0, -2.0;
  EXPECT_LT(newton_step(jet).dot(jet.gradient), 0.0);
  jet.hessian << 2.0, 0.0, 0.0, 2.0;
  EXPECT_NEAR((newton_step(jet) + jet.gradient / 2.0).norm(), 0.0, 1e-13);
}

TEST(FanState, DetectsAnInvertedTriangle) {
  const Ring ring = uneven_ring(6);
  EXPECT_GT(fan_state(ShapeEnergy{}, ring, {0, 0, 0}, Eigen::Vector3d::UnitZ()).least_cosine, 0.8);
  EXPECT_LT(fan_state(ShapeEnergy{}, ring, {3, 0, 0}, Eigen::Vector3d::UnitZ()).least_cosine, 0.0);
}

}  // namespace
}  // namespace isobench::particles
