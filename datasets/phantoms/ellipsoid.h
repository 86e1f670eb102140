// The nearest point of an ellipse or ellipsoid, to machine precision.
#pragma once

#include <Eigen/Core>

namespace isobench {

/// The point nearest to y on the axis-aligned ellipse (N = 2) or ellipsoid (N = 3) around 0. Precondition: the
/// semi-axes are positive and decrease strictly from first to last. y may lie inside, outside or on the ellipsoid. On
/// the inner medial axis two points are equally near; the result is the one with the positive last coordinate. Method:
/// the nearest point x fulfils y_i − x_i = t·x_i/e_i², so x_i = e_i² y_i/(t + e_i²). It lies on the ellipsoid if g(t) =
/// Σ (e_i y_i/(t + e_i²))² − 1 = 0. For t > −e_last² the function g decreases and is convex, so Newton's method from
/// any t with g(t) ≥ 0 rises to the root without overshooting.
template <int N>
Eigen::Matrix<double, N, 1> nearest_on_ellipsoid(const Eigen::Matrix<double, N, 1>& semi_axes,
                                                 const Eigen::Matrix<double, N, 1>& y);

extern template Eigen::Vector2d nearest_on_ellipsoid<2>(const Eigen::Vector2d&, const Eigen::Vector2d&);
extern template Eigen::Vector3d nearest_on_ellipsoid<3>(const Eigen::Vector3d&, const Eigen::Vector3d&);

}  // namespace isobench
