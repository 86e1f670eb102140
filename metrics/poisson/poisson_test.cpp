// Finite element solutions against the manufactured one: orders of convergence on surfaces in closed form.
#include "isobench/metrics/poisson/poisson.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/foot_points/known_surfaces.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

struct Errors {
  double max, l2, gradient;
};

template <class JetAt>
Errors errors_on(const TriangleMesh& mesh, JetAt jet) {
  const FiniteElements e = finite_elements(mesh, sorted_half_edges(mesh));
  const auto feet = known_surfaces::feet(mesh.vertices, jet);
  Monitor monitor;
  const PoissonErrors errors = poisson_errors(e, screened_system(e), feet).value();
  return {errors.max, errors.l2,
          gradient_errors(e, mesh, feet, known_surfaces::feet(centroids(mesh), jet)).value().max};
}

void expect_orders(const std::vector<Errors>& errors) {
  for (std::size_t n = 1; n < errors.size(); ++n) {
    EXPECT_NEAR(errors[n - 1].l2 / errors[n].l2, 4.0, 0.3) << n;
    EXPECT_NEAR(errors[n - 1].max / errors[n].max, 4.0, 0.8) << n;
    EXPECT_NEAR(errors[n - 1].gradient / errors[n].gradient, 2.0, 0.2) << n;
  }
}

TEST(Poisson, ErrorsOnAnEllipsoidFallWithTheirOrders) {
  const Eigen::Vector3d axes(1.5, 1.0, 0.8);
  std::vector<Errors> errors;
  for (const int quartered : {3, 4, 5}) {
    TriangleMesh mesh = sample_meshes::icosphere(quartered);
    for (Eigen::Vector3d& v : mesh.vertices) v = v.cwiseProduct(axes);
    errors.push_back(errors_on(mesh, [&](const Eigen::Vector3d& x) { return known_surfaces::ellipsoid(axes, x); }));
  }
  expect_orders(errors);
  EXPECT_LT(errors.back().l2, 2e-3);
}

TEST(Poisson, ErrorsOnATorusFallWithTheirOrders) {
  std::vector<Errors> errors;
  for (const std::uint32_t n : {20U, 40U, 80U}) {
    errors.push_back(errors_on(sample_meshes::torus(n), known_surfaces::torus));
  }
  expect_orders(errors);
}

TEST(Poisson, SurfaceDerivativesAreThoseAlongGreatCircles) {
  const double radius = 1.7;
  const ManufacturedSolution u(radius);
  const FootPoint foot = known_surfaces::feet({{0.5, 1.0, -0.7}}, [&](const Eigen::Vector3d& x) {
                           return known_surfaces::ellipsoid(Eigen::Vector3d::Constant(radius), x);
                         }).front();
  const Eigen::Vector3d n = foot.x / radius;
  const Eigen::Vector3d s = n.unitOrthogonal(), t = n.cross(s);
  constexpr double step = 1e-4;
  double laplacian = 0.0;
  for (const Eigen::Vector3d& direction : {s, t}) {
    const auto along = [&](double length) {
      return u.value(foot.x * std::cos(length / radius) + radius * direction * std::sin(length / radius));
    };
    EXPECT_NEAR(u.surface_gradient(foot).dot(direction), (along(step) - along(-step)) / (2.0 * step), 1e-7);
    laplacian += (along(step) - 2.0 * along(0.0) + along(-step)) / (step * step);
  }
  EXPECT_NEAR(u.surface_gradient(foot).dot(n), 0.0, 1e-14);
  EXPECT_NEAR(u.surface_laplacian(foot), laplacian, 1e-6);  // rounding: 1e-16/step²
}

TEST(Poisson, IsTheSolutionOfADenseSolver) {
  const TriangleMesh mesh = sample_meshes::torus(8);
  const FiniteElements e = finite_elements(mesh, sorted_half_edges(mesh));
  const auto feet = known_surfaces::feet(mesh.vertices, known_surfaces::torus);
  const double squared_radius = e.area / (4.0 * M_PI);
  const ManufacturedSolution solution(std::sqrt(squared_radius));
  Eigen::VectorXd u(e.size()), f(e.size());
  for (Eigen::Index i = 0; i < e.size(); ++i) {
    const FootPoint& foot = feet[static_cast<std::size_t>(i)];
    u[i] = solution.value(foot.x);
    f[i] = u[i] / squared_radius - solution.surface_laplacian(foot);
  }
  const Eigen::MatrixXd mass(e.mass);
  const Eigen::VectorXd error = (Eigen::MatrixXd(e.stiffness) + mass / squared_radius).ldlt().solve(mass * f) - u;
  const double rms = std::sqrt(e.lumped_mass.dot(u.cwiseAbs2()) / e.area);
  Monitor monitor;
  const PoissonErrors errors = poisson_errors(e, screened_system(e), feet).value();
  EXPECT_NEAR(errors.max * rms / error.cwiseAbs().maxCoeff(), 1.0, 1e-6);
  EXPECT_LT((errors.at_unknowns * rms - error.cwiseAbs()).cwiseAbs().maxCoeff(), 1e-6 * errors.max * rms);
  EXPECT_NEAR(errors.l2 * rms / std::sqrt(e.lumped_mass.dot(error.cwiseAbs2()) / e.area), 1.0, 1e-6);
}

/// An icosphere with its vertices on the surface of ball(), whose spline is 0.03 mm within the sphere.
TriangleMesh on_ball(int quartered, const Isosurface& surface) {
  TriangleMesh mesh = sample_meshes::icosphere(quartered);
  for (Eigen::Vector3d& v : mesh.vertices)
    v = surface.project(12.0 * v + Eigen::Vector3d::Constant(20.0), 1e-9).value();
  return mesh;
}

TEST(Poisson, OnTheSurfaceOfAVolume) {
  const Isosurface surface = ball();
  std::vector<Measurement> measured;
  Monitor monitor;
  for (const int quartered : {3, 4, 5}) {
    TriangleMesh mesh = on_ball(quartered, surface);
    measured.push_back(measure(mesh, {.surface = &surface}, monitor));
  }
  // The spline's curvature has waves of a voxel, which the coarser meshes with edges of 1.9 and 0.9 mm see in part.
  EXPECT_NEAR(measured[0].number("poisson_l2") / measured[1].number("poisson_l2"), 4.0, 0.8);
  EXPECT_NEAR(measured[1].number("poisson_l2") / measured[2].number("poisson_l2"), 4.0, 0.4);
  EXPECT_NEAR(measured[1].number("gradient_max") / measured[2].number("gradient_max"), 2.0, 0.2);
  TriangleMesh kept = on_ball(3, surface);
  measure(kept, {.surface = &surface}, monitor);
  const std::vector<double>& at_vertices = kept.vertex_data.at("poisson_error");
  const std::vector<double>& of_triangles = kept.triangle_data.at("gradient_error");
  EXPECT_EQ(*std::max_element(at_vertices.begin(), at_vertices.end()), measured[0].number("poisson_max"));
  EXPECT_EQ(*std::max_element(of_triangles.begin(), of_triangles.end()), measured[0].number("gradient_max"));
  TriangleMesh open = on_ball(2, surface);
  open.triangles.pop_back();
  const Measurement of_open = measure(open, {.surface = &surface}, monitor);
  EXPECT_EQ(of_open.figure("poisson_l2"), std::nullopt);
  EXPECT_TRUE(of_open.figure("gradient_max").has_value());
}

}  // namespace
}  // namespace isobench
