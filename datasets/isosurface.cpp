#include "isobench/datasets/isosurface.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "isobench/datasets/spline_prefilter.h"
#include "isobench/foundation/error.h"

// The evaluators are compiled twice; the processor's features choose the version when the program starts. Both do the
// same operations in the same order (contraction is off), so results agree to the bit. Under a sanitizer there is one
// version, because the choice is made before the sanitizer's runtime is ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ISOBENCH_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define ISOBENCH_CLONES
#endif

namespace isobench {

namespace {

// Only functions that are always inlined pass vectors of four doubles, so the calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

/// Four tap weights of a kernel and of its derivatives with respect to the lattice coordinate.
struct Weights {
  std::array<double, 4> w0;  ///< value
  std::array<double, 4> w1;  ///< first derivative
  std::array<double, 4> w2;  ///< second derivative
};

std::array<double, 4> bspline_value(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
          (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0};
}

std::array<double, 4> bspline_first(double t) {
  const double s = 1.0 - t;
  return {-s * s / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, (-3.0 * t * t + 2.0 * t + 1.0) / 2.0, t * t / 2.0};
}

std::array<double, 4> bspline_second(double t) { return {1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t}; }

std::array<double, 4> catmull_rom_value(double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return {(-t3 + 2.0 * t2 - t) / 2.0, (3.0 * t3 - 5.0 * t2 + 2.0) / 2.0, (-3.0 * t3 + 4.0 * t2 + t) / 2.0,
          (t3 - t2) / 2.0};
}

__attribute__((always_inline)) inline Double4 load(const float* p) {
  Float4 v;
  std::memcpy(&v, p, sizeof v);
  return __builtin_convertvector(v, Double4);
}

__attribute__((always_inline)) inline double dot(const Double4& v, const std::array<double, 4>& w) {
  return (v[0] * w[0] + v[1] * w[1]) + (v[2] * w[2] + v[3] * w[3]);
}

/// The weighted sum of four lane vectors.
__attribute__((always_inline)) inline Double4 combine(const Double4* v, const std::array<double, 4>& w) {
  return (v[0] * w[0] + v[1] * w[1]) + (v[2] * w[2] + v[3] * w[3]);
}

/// The lanes run along x, because its samples are neighbours in memory: sums over z and y come first, over x last.
ISOBENCH_CLONES void sum_value(const float* corner, std::ptrdiff_t row, std::ptrdiff_t slab,
                               const std::array<double, 4>& x, const std::array<double, 4>& y,
                               const std::array<double, 4>& z, double* result) {
  Double4 along_y[4];
  for (int j = 0; j < 4; ++j) {
    const float* p = corner + j * row;
    const Double4 taps[4] = {load(p), load(p + slab), load(p + 2 * slab), load(p + 3 * slab)};
    along_y[j] = combine(taps, z);
  }
  *result = dot(combine(along_y, y), x);
}

/// result: value, ∂x, ∂y, ∂z in lattice units.
ISOBENCH_CLONES void sum_gradient(const float* corner, std::ptrdiff_t row, std::ptrdiff_t slab, const Weights& x,
                                  const Weights& y, const Weights& z, double* result) {
  Double4 z0[4];
  Double4 z1[4];
  for (int j = 0; j < 4; ++j) {
    const float* p = corner + j * row;
    const Double4 taps[4] = {load(p), load(p + slab), load(p + 2 * slab), load(p + 3 * slab)};
    z0[j] = combine(taps, z.w0);
    z1[j] = combine(taps, z.w1);
  }
  const Double4 value = combine(z0, y.w0);
  result[0] = dot(value, x.w0);
  result[1] = dot(value, x.w1);
  result[2] = dot(combine(z0, y.w1), x.w0);
  result[3] = dot(combine(z1, y.w0), x.w0);
}

/// result: value, ∂x, ∂y, ∂z, ∂xx, ∂yy, ∂zz, ∂xy, ∂xz, ∂yz in lattice units.
ISOBENCH_CLONES void sum_jet(const float* corner, std::ptrdiff_t row, std::ptrdiff_t slab, const Weights& x,
                             const Weights& y, const Weights& z, double* result) {
  Double4 z0[4];
  Double4 z1[4];
  Double4 z2[4];
  for (int j = 0; j < 4; ++j) {
    const float* p = corner + j * row;
    const Double4 taps[4] = {load(p), load(p + slab), load(p + 2 * slab), load(p + 3 * slab)};
    z0[j] = combine(taps, z.w0);
    z1[j] = combine(taps, z.w1);
    z2[j] = combine(taps, z.w2);
  }
  const Double4 y0z0 = combine(z0, y.w0);
  const Double4 y1z0 = combine(z0, y.w1);
  const Double4 y0z1 = combine(z1, y.w0);
  result[0] = dot(y0z0, x.w0);
  result[1] = dot(y0z0, x.w1);
  result[2] = dot(y1z0, x.w0);
  result[3] = dot(y0z1, x.w0);
  result[4] = dot(y0z0, x.w2);
  result[5] = dot(combine(z0, y.w2), x.w0);
  result[6] = dot(combine(z2, y.w0), x.w0);
  result[7] = dot(y1z0, x.w1);
  result[8] = dot(y0z1, x.w1);
  result[9] = dot(combine(z1, y.w1), x.w0);
}

/// The cell of a lattice coordinate, clamped to [0, size − 1], and the offset within the cell.
struct Cell {
  int index;
  double t;
};

Cell locate(double u, int size) {
  const double clamped = std::clamp(u, 0.0, static_cast<double>(size - 1));
  const int index = std::min(static_cast<int>(clamped), size - 2);
  return {index, clamped - index};
}

}  // namespace

std::string to_string(Kernel kernel) {
  switch (kernel) {
    case Kernel::bspline:
      return "bspline";
    case Kernel::interpolating_bspline:
      return "interpolating-bspline";
    case Kernel::catmull_rom:
      break;
  }
  return "catmull-rom";
}

std::string to_string(Inside inside) { return inside == Inside::above ? "above" : "below"; }

namespace {

/// sample − c. 64-bit integers are subtracted as integers, so that the sign is right where a double rounds them.
template <class T>
double difference(T sample, double c) {
  if constexpr (sizeof(T) == 8 && std::is_integral_v<T>) {
    const double whole = std::floor(c);
    if (whole >= static_cast<double>(std::numeric_limits<T>::min()) &&
        whole < std::ldexp(1.0, std::numeric_limits<T>::digits)) {
      const T below = static_cast<T>(whole);
      // Unsigned differences do not overflow.
      const auto distance = sample >= below ? static_cast<std::uint64_t>(sample) - static_cast<std::uint64_t>(below)
                                            : static_cast<std::uint64_t>(below) - static_cast<std::uint64_t>(sample);
      return (sample >= below ? 1.0 : -1.0) * static_cast<double>(distance) - (c - whole);
    }
  }
  return static_cast<double>(sample) - c;
}

void check_isovalue(const Volume& volume, double c) {
  const Range range = sample_range(volume);  // throws if a sample is not finite
  const bool lies_between = volume.samples.visit([&](const auto& samples) {
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
    return difference(*least, c) < 0.0 && difference(*most, c) > 0.0;
  });
  if (!lies_between) {
    throw DataError(fmt::format("isovalue {} is outside the range of the samples, {} to {}; choose one between them", c,
                                range.min, range.max));
  }
}

/// sign · (sample − c), each rounded to float once, so that they keep what counts near c: samples on a large pedestal,
/// such as int32 near 1e9, differ by less than a float there can hold.
FloatVolume differences_from(double c, double sign, Volume volume) {
  std::vector<float> differences = volume.samples.visit([&](auto& samples) -> std::vector<float> {
    using T = SampleOf<decltype(samples)>;
    const auto rounded = [&](T sample) { return static_cast<float>(sign * difference(sample, c)); };
    if constexpr (std::is_same_v<T, float>) {
      std::transform(samples.begin(), samples.end(), samples.begin(), rounded);
      return std::move(samples);
    } else {
      std::vector<float> result(samples.size());
      std::transform(samples.begin(), samples.end(), result.begin(), rounded);
      return result;
    }
  });
  const auto infinite =
      std::find_if_not(differences.begin(), differences.end(), [](float d) { return std::isfinite(d); });
  if (infinite != differences.end()) {
    const auto n = static_cast<std::size_t>(infinite - differences.begin());
    const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
    const auto ny = static_cast<std::size_t>(volume.lattice.size[1]);
    throw DataError(
        fmt::format("the sample at node ({}, {}, {}) is too large for single precision; scale the volume down", n % nx,
                    n / nx % ny, n / nx / ny));
  }
  return {std::move(volume.lattice), std::move(differences)};
}

}  // namespace

Isosurface::Isosurface(Volume volume, double isovalue, Inside inside, Kernel kernel)
    : lattice_(volume.lattice),
      isovalue_(isovalue),
      inside_(inside),
      kernel_(kernel),
      voxel_(lattice_.voxel()),
      inverse_spacing_(lattice_.spacing.cwiseInverse()) {
  const std::array<int, 3>& size = lattice_.size;
  if (size[0] < 4 || size[1] < 4 || size[2] < 4) {
    throw DataError(fmt::format("the volume has {}×{}×{} nodes; a spline surface needs at least 4 along each axis",
                                size[0], size[1], size[2]));
  }
  check_isovalue(volume, isovalue);
  for (int axis = 0; axis < 3; ++axis) extent_[axis] = lattice_.spacing[axis] * (size[axis] - 1);
  FloatVolume differences = differences_from(isovalue, inside == Inside::above ? 1.0 : -1.0, std::move(volume));
  if (kernel == Kernel::interpolating_bspline) interpolating_coefficients(differences);
  coefficients_ = std::move(differences.samples);
}

void Isosurface::move_isovalue(double isovalue) {
  const double change = (inside_ == Inside::above ? 1.0 : -1.0) * (isovalue_ - isovalue);
  for (float& c : coefficients_) c = static_cast<float>(c + change);
  isovalue_ = isovalue;
}

Isosurface::Taps Isosurface::taps(const Eigen::Vector3d& x, std::array<double, 3>& t, Block& border) const {
  const std::array<int, 3>& size = lattice_.size;
  std::array<int, 3> first{};
  bool within = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto coordinate = static_cast<Eigen::Index>(axis);
    const Cell cell = locate(x[coordinate] * inverse_spacing_[coordinate], size[axis]);
    first[axis] = cell.index - 1;
    t[axis] = cell.t;
    within = within && cell.index > 0 && cell.index + 2 < size[axis];
  }
  if (within) {
    const auto row = static_cast<std::ptrdiff_t>(size[0]);
    return {&coefficients_[lattice_.index(first[0], first[1], first[2])], row, row * size[1]};
  }
  float* to = border.data();
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) *to++ = coefficient(first[0] + i, first[1] + j, first[2] + k);
    }
  }
  return {border.data(), 4, 16};
}

