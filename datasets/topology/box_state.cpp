#include "isobench/datasets/topology/box_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace isobench {

namespace {

#pragma GCC diagnostic ignored "-Wpsabi"
using Double4 = double __attribute__((vector_size(32)));

__attribute__((always_inline)) inline Double4 load(const double* p) {
  Double4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// The differences of a line's neighbours; the last lane repeats the last difference.
__attribute__((always_inline)) inline Double4 differences(const Double4& line) {
  return __builtin_shufflevector(line, line, 1, 2, 3, 3) - __builtin_shufflevector(line, line, 0, 1, 2, 2);
}

/// Smallest and largest of the values added, lane by lane.
struct Lanes {
  Double4 low;
  Double4 high;

  explicit Lanes(const Double4& first) : low(first), high(first) {}
  __attribute__((always_inline)) void add(const Double4& v) {
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  double least() const { return std::min(std::min(low[0], low[1]), std::min(low[2], low[3])); }
  double most() const { return std::max(std::max(high[0], high[1]), std::max(high[2], high[3])); }
};

/// Whether the function whose differences these are rises strictly, or falls strictly.
bool has_sign(const Lanes& differences, double margin) {
  return differences.least() > margin || differences.most() < -margin;
}

bool is_monotone(const Tricubic& f, double margin) {
  const double* b = f.b.data();
  Lanes x(differences(load(b)));
  for (std::size_t n = 4; n < 64; n += 4) x.add(differences(load(b + n)));
  if (has_sign(x, margin)) return true;
  Lanes y(load(b + 4) - load(b));
  for (std::size_t n = 4; n < 64; n += 4) {
    if (n % 16 != 12) y.add(load(b + n + 4) - load(b + n));
  }
  if (has_sign(y, margin)) return true;
  Lanes z(load(b + 16) - load(b));
  for (std::size_t n = 4; n < 48; n += 4) z.add(load(b + n + 16) - load(b + n));
  return has_sign(z, margin);
}

/// The 4 × 4 coefficients of a face.
using Face = std::array<Double4, 4>;

Face face_of(const Tricubic& f, int axis, int side) {
  const double* b = f.b.data();
  const std::size_t s = side == 0 ? 0 : 3;
  Face face{};
  for (std::size_t m = 0; m < 4; ++m) {
    if (axis == 0) {
      const double* p = b + s + 16 * m;
      face[m] = Double4{p[0], p[4], p[8], p[12]};
    } else {
      face[m] = load(axis == 1 ? b + 4 * s + 16 * m : b + 16 * s + 4 * m);
    }
  }
  return face;
}

bool is_regular_face(const Face& face, const Margins& margins) {
  Lanes values(face[0]);
  for (std::size_t m = 1; m < 4; ++m) values.add(face[m]);
  if (values.least() > margins.value || values.most() < -margins.value) return true;
  Lanes u(differences(face[0]));
  for (std::size_t m = 1; m < 4; ++m) u.add(differences(face[m]));
  if (has_sign(u, margins.difference)) return true;
  Lanes v(face[1] - face[0]);
  v.add(face[2] - face[1]);
  v.add(face[3] - face[2]);
  return has_sign(v, margins.difference);
}

bool is_regular_edge(const double* b, std::size_t step, const Margins& margins) {
  const double b0 = b[0];
  const double b1 = b[step];
  const double b2 = b[2 * step];
  const double b3 = b[3 * step];
  if (std::min(std::min(b0, b1), std::min(b2, b3)) > margins.value) return true;
  if (std::max(std::max(b0, b1), std::max(b2, b3)) < -margins.value) return true;
  const double margin = margins.difference;
  return (b1 - b0 > margin && b2 - b1 > margin && b3 - b2 > margin) ||
         (b1 - b0 < -margin && b2 - b1 < -margin && b3 - b2 < -margin);
}

bool edges_are_regular(const Tricubic& f, const Margins& margins) {
  const double* b = f.b.data();
  for (const std::size_t v : {0U, 12U}) {
    for (const std::size_t w : {0U, 48U}) {
      if (!is_regular_edge(b + v + w, 1, margins)) return false;
    }
  }
  for (const std::size_t u : {0U, 3U}) {
    for (const std::size_t w : {0U, 48U}) {
      if (!is_regular_edge(b + u + w, 4, margins)) return false;
    }
    for (const std::size_t v : {0U, 12U}) {
      if (!is_regular_edge(b + u + v, 16, margins)) return false;
    }
  }
  return true;
}

Lanes values_of(const Tricubic& f) {
  Lanes values(load(f.b.data()));
  for (std::size_t n = 4; n < 64; n += 4) values.add(load(&f.b[n]));
  return values;
}

}  // namespace

BoxState examine(const Tricubic& f, const Margins& margins) {
  const Lanes values = values_of(f);
  if (values.least() > margins.value) return {BoxKind::without_surface, 255};
  if (values.most() < -margins.value) return {BoxKind::without_surface, 0};
  BoxState state;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const double value = f.corner(corner);
    if (!(std::abs(value) > margins.value)) return state;
    if (value > 0.0) state.inside = static_cast<std::uint8_t>(state.inside | 1U << corner);
  }
  if (!is_monotone(f, margins.difference) || !edges_are_regular(f, margins)) return state;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (!is_regular_face(face_of(f, axis, side), margins)) return state;
    }
  }
  const bool mixed = state.inside != 0 && state.inside != 255;
  state.kind = mixed ? BoxKind::disc : BoxKind::without_surface;
  return state;
}

bool is_regular(const Tricubic& f, double low, double high, double margin) {
  const Lanes values = values_of(f);
  return values.least() > high || values.most() < low || is_monotone(f, margin);
}

}  // namespace isobench
