#include "isobench/metrics/finite_elements/screened_system.h"

namespace isobench {

Eigen::VectorXd ScreenedSystem::solve(const Eigen::VectorXd& b) const {
  return scale.cwiseProduct(factors->solve(scale.cwiseProduct(b)));
}

ScreenedSystem screened_system(const FiniteElements& elements) {
  ScreenedSystem system;
  system.matrix = elements.stiffness + elements.mass / elements.squared_radius();
  system.scale = system.matrix.diagonal().cwiseSqrt().cwiseInverse();
  system.matrix = scaled(system.matrix, system.scale);
  system.factors = factorized(system.matrix);
  return system;
}

}  // namespace isobench
