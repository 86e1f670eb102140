#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "isobench/datasets/preparation/prepare_steps.h"

namespace isobench {

namespace {

/// The lattice with perpendicular axes that holds all nodes of `old`.
Lattice perpendicular(const Lattice& old) {
  const Eigen::Vector3d i = old.direction.col(0);
  const Eigen::Vector3d j = (old.direction.col(1) - i * i.dot(old.direction.col(1))).normalized();
  Eigen::Vector3d k = i.cross(j);
  if (k.dot(old.direction.col(2)) < 0.0) k = -k;
  Lattice result = old;
  result.direction.col(0) = i;
  result.direction.col(1) = j;
  result.direction.col(2) = k;
  // As many nodes to a length as before, counted perpendicular to the other axes.
  const Eigen::Matrix3d within = result.direction.transpose() * old.direction;  // upper triangular
  result.spacing = old.spacing.cwiseProduct(within.diagonal());
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d edge =
        within.col(axis) * (old.spacing[axis] * (old.size[static_cast<std::size_t>(axis)] - 1));
    low += edge.cwiseMin(0.0);
    high += edge.cwiseMax(0.0);
  }
  // Old nodes that are new ones, too, stay exactly in place: the box begins a whole number of steps before the first.
  constexpr double rounding = 1e-6;
  const Eigen::Vector3d before = (-low.cwiseQuotient(result.spacing)).array().max(0.0) - rounding;
  const Eigen::Vector3d first = before.array().ceil().max(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::ceil(high[axis] / result.spacing[axis] - rounding);
    result.size[static_cast<std::size_t>(axis)] = 1 + static_cast<int>(first[axis] + std::max(steps, 0.0));
  }
  result.origin = old.origin - result.direction * first.cwiseProduct(result.spacing);
  check_size(result.size);
  return result;
}

/// The angle by which the axes are off, in degrees.
double shear_of(const Lattice& lattice) {
  const Eigen::Matrix3d product = lattice.direction.transpose() * lattice.direction;
  const double cosine = (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  return std::asin(std::min(cosine, 1.0)) * 180.0 / M_PI;
}

}  // namespace

template <class Real>
RealVolume<Real> rectangular(const RealVolume<Real>& volume, double outside, Monitor& monitor) {
  const Lattice& old = volume.lattice;
  RealVolume<Real> result{perpendicular(old), {}};
  const Lattice& lattice = result.lattice;
  result.samples.assign(lattice.nodes(), static_cast<Real>(outside));
  // A new node's place in the old lattice, in nodes.
  const Eigen::Matrix3d to_old = old.spacing.cwiseInverse().asDiagonal() * old.direction.inverse() * lattice.direction *
                                 lattice.spacing.asDiagonal();
  const Eigen::Vector3d shift = old.spacing.cwiseInverse().asDiagonal() * old.to_local(lattice.origin);
  constexpr double rounding = 1e-6;
  tbb::parallel_for(0, lattice.size[2], [&](int k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i) {
        const Eigen::Vector3d place = to_old * Eigen::Vector3d(i, j, k) + shift;
        std::array<int, 3> node{};
        std::array<Real, 3> t{};
        bool within = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const int last = old.size[axis] - 1;
          const double at = place[static_cast<Eigen::Index>(axis)];
          within = within && at >= -rounding && at <= last + rounding;
          node[axis] = std::clamp(static_cast<int>(std::floor(at + rounding)), 0, std::max(last - 1, 0));
          t[axis] = static_cast<Real>(std::clamp(at - node[axis], 0.0, last > 0 ? 1.0 : 0.0));
          if (t[axis] < static_cast<Real>(rounding)) t[axis] = Real{0};
        }
        if (!within) continue;
        Real sum{0};
        for (int corner = 0; corner < 8; ++corner) {
          std::array<int, 3> at{};
          Real weight{1};
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const int upper = (corner >> axis) & 1;
            at[axis] = std::min(node[axis] + upper, old.size[axis] - 1);
            weight *= upper == 1 ? t[axis] : Real{1} - t[axis];
          }
          if (weight != Real{0}) sum += weight * volume.at(at[0], at[1], at[2]);
        }
        result.at(i, j, k) = sum;
      }
    }
  });
  monitor.note(
      fmt::format("its axes are {:.3g}° from perpendicular: it was sampled on perpendicular ones, {} × {} × {} "
                  "nodes at {:.4g} × {:.4g} × {:.4g} mm",
                  shear_of(old), lattice.size[0], lattice.size[1], lattice.size[2], lattice.spacing[0],
                  lattice.spacing[1], lattice.spacing[2]));
  return result;
}

template FloatVolume rectangular(const FloatVolume&, double, Monitor&);
template DoubleVolume rectangular(const DoubleVolume&, double, Monitor&);

}  // namespace isobench
