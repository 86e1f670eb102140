// Simulated patterns, against dense arithmetic, linear theory and the limits of stability.
#include "isobench/metrics/reaction_diffusion/reaction_diffusion.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/finite_elements/step_factor.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

FiniteElements elements_for(const TriangleMesh& mesh) { return finite_elements(mesh, sorted_half_edges(mesh)); }

/// The largest eigenvalue of M⁻¹K.
double largest_of(const FiniteElements& elements) {
  Monitor monitor;
  return step_factor(elements, Eigen::VectorXd::Ones(elements.size()), monitor).value();
}

TEST(ReactionDiffusion, AStepIsThatOfDenseMatrices) {
  const TriangleMesh mesh = sample_meshes::torus(9);
  const FiniteElements e = elements_for(mesh);
  const SpotPattern pattern{1.3};
  const Concentrations first = first_concentrations(mesh.vertices, pattern);
  const double step = 0.5 * pattern.largest_step(largest_of(e));
  const Eigen::MatrixXd laplacian = -(e.lumped_mass.cwiseInverse().asDiagonal() * Eigen::MatrixXd(e.stiffness));
  Eigen::VectorXd u = first.row(0), v = first.row(1);
  for (int n = 0; n < 5; ++n) {
    const Eigen::VectorXd turned = u.cwiseAbs2().cwiseProduct(v);
    const Eigen::VectorXd du = pattern.diffusion() * laplacian * u - u + turned;
    const Eigen::VectorXd dv = 20.0 * pattern.diffusion() * laplacian * v - turned;
    u += step * (du + Eigen::VectorXd::Constant(u.size(), 0.1));
    v += step * (dv + Eigen::VectorXd::Constant(v.size(), 0.9));
  }
  Monitor monitor;
  const March end = march(e, pattern, first, step, 5, monitor);
  EXPECT_EQ(end.steps, 5U);
  EXPECT_FALSE(end.blew_up);
  EXPECT_LT((end.concentrations.row(0).transpose() - u).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((end.concentrations.row(1).transpose() - v).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ReactionDiffusion, AnEvenMixtureStaysEven) {
  const FiniteElements e = elements_for(sample_meshes::icosphere(3));
  const SpotPattern pattern{1.0};
  Concentrations even(2, e.size());
  even.row(0).setConstant(1.0);
  even.row(1).setConstant(0.9);
  Monitor monitor;
  const March end = march(e, pattern, even, 0.9 * pattern.largest_step(largest_of(e)), 50, monitor);
  EXPECT_LT((end.concentrations - even).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(ReactionDiffusion, SmallWavesGrowAsLinearTheorySays) {
  // On the unit sphere z(5z² − 3) is an eigenfunction of −Δ with eigenvalue 12. With the wavelength 2π/√12 it is the
  // wave that grows fastest, by e^(5/19 t).
  const TriangleMesh mesh = sample_meshes::icosphere(5);
  const FiniteElements e = elements_for(mesh);
  const SpotPattern pattern{2.0 * M_PI / std::sqrt(12.0)};
  Eigen::VectorXd wave(e.size());
  for (Eigen::Index i = 0; i < e.size(); ++i) {
    const double z = mesh.vertices[static_cast<std::size_t>(i)].z();
    wave[i] = z * (5.0 * z * z - 3.0);
  }
  // The eigenvector of (0.8 − 9/38, 1; −1.8, −1 − 20·9/38) for 5/19.
  const double of_v = 5.0 / 19.0 - 0.8 + 9.0 / 38.0;
  Concentrations first(2, e.size());
  first.row(0) = (Eigen::VectorXd::Ones(e.size()) + 1e-5 * wave).transpose();
  first.row(1) = (0.9 * Eigen::VectorXd::Ones(e.size()) + of_v * 1e-5 * wave).transpose();
  const double step = 0.5 * pattern.largest_step(largest_of(e));
  const auto steps = static_cast<std::size_t>(std::ceil(4.0 / step));
  Monitor monitor;
  const March end = march(e, pattern, first, step, steps, monitor);
  const Eigen::VectorXd u = end.concentrations.row(0).transpose() - Eigen::VectorXd::Ones(e.size());
  const double growth = wave.dot(e.lumped_mass.cwiseProduct(u)) / wave.dot(e.lumped_mass.cwiseProduct(wave)) / 1e-5;
  EXPECT_NEAR(std::log(growth) / (static_cast<double>(steps) * step), 5.0 / 19.0, 2e-3);  // h² = 2e-3
}

TEST(ReactionDiffusion, SpotsFormAndStayBelowFour) {
  const TriangleMesh mesh = sample_meshes::icosphere(4);
  const FiniteElements e = elements_for(mesh);
  const SpotPattern pattern{0.5};
  const double step = 0.9 * pattern.largest_step(largest_of(e));
  Monitor monitor;
  const March end = march(e, pattern, first_concentrations(mesh.vertices, pattern), step,
                          static_cast<std::size_t>(SpotPattern::duration / step), monitor);
  EXPECT_FALSE(end.blew_up);
  EXPECT_GT(end.concentrations.row(0).maxCoeff(), 2.0);
  EXPECT_LT(end.concentrations.row(0).maxCoeff(), 4.0);
  EXPECT_LT(end.concentrations.row(0).minCoeff(), 0.6);
}

/// A sphere with one triangle that is nearly flat: its corner `apex` is close to the middle of the opposite edge.
TriangleMesh sphere_with_a_sliver(std::uint32_t& apex, int quartered = 4) {
  TriangleMesh mesh = sample_meshes::icosphere(quartered);
  const Triangle t = mesh.triangles[700];
  apex = t[0];
  mesh.vertices[apex] = 0.03 * mesh.vertices[apex] + 0.485 * (mesh.vertices[t[1]] + mesh.vertices[t[2]]);
  return mesh;
}

TEST(ReactionDiffusion, BlowsUpAtTheSliverAboveItsStepAndNotBelow) {
  std::uint32_t apex = 0;
  const TriangleMesh mesh = sphere_with_a_sliver(apex);
  const FiniteElements e = elements_for(mesh);
  const SpotPattern pattern{0.5};
  const Concentrations first = first_concentrations(mesh.vertices, pattern);
  const double longest = pattern.largest_step(largest_of(e));
  Monitor monitor;
  EXPECT_FALSE(march(e, pattern, first, 0.99 * longest, 2000, monitor).blew_up);
  const March above = march(e, pattern, first, 1.1 * longest, 2000, monitor);
  EXPECT_TRUE(above.blew_up);
  EXPECT_LT(above.steps, 2000U);
  EXPECT_LT((mesh.vertices[static_cast<std::size_t>(above.worst)] - mesh.vertices[apex]).norm(), 0.15);
}

/// An icosphere on the surface of ball(), with or without a sliver.
TriangleMesh sphere_of(TriangleMesh mesh) {
  for (Eigen::Vector3d& v : mesh.vertices) v = 12.0 * v + Eigen::Vector3d::Constant(20.0);
  return mesh;
}

TEST(ReactionDiffusion, MeasuresHowManyStepsAMeshNeedsAndWhereItBlowsUp) {
  const Isosurface surface = ball();
  Monitor monitor;
  TriangleMesh good = sphere_of(sample_meshes::icosphere(5));
  const Measurement m = measure(good, {.surface = &surface}, monitor);
  EXPECT_LT(m.number("step_factor"), 12.0);
  EXPECT_EQ(m.figure("pattern_steps_done"), m.figure("pattern_steps"));
  EXPECT_EQ(m.figure("pattern_stable_percent"), 100.0);
  EXPECT_EQ(m.figure("blow_up_step"), std::nullopt);
  EXPECT_EQ(good.vertex_data.count("blow_up"), 0U);
  EXPECT_GT(monitor.seconds("reaction_diffusion/spots"), 0.0);
  // T (20 D λ + 16)/1.8, with D = (L/10)² 9/(38 · 4π²) and L the ball's radius.
  const double h2 = 4.0 / std::sqrt(3.0) * m.number("area") / m.number("triangles");
  const double diffusion = 9.0 / 38.0 * std::pow(11.97 / 10.0 / (2.0 * M_PI), 2);
  EXPECT_NEAR(
      m.number("pattern_steps") / (24.0 * (20.0 * diffusion * m.number("step_factor") / h2 + 16.0) / (2.0 * 0.9)), 1.0,
      0.01);

  std::uint32_t apex = 0;
  TriangleMesh bad = sphere_of(sphere_with_a_sliver(apex, 5));
  const Measurement of_bad = measure(bad, {.surface = &surface}, monitor);
  EXPECT_GT(of_bad.number("pattern_steps"), 2.0 * m.number("pattern_steps"));
  EXPECT_EQ(of_bad.figure("pattern_steps_done"), of_bad.figure("pattern_steps"));
  EXPECT_LT(of_bad.number("pattern_stable_percent"), 50.0);
  const Eigen::Vector3d place(of_bad.number("blow_up_x"), of_bad.number("blow_up_y"), of_bad.number("blow_up_z"));
  EXPECT_LT((place - bad.vertices[apex]).norm(), 2.0);
  double largest = 0.0;
  for (const double v : bad.vertex_data.at("blow_up")) largest = std::max(largest, std::abs(v));
  EXPECT_GT(largest, 100.0);
  // The pattern is the surface's: where the meshes agree, it is the same.
  const std::vector<double>& spots = good.vertex_data.at("spots");
  const std::vector<double>& of_bad_spots = bad.vertex_data.at("spots");
  double difference = 0.0;
  for (std::size_t v = 0; v < spots.size(); ++v) difference += std::abs(spots[v] - of_bad_spots[v]);
  EXPECT_LT(difference / static_cast<double>(spots.size()), 0.05);
}

TEST(ReactionDiffusion, TooManyStepsAreCountedAndNotDone) {
  const Isosurface surface = ball();
  std::uint32_t apex = 0;
  TriangleMesh mesh = sphere_with_a_sliver(apex);
  const Triangle t = mesh.triangles[700];
  mesh.vertices[apex] = 1e-4 * mesh.vertices[apex] + 0.49995 * (mesh.vertices[t[1]] + mesh.vertices[t[2]]);
  mesh = sphere_of(mesh);
  Monitor monitor;
  const Measurement m = measure(mesh, {.surface = &surface}, monitor);
  EXPECT_GT(m.number("pattern_steps") * (2562.0 + 10000.0), 1.4e9);
  EXPECT_EQ(m.figure("pattern_steps_done"), 0.0);
  EXPECT_EQ(mesh.vertex_data.count("spots"), 0U);
  EXPECT_EQ(mesh.vertex_data.count("blow_up"), 1U);
}

TEST(ReactionDiffusion, CanBeCancelled) {
  const TriangleMesh mesh = sample_meshes::icosphere(2);
  const SpotPattern pattern{0.5};
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(march(elements_for(mesh), pattern, first_concentrations(mesh.vertices, pattern), 1e-6, 10, monitor),
               Cancelled);
}

TEST(ReactionDiffusion, SameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = sample_meshes::icosphere(4);  // three blocks of rows
  const FiniteElements e = elements_for(mesh);
  const SpotPattern pattern{0.5};
  const double step = 1.5 * pattern.largest_step(largest_of(e));
  const auto result = [&] {
    Monitor monitor;
    const March end = march(e, pattern, first_concentrations(mesh.vertices, pattern), step, 300, monitor);
    return std::tuple(end.steps, end.worst, end.blew_up, Eigen::MatrixXd(end.concentrations));
  };
  const auto expected = result();
  EXPECT_TRUE(std::get<2>(expected));
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(result(), expected);
  }
}

}  // namespace
}  // namespace isobench
