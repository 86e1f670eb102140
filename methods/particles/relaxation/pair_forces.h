// The forces of a particle's neighbours on it.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "isobench/methods/particles/relaxation/particles.h"

namespace isobench::particles {

/// Sums over the neighbours of a particle: the gradient and stiffness of Σ h² E(d), where h is the smaller spacing of a
/// pair, and the energy Σ E(d). The weight h² makes the force along a line of equally packed particles constant.
/// Without it, fine regions push particles into coarse ones, and the packing drifts away from the sizing with every
/// sweep.
struct PairForces {
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double stiffness = 0.0;
  double energy = 0.0;
};

PairForces forces_on(const Particles& particles, const NeighbourLists& near, std::size_t i);

}  // namespace isobench::particles
