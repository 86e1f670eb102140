// Step factors against lattices, dense solvers and the sphere.
#include "isobench/metrics/time_step/time_step.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"

namespace isobench {
namespace {

FiniteElements elements_of_mesh(const TriangleMesh& mesh) { return finite_elements(mesh, sorted_half_edges(mesh)); }

/// A patch of the lattice of equilateral triangles with edge length 2.
TriangleMesh hexagonal_lattice(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) mesh.vertices.emplace_back(2.0 * i + j, std::sqrt(3.0) * j, 0.0);
  }
  for (std::uint32_t j = 0; j + 1 < n; ++j) {
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      mesh.triangles.push_back({j * n + i, j * n + i + 1, (j + 1) * n + i});
      mesh.triangles.push_back({j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
    }
  }
  return mesh;
}

double measured(TriangleMesh mesh, const char* figure) {
  Monitor monitor;
  return measure(mesh, MeasuredAgainst{}, monitor).number(figure);
}

TEST(StepFactor, OfTheHexagonalLatticeIs6And24) {
  // Also for a patch: with three colours, so that each triangle has all of them, the function that takes the three cube
  // roots of 1 is an eigenvector of every triangle alone.
  for (const std::uint32_t n : {2U, 3U, 20U}) {
    EXPECT_NEAR(measured(hexagonal_lattice(n), "step_factor"), 6.0, 1e-6) << n;
    EXPECT_NEAR(measured(hexagonal_lattice(n), "step_factor_consistent"), 24.0, 24e-6) << n;
  }
}

TEST(StepFactor, OfARightTriangleByHand) {
  // Legs 1: K = [2 −1 −1; −1 1 0; −1 0 1]/2 has the largest eigenvalue 3/2; lumped mass 1/6; h² = 4/√3 · 1/2.
  const TriangleMesh mesh = sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_NEAR(measured(mesh, "step_factor"), 9.0 * 2.0 / std::sqrt(3.0), 1e-9);
}

/// λmax of K x = λ M x, dense.
double dense_largest(const SparseMatrix& k, const Eigen::MatrixXd& m) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(k), m).eigenvalues()[k.rows() - 1];
}

TEST(StepFactor, IsThatOfADenseSolverForUnequalSizes) {
  TriangleMesh mesh = sample_meshes::torus(9);
  mesh.vertices[7] += Eigen::Vector3d(0.2, -0.1, 0.1);
  mesh.vertices[50] = mesh.vertices[51] + 0.01 * (mesh.vertices[50] - mesh.vertices[51]);  // slivers
  const FiniteElements e = elements_of_mesh(mesh);
  Eigen::VectorXd h(e.size());
  for (Eigen::Index i = 0; i < h.size(); ++i) h[i] = 0.5 + 0.1 * std::sin(0.7 * static_cast<double>(i));
  const Eigen::VectorXd over_h = h.cwiseInverse();
  Monitor monitor;
  const double lumped = dense_largest(
      e.stiffness, (e.lumped_mass.cwiseProduct(over_h).cwiseProduct(over_h)).asDiagonal().toDenseMatrix());
  EXPECT_NEAR(step_factor(e, h, monitor).value() / lumped, 1.0, 1e-6);
  const double consistent =
      dense_largest(e.stiffness, over_h.asDiagonal() * Eigen::MatrixXd(e.mass) * over_h.asDiagonal());
  EXPECT_NEAR(consistent_step_factor(e, h, monitor).value() / consistent, 1.0, 1e-6);
  EXPECT_GT(lumped, 100.0) << "no slivers";
}

TEST(StepFactor, DoesNotDependOnTheUnitOfLength) {
  TriangleMesh mesh = sample_meshes::icosphere(3);
  const double before = measured(mesh, "step_factor");
  EXPECT_GT(before, 6.0);
  EXPECT_LT(before, 12.0);
  for (Eigen::Vector3d& v : mesh.vertices) v *= 1000.0;
  EXPECT_NEAR(measured(mesh, "step_factor"), before, 1e-6);
}

TEST(StepFactor, GrowsWithOneSliverAndEndsWhereItHasNoArea) {
  TriangleMesh mesh = hexagonal_lattice(10);
  // The third corner comes to the middle of the opposite edge: the largest cotangent is 1/height of a unit half edge.
  const std::uint32_t corner = 10 * 9 + 9;
  const Triangle last = mesh.triangles.back();
  ASSERT_EQ(last[1], corner);
  const Eigen::Vector3d middle = 0.5 * (mesh.vertices[last[0]] + mesh.vertices[last[2]]);
  const Eigen::Vector3d outwards = (mesh.vertices[corner] - middle).normalized();
  double before = 6.0;
  for (const double height : {1e-2, 1e-4, 1e-8}) {
    mesh.vertices[corner] = middle + height * outwards;
    const double factor = measured(mesh, "step_factor");
    EXPECT_GT(factor, 10.0 * before) << height;
    before = factor;
  }
  mesh.vertices[corner] = mesh.vertices[last[0]];
  EXPECT_TRUE(std::isnan(measured(mesh, "step_factor")));
  EXPECT_TRUE(std::isnan(measured(mesh, "step_factor_consistent")));
  EXPECT_TRUE(std::isnan(measured(mesh, "condition")));
}

}  // namespace
}  // namespace isobench
