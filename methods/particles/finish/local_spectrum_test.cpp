#include "isobench/methods/particles/finish/local_spectrum.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::particles {
namespace {

constexpr double equilateral = std::numbers::sqrt3 / 4.0;  // area of a triangle with edges of 1 mm

/// A parallelogram of (n + 1)² vertices in equilateral triangles; the vertices on its border are fixed. `shake` moves
/// each of the others by up to so much.
EditableMesh patch(std::uint32_t n, double shake) {
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      const double angle = 2.4 * (i + 7.0 * j);
      points.emplace_back(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j, 0.0);
      if (inner) points.back() += shake * Eigen::Vector3d(std::cos(angle), std::sin(angle), std::cos(3.0 * angle));
      if (i == n || j == n) continue;
      const std::uint32_t v = j * (n + 1) + i;
      triangles.push_back({v, v + 1, v + n + 1});
      triangles.push_back({v + 1, v + n + 2, v + n + 1});
    }
  }
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::UnitZ());
  return {std::move(points), std::move(normals), triangles};
}

/// The same by a dense eigen-solver and the textbook's formulas: −½ cot at an edge, a third of the area at a vertex.
LocalSpectrum by_dense_solver(const EditableMesh& mesh, double area) {
  const auto count = static_cast<Eigen::Index>(mesh.vertex_count());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(count);
  for (std::uint32_t t = 0; 3 * t < mesh.half_edge_count(); ++t) {
    const Triangle v = mesh.triangle(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
      const Eigen::Vector3d to_a = mesh.points[a] - mesh.points[c], to_b = mesh.points[b] - mesh.points[c];
      const double angle = std::acos(to_a.dot(to_b) / to_a.norm() / to_b.norm());
      const double weight = 0.5 / std::tan(angle);
      stiffness(a, b) -= weight;
      stiffness(b, a) -= weight;
      stiffness(a, a) += weight;
      stiffness(b, b) += weight;
      mass[c] += to_a.norm() * to_b.norm() * std::sin(angle) / 6.0;
    }
  }
  std::vector<Eigen::Index> free;
  for (Eigen::Index v = 0; v < count; ++v) {
    if (mesh.movable(static_cast<std::uint32_t>(v))) free.push_back(v);
  }
  const Eigen::MatrixXd inner = stiffness(free, free);
  const auto largest = [&](const Eigen::VectorXd& diagonal) {
    const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * inner * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  };
  const Eigen::VectorXd free_mass = mass(free);
  return {largest(free_mass) * area / equilateral, largest(inner.diagonal())};
}

TEST(LocalSpectrum, ComesNearTheLatticesOnALargePatch) {
  const EditableMesh mesh = patch(30, 0.0);
  const LocalSpectrum spectrum = local_spectrum(mesh, std::vector<double>(mesh.vertex_count(), equilateral));
  EXPECT_NEAR(spectrum.step_factor, 6.0, 0.15);
  EXPECT_NEAR(spectrum.scaled, 1.5, 0.04);
}

TEST(LocalSpectrum, AgreesWithADenseSolver) {
  for (const double shake : {0.05, 0.2, 0.35}) {
    const EditableMesh mesh = patch(9, shake);
    const double area = 1.7 * equilateral;
    const LocalSpectrum fast = local_spectrum(mesh, std::vector<double>(mesh.vertex_count(), area));
    const LocalSpectrum dense = by_dense_solver(mesh, area);
    EXPECT_NEAR(fast.step_factor / dense.step_factor, 1.0, 0.02) << shake;
    EXPECT_NEAR(fast.scaled / dense.scaled, 1.0, 0.02) << shake;
  }
}

TEST(LocalSpectrum, IsInfiniteWhereATriangleHasNoArea) {
  EditableMesh mesh = patch(3, 0.0);
  mesh.points[5] = mesh.points[6];
  EXPECT_FALSE(std::isfinite(local_spectrum(mesh, std::vector<double>(mesh.vertex_count(), 1.0)).step_factor));
}

}  // namespace
}  // namespace isobench::particles
