// How small the steps of an explicit simulation must be if it uses the consistent mass.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "isobench/foundation/monitor.h"
#include "isobench/metrics/finite_elements/step_factor.h"

namespace isobench {

/// step_factor() with the consistent mass M in place of M_L: 24 for that lattice. Each step solves a system with M,
/// whose condition is at most 4 once it is scaled (Wathen 1987): twenty times the cost.
std::optional<double> consistent_step_factor(const FiniteElements& elements, const Eigen::VectorXd& h,
                                             Monitor& monitor);

}  // namespace isobench
