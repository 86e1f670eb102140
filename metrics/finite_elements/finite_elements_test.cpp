// The matrices of linear finite elements, and the eigenvalue and linear solvers, against closed forms and dense
// solvers.
#include "isobench/metrics/finite_elements/finite_elements.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/finite_elements/eigenvalues.h"
#include "isobench/metrics/finite_elements/screened_system.h"

namespace isobench {
namespace {

FiniteElements elements_of(const TriangleMesh& mesh) { return finite_elements(mesh, sorted_half_edges(mesh)); }

TEST(FiniteElements, AHandMadeTriangle) {
  // Right angle at the origin, legs 2 and 1: cotangents 0, 2 and 1/2; area 1.
  const FiniteElements e = elements_of(sample_meshes::mesh({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  Eigen::Matrix3d stiffness;
  stiffness << 1.25, -0.25, -1.0, -0.25, 0.25, 0.0, -1.0, 0.0, 1.0;
  EXPECT_LT((Eigen::Matrix3d(e.stiffness) - stiffness).norm(), 1e-15);
  Eigen::Matrix3d mass;
  mass << 2, 1, 1, 1, 2, 1, 1, 1, 2;
  EXPECT_LT((Eigen::Matrix3d(e.mass) - mass / 12.0).norm(), 1e-15);
  EXPECT_LT((e.lumped_mass - Eigen::Vector3d::Constant(1.0 / 3.0)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(e.area, 1.0);
  EXPECT_DOUBLE_EQ(e.mean_squared_edge(), 4.0 / std::numbers::sqrt3);
  EXPECT_EQ(e.on_border, std::vector<std::uint8_t>(3, 1));
  EXPECT_TRUE(e.regular);
}

/// ∫ ∇φ_i·∇φ_j and ∫ φ_i φ_j triangle by triangle, from the gradients of the basis functions.
struct DenseElements {
  Eigen::MatrixXd stiffness, mass;
  explicit DenseElements(const TriangleMesh& mesh) {
    const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
    stiffness = mass = Eigen::MatrixXd::Zero(n, n);
    for (const Triangle& t : mesh.triangles) {
      Eigen::Matrix3d gradients;
      const auto at = [&](std::size_t c) { return mesh.vertices[t[c % 3]]; };
      const Eigen::Vector3d twice = (at(1) - at(0)).cross(at(2) - at(0));
      for (std::size_t c = 0; c < 3; ++c) {
        gradients.col(static_cast<Eigen::Index>(c)) = twice.cross(at(c + 2) - at(c + 1)) / twice.squaredNorm();
      }
      for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = 0; j < 3; ++j) {
          const double area = 0.5 * twice.norm();
          stiffness(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]) +=
              area * gradients.col(i).dot(gradients.col(j));
          mass(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]) += area / (i == j ? 6.0 : 12.0);
        }
      }
    }
  }
};

TEST(FiniteElements, AreThoseOfTheBasisFunctions) {
  // Closed; with a border; of one side.
  for (const TriangleMesh& mesh :
       {sample_meshes::torus(6), sample_meshes::moebius_strip(9), sample_meshes::icosphere(1)}) {
    const FiniteElements e = elements_of(mesh);
    const DenseElements dense(mesh);
    EXPECT_LT((Eigen::MatrixXd(e.stiffness) - dense.stiffness).norm(), 1e-12);
    EXPECT_LT((Eigen::MatrixXd(e.mass) - dense.mass).norm(), 1e-12);
    EXPECT_LT((e.lumped_mass - dense.mass.rowwise().sum()).norm(), 1e-12);
  }
}

TEST(FiniteElements, KnowTheBorderAndLeaveOutVerticesWithoutTriangles) {
  TriangleMesh mesh = sample_meshes::icosphere(1);
  mesh.vertices.insert(mesh.vertices.begin(), Eigen::Vector3d(9, 9, 9));
  for (Triangle& t : mesh.triangles) t = {t[0] + 1, t[1] + 1, t[2] + 1};
  mesh.triangles.push_back({0, 0, 1});
  const Triangle removed = mesh.triangles.front();
  mesh.triangles.erase(mesh.triangles.begin());
  const FiniteElements e = elements_of(mesh);
  EXPECT_EQ(e.size(), 42);
  EXPECT_EQ(e.vertex.front(), 1U);
  EXPECT_EQ(e.triangles, 79U);
  EXPECT_TRUE(e.regular);
  for (std::uint32_t v = 1; v <= 42; ++v) {
    EXPECT_EQ(e.on_border[v - 1] != 0, v == removed[0] || v == removed[1] || v == removed[2]) << v;
  }
}

TEST(FiniteElements, AreNotRegularWhereATriangleHasNoArea) {
  // Three points of a line; two corners at one place.
  EXPECT_FALSE(elements_of(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})).regular);
  EXPECT_FALSE(elements_of(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}})).regular);
  EXPECT_FALSE(elements_of(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}})).regular);
  EXPECT_TRUE(elements_of(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}}, {{0, 1, 2}})).regular);
}