double Isosurface::value(const Eigen::Vector3d& x) const {
  std::array<double, 3> t{};
  Block border;
  const Taps p = taps(x, t, border);
  const auto weights = kernel_ == Kernel::catmull_rom ? catmull_rom_value : bspline_value;
  double result = 0.0;
  sum_value(p.first, p.row, p.slab, weights(t[0]), weights(t[1]), weights(t[2]), &result);
  return result;
}

Jet Isosurface::value_gradient(const Eigen::Vector3d& x) const {
  std::array<double, 3> t{};
  Block border;
  const Taps p = taps(x, t, border);
  std::array<Weights, 3> w;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    w[axis].w0 = bspline_value(t[axis]);
    w[axis].w1 = bspline_first(t[axis]);
  }
  std::array<double, 4> sums{};
  sum_gradient(p.first, p.row, p.slab, w[0], w[1], w[2], sums.data());
  if (kernel_ == Kernel::catmull_rom) sums[0] = value(x);
  Jet jet;
  jet.value = sums[0];
  jet.gradient = Eigen::Vector3d(sums[1], sums[2], sums[3]).cwiseProduct(inverse_spacing_);
  return jet;
}

Jet Isosurface::jet(const Eigen::Vector3d& x) const {
  std::array<double, 3> t{};
  Block border;
  const Taps p = taps(x, t, border);
  std::array<Weights, 3> w;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    w[axis] = {bspline_value(t[axis]), bspline_first(t[axis]), bspline_second(t[axis])};
  }
  std::array<double, 10> sums{};
  sum_jet(p.first, p.row, p.slab, w[0], w[1], w[2], sums.data());
  if (kernel_ == Kernel::catmull_rom) sums[0] = value(x);
  const Eigen::Vector3d& s = inverse_spacing_;
  Jet jet;
  jet.value = sums[0];
  jet.gradient = Eigen::Vector3d(sums[1], sums[2], sums[3]).cwiseProduct(s);
  jet.hessian << sums[4] * s[0] * s[0], sums[7] * s[0] * s[1], sums[8] * s[0] * s[2],  //
      sums[7] * s[0] * s[1], sums[5] * s[1] * s[1], sums[9] * s[1] * s[2],             //
      sums[8] * s[0] * s[2], sums[9] * s[1] * s[2], sums[6] * s[2] * s[2];
  return jet;
}

