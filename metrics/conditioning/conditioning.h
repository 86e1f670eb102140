// How hard a mesh makes linear systems: the condition of a ScreenedSystem's Â, and how many steps conjugate gradients
// take (Shewchuk 2002: it is the smallest angles that count).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "isobench/foundation/monitor.h"
#include "isobench/metrics/finite_elements/screened_system.h"

namespace isobench {

/// λmax/λmin of Â times h²/L², to 1e-6, with h² the elements' mean_squared_edge(): 6 for a lattice of equilateral
/// triangles. λmin is the inverse of the largest eigenvalue of Â⁻¹. std::nullopt where the system has no factors. Some
/// ten solutions with them, and products with Â. Precondition: the system is that of the elements.
std::optional<double> condition(const FiniteElements& elements, const ScreenedSystem& system, Monitor& monitor);

/// The number of steps until the residual is `tolerance` of b; std::nullopt if `max_steps` are not enough. Each step
/// costs a product with A and three passes over vectors: about 1 ms for 250,000 vertices on two cores. Eigen's solver
/// uses one core and cannot be cancelled.
std::optional<int> conjugate_gradient_steps(const SparseMatrix& a, const Eigen::VectorXd& b, double tolerance,
                                            int max_steps, Monitor& monitor);

/// Of Â x = D^-½ b to 1e-8, for a b of random numbers from a fixed seed; at most 20,000.
std::optional<int> jacobi_steps(const ScreenedSystem& system, Monitor& monitor);

}  // namespace isobench
