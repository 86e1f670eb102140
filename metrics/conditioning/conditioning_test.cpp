// Condition numbers against dense solvers, and what conjugate gradients take.
#include "isobench/metrics/conditioning/conditioning.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <cmath>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh/sample_meshes.h"

namespace isobench {
namespace {

FiniteElements elements_to_solve(const TriangleMesh& mesh) { return finite_elements(mesh, sorted_half_edges(mesh)); }

double condition_of(const FiniteElements& e) {
  Monitor monitor;
  return condition(e, screened_system(e), monitor).value();
}

int steps_of(const FiniteElements& e) {
  Monitor monitor;
  return jacobi_steps(screened_system(e), monitor).value();
}

double dense_condition(const FiniteElements& e) {
  const Eigen::MatrixXd a = Eigen::MatrixXd(e.stiffness) + Eigen::MatrixXd(e.mass) * 4.0 * M_PI / e.area;
  const Eigen::VectorXd s = a.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd spectrum =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(s.asDiagonal() * a * s.asDiagonal()).eigenvalues();
  return spectrum[e.size() - 1] / spectrum[0] * e.mean_squared_edge() * 4.0 * M_PI / e.area;
}

TEST(Condition, IsThatOfADenseSolver) {
  TriangleMesh uneven = sample_meshes::torus(12);
  uneven.vertices[7] += Eigen::Vector3d(0.2, -0.1, 0.1);
  TriangleMesh slivers = uneven;
  slivers.vertices[50] = slivers.vertices[51] + 1e-3 * (slivers.vertices[50] - slivers.vertices[51]);
  TriangleMesh speck = sample_meshes::tetrahedron();
  for (Eigen::Vector3d& v : speck.vertices) v *= 1e-3;
  for (const TriangleMesh& mesh :
       {sample_meshes::icosphere(0), sample_meshes::icosphere(3), uneven, slivers, sample_meshes::moebius_strip(20),
        sample_meshes::together(sample_meshes::icosphere(2), speck)}) {
    const FiniteElements e = elements_to_solve(mesh);
    EXPECT_NEAR(condition_of(e) / dense_condition(e), 1.0, 1e-6) << mesh.vertices.size();
  }
}

TEST(Condition, OfARoundMeshTendsTo6) {
  // The 12 vertices of valence 5 and the unequal areas of an icosphere cost a tenth.
  const double fine = condition_of(elements_to_solve(sample_meshes::icosphere(5)));
  EXPECT_GT(fine, 5.9);
  EXPECT_LT(fine, 7.0);
}

TEST(CgIterations, DoubleWithHalfTheEdges) {
  std::vector<int> steps;
  for (const int quartered : {3, 4, 5}) {
    steps.push_back(steps_of(elements_to_solve(sample_meshes::icosphere(quartered))));
  }
  EXPECT_NEAR(static_cast<double>(steps[1]) / steps[0], 2.0, 0.3);
  EXPECT_NEAR(static_cast<double>(steps[2]) / steps[1], 2.0, 0.3);
  // Within the bound ½ √κ ln(2/tolerance) of the theory, and not far below it.
  const FiniteElements e = elements_to_solve(sample_meshes::icosphere(3));
  const double bound = 0.5 * std::log(2e8) * std::sqrt(dense_condition(e) * e.squared_radius() / e.mean_squared_edge());
  EXPECT_LT(steps[0], bound);
  EXPECT_GT(steps[0], bound / 4.0);
}

TEST(CgIterations, AreThoseOfEigensSolver) {
  const FiniteElements e = elements_to_solve(sample_meshes::torus(20));
  SparseMatrix a = e.stiffness + e.mass / e.squared_radius();
  const Eigen::VectorXd s = a.diagonal().cwiseSqrt().cwiseInverse();
  a = scaled(a, s);
  const Eigen::VectorXd b = s.cwiseProduct(random_vector(a.rows(), 1));
  // With ones on the diagonal, Eigen's preconditioner does nothing, and both compare the same residuals.
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(a);
  solver.setTolerance(1e-8);
  const Eigen::VectorXd solution = solver.solve(b);
  EXPECT_NEAR(steps_of(e), static_cast<int>(solver.iterations()), 1) << "rounding";
}

TEST(CgIterations, EndWithoutASolutionToo) {
  SparseMatrix indefinite(2, 2);
  indefinite.insert(0, 0) = indefinite.insert(1, 1) = 1.0;
  indefinite.insert(0, 1) = indefinite.insert(1, 0) = 2.0;
  Monitor monitor;
  EXPECT_EQ(conjugate_gradient_steps(indefinite, Eigen::Vector2d(1.0, -1.0), 1e-8, 100, monitor), std::nullopt);
  EXPECT_EQ(factorized(indefinite), nullptr);
  const SparseMatrix a = screened_system(elements_to_solve(sample_meshes::torus(20))).matrix;
  const Eigen::VectorXd b = random_vector(a.rows(), 1);
  EXPECT_EQ(conjugate_gradient_steps(a, b, 1e-8, 10, monitor), std::nullopt);
  monitor.cancel();
  EXPECT_THROW(conjugate_gradient_steps(a, b, 1e-8, 100, monitor), Cancelled);
}

TEST(CgIterations, SameBitsForAnyNumberOfThreads) {
  const FiniteElements e = elements_to_solve(sample_meshes::torus(60));  // 7,200 vertices: two blocks of a sum
  const auto figures = [&e] { return std::pair(condition_of(e), steps_of(e)); };
  const auto expected = figures();
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(figures(), expected);
  }
}

}  // namespace
}  // namespace isobench
