// Linear finite elements against a solution that is known: Dziuk 1988 (surface finite elements), Shewchuk 2002 (what
// triangles do to interpolation, gradients and conditioning).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "isobench/metrics/finite_elements/screened_system.h"
#include "isobench/metrics/foot_points/foot_points.h"

namespace isobench {

/// The manufactured solution u(x) = sin(2 a·x/L) + cos(2 b·x/L) with unit vectors a ⟂ b; L in mm.
class ManufacturedSolution {
 public:
  explicit ManufacturedSolution(double length) : wave_(2.0 / length) {}
  double value(const Eigen::Vector3d& x) const;
  /// ∇_Γ u: the part of ∇u in the surface. 1/mm.
  Eigen::Vector3d surface_gradient(const FootPoint& foot) const;
  /// Δ_Γ u = Δu − nᵀ(∇²u)n − 2H n·∇u, with the surface's own normal and mean curvature. 1/mm².
  double surface_laplacian(const FootPoint& foot) const;

 private:
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const;
  Eigen::Matrix3d hessian(const Eigen::Vector3d& x) const;
  double wave_;
};

struct PoissonErrors {
  double max = 0.0;             ///< largest error at a vertex
  double l2 = 0.0;              ///< root mean square of the errors at the vertices, weighted by the lumped mass
  Eigen::VectorXd at_unknowns;  ///< absolute errors
};

struct GradientErrors {
  double max = 0.0;
  std::vector<double> of_triangles;  ///< one a triangle; 0 where it was not measured
};

/// Solves (K + M/L²) U = M f with f = u/L² − Δ_Γ u at the vertices' foot points, and compares U with u there. Errors
/// are over u's root mean square. L is the radius of a sphere with the mesh's area; u/L² makes the solution unique on
/// each component. std::nullopt where the system, which is that of the elements, has no factors. Preconditions: regular
/// elements, a mesh without border, all feet exist. One foot a vertex of the mesh.
std::optional<PoissonErrors> poisson_errors(const FiniteElements& elements, const ScreenedSystem& system,
                                            const std::vector<FootPoint>& feet);

/// |∇(Iu) − ∇_Γ u| of each triangle and the largest, over the root mean square of ∇_Γ u: Iu is linear and has the
/// values of u at the foot points of the corners; ∇_Γ u is taken at the foot point of the centroid. std::nullopt where
/// no triangle has both. Preconditions: regular elements. One foot a vertex, and one a triangle.
std::optional<GradientErrors> gradient_errors(const FiniteElements& elements, const TriangleMesh& mesh,
                                              const std::vector<FootPoint>& feet,
                                              const std::vector<FootPoint>& centroid_feet);

}  // namespace isobench
