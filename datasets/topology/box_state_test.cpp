// Polynomials that meet all conditions of a decided box but one.
#include "isobench/datasets/topology/box_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace isobench {
namespace {

/// a0 + a1 t + a2 t² + a3 t³.
using Cubic = std::array<double, 4>;

/// factor · x(x) · y(y) · z(z).
struct Term {
  double factor;
  Cubic x;
  Cubic y;
  Cubic z;
};

constexpr Cubic one = {1, 0, 0, 0};
constexpr Cubic linear = {0, 1, 0, 0};
constexpr Cubic bump = {0, 4, -4, 0};  // 0 at both ends, 1 in the middle

std::array<double, 4> bernstein(const Cubic& a) {
  return {a[0], a[0] + a[1] / 3, a[0] + 2 * a[1] / 3 + a[2] / 3, a[0] + a[1] + a[2] + a[3]};
}

Tricubic sum_of(const std::vector<Term>& terms) {
  Tricubic f{};
  for (const Term& term : terms) {
    const auto x = bernstein(term.x);
    const auto y = bernstein(term.y);
    const auto z = bernstein(term.z);
    for (std::size_t n = 0; n < 64; ++n) f.b[n] += term.factor * x[n % 4] * y[n / 4 % 4] * z[n / 16];
  }
  return f;
}

constexpr Margins margins{1e-12, 1e-12};

TEST(BoxState, APlaneIsADisc) {
  const Tricubic f =
      sum_of({{1, linear, one, one}, {1, one, linear, one}, {1, one, one, linear}, {-1.4, one, one, one}});
  const BoxState state = examine(f, margins);
  EXPECT_EQ(state.kind, BoxKind::disc);
  EXPECT_EQ(state.inside, 0b11101000U);  // the corners with two or three ones
  EXPECT_NEAR(f.corner(6), 0.6, 1e-15);
}

TEST(BoxState, WithoutAZeroThereIsNoSurface) {
  EXPECT_EQ(examine(sum_of({{0.1, one, one, one}, {1, bump, bump, bump}}), margins).kind, BoxKind::without_surface);
  EXPECT_EQ(examine(sum_of({{-3, one, one, one}, {1, bump, bump, bump}}), margins).kind, BoxKind::without_surface);
}

TEST(BoxState, ASpeckWithinIsUndecided) {
  EXPECT_EQ(examine(sum_of({{-0.3, one, one, one}, {1, bump, bump, bump}}), margins).kind, BoxKind::undecided);
}

// f rises along z and has no zero on any edge, but it has a loop of zeros on one face.
TEST(BoxState, ALoopOnAFaceIsUndecided) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto turned = [axis](const Cubic& a, const Cubic& b, const Cubic& c) {
      return axis == 0 ? Term{1, a, b, c} : axis == 1 ? Term{1, b, c, a} : Term{1, c, a, b};
    };
    Term rise = turned(one, one, linear);
    rise.factor = 0.1;
    EXPECT_EQ(examine(sum_of({{-0.3, one, one, one}, turned(bump, bump, one), rise}), margins).kind,
              BoxKind::undecided);
  }
}

// f rises along two axes, but has two zeros on the edges along the third.
TEST(BoxState, TwoCrossingsOfAnEdgeAreUndecided) {
  const Tricubic x = sum_of({{-0.3, one, one, one}, {1, bump, one, one}, {2, one, linear, one}, {2, one, one, linear}});
  const Tricubic y = sum_of({{-0.3, one, one, one}, {1, one, bump, one}, {2, linear, one, one}, {2, one, one, linear}});
  const Tricubic z = sum_of({{-0.3, one, one, one}, {1, one, one, bump}, {2, linear, one, one}, {2, one, linear, one}});
  for (const Tricubic& f : {x, y, z}) EXPECT_EQ(examine(f, margins).kind, BoxKind::undecided);
}

TEST(BoxState, AZeroAtACornerIsUndecided) {
  const Tricubic f = sum_of({{1, linear, one, one}, {1, one, linear, one}, {1, one, one, linear}});
  EXPECT_EQ(examine(f, margins).kind, BoxKind::undecided);
}

TEST(BoxState, ABoxIsRegularIfItHasNoCriticalPointWithTheseValues) {
  const Tricubic peak = sum_of({{1, bump, bump, bump}});
  EXPECT_FALSE(is_regular(peak, 0.9, 1.1, margins.difference));
  EXPECT_TRUE(is_regular(peak, 8.0, 9.0, margins.difference));
  EXPECT_TRUE(is_regular(peak, -2.0, -1.0, margins.difference));
  EXPECT_TRUE(is_regular(sum_of({{1, bump, bump, one}, {0.1, one, one, linear}}), 0.0, 1.0, margins.difference));
}

TEST(Tricubic, PartsAreThePolynomialOnTheirBoxes) {
  const Tricubic f = sum_of({{1, {1, 2, -3, 4}, {2, -1, 5, 1}, {-1, 3, 1, -2}}, {0.5, bump, linear, bump}});
  std::array<Tricubic, 8> parts{};
  cut(f, 0.3, parts);
  for (unsigned part = 0; part < 8; ++part) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::array<double, 3> at{};
      for (unsigned axis = 0; axis < 3; ++axis) {
        const bool high_part = (part >> axis & 1U) != 0;
        const bool high_corner = (corner >> axis & 1U) != 0;
        at[axis] = high_part ? (high_corner ? 1.0 : 0.3) : (high_corner ? 0.3 : 0.0);
      }
      const auto value = [](const Cubic& a, double t) { return a[0] + t * (a[1] + t * (a[2] + t * a[3])); };
      const double expected = value({1, 2, -3, 4}, at[0]) * value({2, -1, 5, 1}, at[1]) * value({-1, 3, 1, -2}, at[2]) +
                              0.5 * value(bump, at[0]) * value(linear, at[1]) * value(bump, at[2]);
      EXPECT_NEAR(parts[part].corner(corner), expected, 1e-12) << part << ' ' << corner;
    }
  }
}

}  // namespace
}  // namespace isobench
