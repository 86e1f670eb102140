// How small the steps of an explicit simulation must be: the largest eigenvalue of the mesh's Laplacian. Explicit Euler
// of the heat equation is stable up to a step of 2/λ = 2h²/step_factor; one bad triangle sets it for the whole mesh.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "isobench/foundation/monitor.h"
#include "isobench/metrics/finite_elements/finite_elements.h"

namespace isobench {

/// λmax of diag(h) M_L^-½ K M_L^-½ diag(h), to 1e-7: 6 for a lattice of equilateral triangles of edge length h. Some
/// hundred products with K at most. Precondition: the elements are regular.
std::optional<double> step_factor(const FiniteElements& elements, const Eigen::VectorXd& h, Monitor& monitor);

}  // namespace isobench
