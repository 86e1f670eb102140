#include "isobench/datasets/phantoms/ellipsoid.h"

#include <algorithm>
#include <cmath>

namespace isobench {

template <int N>
Eigen::Matrix<double, N, 1> nearest_on_ellipsoid(const Eigen::Matrix<double, N, 1>& semi_axes,
                                                 const Eigen::Matrix<double, N, 1>& y) {
  using Point = Eigen::Matrix<double, N, 1>;
  const Point squares = semi_axes.cwiseProduct(semi_axes);
  const Point moments = semi_axes.cwiseProduct(y.cwiseAbs());
  Point x;
  // If y lies in the plane perpendicular to the last axis and g < 0 at the pole t = −e_last², there are two nearest
  // points, mirror images on both sides of that plane. Their other coordinates are those at the pole.
  if (moments[N - 1] == 0.0) {
    double left = 1.0;
    for (int i = 0; i + 1 < N; ++i) {
      x[i] = squares[i] * y[i] / (squares[i] - squares[N - 1]);
      left -= x[i] * x[i] / squares[i];
    }
    if (left > 0.0) {
      x[N - 1] = semi_axes[N - 1] * std::sqrt(left);
      return x;
    }
  }
  // A single term of g is 1 at t = −e_i² + e_i|y_i|, so g ≥ 0 at the largest of these t.
  double t = (moments - squares).maxCoeff();
  for (int step = 0; step < 200; ++step) {
    double g = -1.0;
    double slope = 0.0;
    for (int i = 0; i < N; ++i) {
      const double ratio = moments[i] == 0.0 ? 0.0 : moments[i] / (t + squares[i]);
      g += ratio * ratio;
      slope -= moments[i] == 0.0 ? 0.0 : 2.0 * ratio * ratio / (t + squares[i]);
    }
    const double next = t - g / slope;
    if (!(next > t)) break;
    t = next;
  }
  for (int i = 0; i < N; ++i) x[i] = y[i] == 0.0 ? 0.0 : squares[i] * y[i] / (t + squares[i]);
  return x;
}

template Eigen::Vector2d nearest_on_ellipsoid<2>(const Eigen::Vector2d&, const Eigen::Vector2d&);
template Eigen::Vector3d nearest_on_ellipsoid<3>(const Eigen::Vector3d&, const Eigen::Vector3d&);

}  // namespace isobench