std::optional<Eigen::Vector3d> Isosurface::project(const Eigen::Vector3d& x, double tolerance, int max_steps) const {
  Eigen::Vector3d foot = x;
  for (int step = 0; step <= max_steps; ++step) {
    const Jet at = value_gradient(foot);
    const double slope = at.gradient.norm();
    if (!(slope > 0.0)) return std::nullopt;
    const double distance = at.value / slope;
    if (std::abs(distance) < tolerance * voxel_) return foot;
    const double limited = std::clamp(distance, -0.5 * voxel_, 0.5 * voxel_);
    foot = (foot - at.gradient * (limited / slope)).cwiseMax(0.0).cwiseMin(extent_);
  }
  return std::nullopt;
}

void Isosurface::copy_coefficients(int k, std::vector<float>& slab) const {
  const auto count = static_cast<std::ptrdiff_t>(lattice_.size[0]) * lattice_.size[1];
  const auto from = coefficients_.begin() + k * count;
  slab.assign(from, from + count);
}

void Isosurface::sample_values(int k, std::vector<float>& slab) const {
  // An interpolating spline has the samples at its nodes.
  if (kernel_ == Kernel::interpolating_bspline)
    node_values(k, slab);
  else
    copy_coefficients(k, slab);
}

void Isosurface::node_values(int k, std::vector<float>& slab) const {
  if (kernel_ == Kernel::catmull_rom) {
    copy_coefficients(k, slab);
    return;
  }
  const auto nx = static_cast<std::size_t>(lattice_.size[0]);
  const auto ny = static_cast<std::size_t>(lattice_.size[1]);
  slab.resize(nx * ny);
  // At a node the B-spline's taps are (1, 4, 1)/6 along each axis.
  const auto row = [&](int j, int plane) {
    return &coefficients_[lattice_.index(0, std::clamp(j, 0, lattice_.size[1] - 1),
                                         std::clamp(plane, 0, lattice_.size[2] - 1))];
  };
  std::vector<double> column(nx + 2);
  for (int j = 0; j < lattice_.size[1]; ++j) {
    std::array<std::array<const float*, 3>, 3> p{};
    for (int dz = 0; dz < 3; ++dz) {
      for (int dy = 0; dy < 3; ++dy)
        p[static_cast<std::size_t>(dz)][static_cast<std::size_t>(dy)] = row(j + dy - 1, k + dz - 1);
    }
    const auto across = [](const std::array<const float*, 3>& q, std::size_t i) {
      return (q[0][i] + 4.0 * q[1][i]) + q[2][i];
    };
    for (std::size_t i = 0; i < nx; ++i) column[i + 1] = (across(p[0], i) + 4.0 * across(p[1], i)) + across(p[2], i);
    column.front() = column[1];
    column.back() = column[nx];
    float* out = &slab[static_cast<std::size_t>(j) * nx];
    for (std::size_t i = 0; i < nx; ++i) {
      out[i] = static_cast<float>(((column[i] + 4.0 * column[i + 1]) + column[i + 2]) / 216.0);
    }
  }
}

float Isosurface::coefficient(int i, int j, int k) const {
  const std::array<int, 3>& size = lattice_.size;
  return coefficients_[lattice_.index(std::clamp(i, 0, size[0] - 1), std::clamp(j, 0, size[1] - 1),
                                      std::clamp(k, 0, size[2] - 1))];
}

double Curvatures::max_abs() const { return std::max(std::abs(k1), std::abs(k2)); }

Curvatures curvatures(const Jet& jet) {
  const double slope = jet.gradient.norm();
  if (!(slope > 0.0)) return {};
  const Eigen::Vector3d n = outward_normal(jet.gradient);
  const Eigen::Matrix3d p = Eigen::Matrix3d::Identity() - n * n.transpose();
  // f decreases outwards, so −P H P/|∇f| is positive where the object is convex.
  const Eigen::Matrix3d g = p * jet.hessian * p / -slope;
  const double trace = g.trace();
  const double root = std::sqrt(std::max(0.0, 2.0 * g.squaredNorm() - trace * trace));
  return {0.5 * (trace + root), 0.5 * (trace - root)};
}

}  // namespace isobench