TEST(FiniteElements, AskedLengthsHaveTheMeshsAreaAndTheAskedRatios) {
  const TriangleMesh mesh = sample_meshes::icosphere(2);
  const FiniteElements e = elements_of(mesh);
  const Eigen::VectorXd uniform = asked_lengths(e, mesh, nullptr);
  const SizingField field(7.0);
  EXPECT_EQ(asked_lengths(e, mesh, &field), uniform);
  EXPECT_NEAR(0.5 * std::numbers::sqrt3 * uniform.squaredNorm(), e.area, 1e-12);
  EXPECT_DOUBLE_EQ(uniform.minCoeff(), uniform.maxCoeff());
}

/// The torus with its vertices moved about, so that no eigenvalue is repeated.
TriangleMesh uneven_torus(std::uint32_t n) {
  TriangleMesh mesh = sample_meshes::torus(n);
  const Eigen::VectorXd noise = random_vector(static_cast<Eigen::Index>(3 * mesh.vertices.size()), 5);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    mesh.vertices[v] += 0.2 / n * noise.segment<3>(static_cast<Eigen::Index>(3 * v));
  }
  return mesh;
}

TEST(LargestEigenvalue, IsThatOfADenseSolver) {
  for (const std::uint32_t n : {4U, 10U, 16U}) {
    const FiniteElements e = elements_of(uneven_torus(n));
    const auto times_k = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(e.stiffness, x, y); };
    const auto over_m = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = x.cwiseQuotient(e.lumped_mass); };
    Monitor monitor;
    const double plain =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(e.stiffness)).eigenvalues()[e.size() - 1];
    const auto found = largest_eigenvalue(e.size(), times_k, nullptr, 1e-7, 1000, monitor);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found / plain, 1.0, 1e-9);
    const double with_mass = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
                                 Eigen::MatrixXd(e.stiffness), Eigen::MatrixXd(e.lumped_mass.asDiagonal()))
                                 .eigenvalues()[e.size() - 1];
    const auto of_pair = largest_eigenvalue(e.size(), times_k, over_m, 1e-7, 1000, monitor);
    ASSERT_TRUE(of_pair);
    EXPECT_NEAR(*of_pair / with_mass, 1.0, 1e-9);
  }
}

TEST(LargestEigenvalue, GivesUpInsteadOfGuessing) {
  Monitor monitor;
  const Eigen::VectorXd diagonal = Eigen::VectorXd::LinSpaced(1000, 1.0, 2.0);
  const auto times_a = [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = diagonal.cwiseProduct(x); };
  EXPECT_EQ(largest_eigenvalue(1000, times_a, nullptr, 1e-7, 10, monitor), std::nullopt);
  EXPECT_NEAR(largest_eigenvalue(1000, times_a, nullptr, 1e-7, 1000, monitor).value_or(0.0), 2.0, 1e-9);
  const auto overflow = [](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = 1e308 * 1e308 * x; };
  EXPECT_EQ(largest_eigenvalue(1000, overflow, nullptr, 1e-7, 1000, monitor), std::nullopt);
  monitor.cancel();
  EXPECT_THROW(largest_eigenvalue(1000, times_a, nullptr, 1e-7, 1000, monitor), Cancelled);
}

TEST(LargestEigenvalue, OfSmallMatrices) {
  Monitor monitor;
  const auto times_a = [](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = 3.0 * x; };
  for (const Eigen::Index size : {1, 2, 3}) {
    EXPECT_NEAR(largest_eigenvalue(size, times_a, nullptr, 1e-7, 100, monitor).value_or(0.0), 3.0, 1e-12);
  }
}

TEST(RitzValues, AreTheEigenvaluesOfTheTridiagonalMatrix) {
  Tridiagonal t;
  Eigen::VectorXd diagonal = random_vector(40, 2);
  Eigen::VectorXd beside = random_vector(40, 3).cwiseAbs() + Eigen::VectorXd::Constant(40, 0.01);
  t.diagonal.assign(diagonal.begin(), diagonal.end());
  t.beside.assign(beside.begin(), beside.end());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense;
  dense.computeFromTridiagonal(diagonal, beside.head(39));
  const Eigen::MatrixXd& vectors = dense.eigenvectors();
  EXPECT_NEAR(t.largest(), dense.eigenvalues()[39], 1e-14);
  EXPECT_NEAR(t.error_of(t.largest()), beside[39] * std::abs(vectors(39, 39)), 1e-10);
}

TEST(FiniteElements, SameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = uneven_torus(60);  // 7,200 vertices, two blocks of ordered_dot()
  const auto result = [&mesh] {
    const FiniteElements e = elements_of(mesh);
    Eigen::VectorXd product;
    const double sum = multiply(screened_system(e).matrix, random_vector(e.size(), 1), product);
    return std::tuple(e.area, sum, product);
  };
  const auto expected = result();
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(result(), expected);
  }
}

}  // namespace
}  // namespace isobench
