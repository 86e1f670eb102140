#include "isobench/datasets/phantoms/phantoms.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isobench/datasets/phantoms/ellipsoid.h"
#include "isobench/datasets/phantoms/phantom_shapes.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

// Sphere, slab, capsule and rounded box are offsets of convex sets: everything within some distance of the set. They
// have no outer medial axis. If the set is a point, a disc or a segment, it is the inner medial axis. Area and volume
// follow from Steiner's formula.

Phantom sphere() {
  constexpr double r = 20.0;
  Phantom p;
  p.name = "sphere";
  p.title = "Sphere of radius 20 mm";
  p.function = [](const Vector3d& x) { return r - x.norm(); };
  p.half_extent = Vector3d::Constant(r);
  p.feature_size = [](const Vector3d& x) { return x.norm(); };
  p.area = 4.0 * pi * r * r;
  p.volume = 4.0 / 3.0 * pi * r * r * r;
  return p;
}

/// The inner medial axis is the core circle, at distance r from the surface. The outer one is the axis of rotation, all
/// of whose points are equally far from the core; its distance from the surface is R + r cos v, which is below r on the
/// inner rim because R < 2r.
Phantom torus() {
  constexpr double core = 14.0;
  constexpr double tube = 8.0;
  const auto from_core = [](const Vector3d& x) { return std::hypot(std::hypot(x[0], x[1]) - core, x[2]); };
  Phantom p;
  p.name = "torus";
  p.title = "Torus, core radius 14 mm, tube radius 8 mm";
  p.function = [from_core](const Vector3d& x) { return tube - from_core(x); };
  p.half_extent = {core + tube, core + tube, tube};
  p.euler = 0;
  p.feature_size = [from_core](const Vector3d& x) { return std::min(from_core(x), std::hypot(x[0], x[1])); };
  p.area = 4.0 * pi * pi * core * tube;
  p.volume = 2.0 * pi * pi * core * tube * tube;
  return p;
}

/// A ball that touches the surface at (x, y, ±z) has its centre at (x(1 − c²/a²), y(1 − c²/b²), 0). So the inner medial
/// axis is the filled ellipse with semi-axes (a² − c²)/a and (b² − c²)/b in the plane z = 0. The area is Legendre's
/// formula.
Phantom ellipsoid() {
  constexpr double a = 24.0;
  constexpr double b = 16.0;
  constexpr double c = 12.0;
  const Vector3d axes(a, b, c);
  const Vector2d focal((a * a - c * c) / a, (b * b - c * c) / b);
  Phantom p;
  p.name = "ellipsoid";
  p.title = "Ellipsoid with semi-axes 24, 16 and 12 mm";
  p.function = [axes](const Vector3d& x) {
    const double distance = (x - nearest_on_ellipsoid<3>(axes, x)).norm();
    return x.cwiseQuotient(axes).squaredNorm() < 1.0 ? distance : -distance;
  };
  p.half_extent = axes;
  p.feature_size = [focal](const Vector3d& x) {
    const Vector2d flat = x.head<2>();
    if (flat.cwiseQuotient(focal).squaredNorm() <= 1.0) return std::abs(x[2]);
    return std::hypot((flat - nearest_on_ellipsoid<2>(focal, flat)).norm(), x[2]);
  };
  const double angle = std::acos(c / a);
  const double k = std::sqrt(a * a * (b * b - c * c) / (b * b * (a * a - c * c)));
  p.area = 2.0 * pi * c * c + 2.0 * pi * a * b / std::sin(angle) *
                                  (std::ellint_2(k, angle) * std::pow(std::sin(angle), 2) +
                                   std::ellint_1(k, angle) * std::pow(std::cos(angle), 2));
  p.volume = 4.0 / 3.0 * pi * a * b * c;
  return p;
}

/// Everything within half the thickness of a disc: flat on both sides, with a rim that is half a circle in section. λ
/// is half the thickness everywhere.
Phantom slab() {
  constexpr double disc = 20.0;
  constexpr double half = 4.0;
  const auto from_disc = [](const Vector3d& x) {
    return std::hypot(std::max(0.0, std::hypot(x[0], x[1]) - disc), x[2]);
  };
  Phantom p;
  p.name = "slab";
  p.title = "Round slab, 8 mm thick, 48 mm across, with a rounded rim";
  p.function = [from_disc](const Vector3d& x) { return half - from_disc(x); };
  p.half_extent = {disc + half, disc + half, half};
  p.feature_size = from_disc;
  p.area = 2.0 * pi * disc * disc + 2.0 * pi * pi * disc * half + 4.0 * pi * half * half;
  p.volume = 2.0 * pi * disc * disc * half + pi * pi * disc * half * half + 4.0 / 3.0 * pi * half * half * half;
  return p;
}

Phantom two_spheres() {
  Phantom p = sphere_pair(10.0, 5.0);
  p.name = "two-spheres";
  p.title = "Two spheres of radius 10 mm, 5 mm apart";
  return p;
}

Phantom capsule() {
  constexpr double half = 14.0;
  constexpr double r = 9.0;
  const auto from_segment = [](const Vector3d& x) {
    return Vector3d(std::max(0.0, std::abs(x[0]) - half), x[1], x[2]).norm();
  };
  Phantom p;
  p.name = "capsule";
  p.title = "Capsule, 28 mm between the centres of its caps, radius 9 mm";
  p.function = [from_segment](const Vector3d& x) { return r - from_segment(x); };
  p.half_extent = {half + r, r, r};
  p.feature_size = from_segment;
  p.area = 4.0 * pi * r * half + 4.0 * pi * r * r;
  p.volume = 2.0 * pi * r * r * half + 4.0 / 3.0 * pi * r * r * r;
  return p;
}

/// The distance to the medial axis of the box |x_i| ≤ half_i, where half[2] is smallest. In the positive octant the
/// axis has a rectangle in the plane x_2 = 0, at depth half[2], and a sloping sheet for each pair of faces, which meet
/// in an edge: x_i = half_i − m, x_j = half_j − m, 0 ≤ x_k ≤ half_k − m at depth m. The squared distance to a sheet is
/// convex in m.
double distance_to_box_axis(const Vector3d& half, const Vector3d& x) {
  const Vector3d p = x.cwiseAbs();
  const Vector3d depth = half - p;
  double nearest = Vector3d(std::max(0.0, half[2] - depth[0]), std::max(0.0, half[2] - depth[1]), p[2]).squaredNorm();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const auto best_depth = [&](double m) { return std::clamp(m, 0.0, half[2]); };
    double m = best_depth(0.5 * (depth[i] + depth[j]));
    if (m > depth[k]) m = best_depth(depth.sum() / 3.0);
    nearest = std::min(nearest, Vector3d(depth[i] - m, depth[j] - m, std::max(0.0, m - depth[k])).squaredNorm());
  }
  return std::sqrt(nearest);
}

/// A box and everything within ρ of it (Meyer et al. 2007, figure 2). Its medial axis is that of the sharp box. λ on a
/// face at distance t from the edge of its flat part is √(ρ² + t²) for t ≤ ρ, (ρ + t)/√2 for larger t, and at most half
/// the thickness; on edges and corners it is ρ.
Phantom rounded_box() {
  constexpr double rounding = 5.0;
  const Vector3d half(17.0, 12.0, 7.0);
  Phantom p;
  p.name = "rounded-box";
  p.title = "Box of 44, 34 and 24 mm with edges rounded to 5 mm";
  p.function = [half](const Vector3d& x) {
    const Vector3d beyond = x.cwiseAbs() - half;
    return rounding - beyond.cwiseMax(0.0).norm() - std::min(0.0, beyond.maxCoeff());
  };
  p.half_extent = half + Vector3d::Constant(rounding);
  p.feature_size = [half](const Vector3d& x) { return distance_to_box_axis(half, x); };
  const Vector3d side = 2.0 * half;
  const double faces = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  p.area = 2.0 * faces + 2.0 * pi * side.sum() * rounding + 4.0 * pi * rounding * rounding;
  p.volume = side.prod() + 2.0 * faces * rounding + pi * side.sum() * rounding * rounding +
             4.0 / 3.0 * pi * rounding * rounding * rounding;
  return p;
}

/// The part of a ball on one side of a gyroid. The smooth minimum −w log(e^(−a/w) + e^(−b/w)) rounds the rims and makes
/// the function smooth near its zero set.
Phantom gyroid_ball() {
  constexpr double r = 24.0;
  const double wave = 2.0 * pi / 22.0;
  constexpr double width = 1.5;
  Phantom p;
  p.name = "gyroid-ball";
  p.title = "Gyroid labyrinth of period 22 mm in a ball of radius 24 mm";
  p.function = [wave](const Vector3d& x) {
    const Eigen::Array3d s = (wave * x).array().sin();
    const Eigen::Array3d c = (wave * x).array().cos();
    const double gyroid = s[0] * c[1] + s[1] * c[2] + s[2] * c[0];
    const double a = gyroid / (1.5 * wave);  // |∇ gyroid| on its zero set is between 1.2 and 1.7 times `wave`
    const double b = r - x.norm();
    const double least = std::min(a, b);
    return least - width * std::log1p(std::exp(-std::abs(a - b) / width));
  };
  p.exact_distance = false;
  p.half_extent = Vector3d::Constant(r);
  // Counted from the function's signs on Kuhn's tetrahedra. Lattices of 48, 64, 100 and 200 nodes along each axis
  // agree, and so does the B-spline's surface; phantoms_test.cpp repeats the count.
  p.euler = -24;
  p.components = 1;
  return p;
}

}  // namespace

const std::vector<Phantom>& phantoms() {
  static const std::vector<Phantom> all{sphere(),
                                        torus(),
                                        ellipsoid(),
                                        slab(),
                                        two_spheres(),
                                        capsule(),
                                        rounded_box(),
                                        gyroid_ball(),
                                        thin_sheets(2.0, 1.0),
                                        near_spheres(0.9),
                                        vessel_tree_phantom()};
  return all;
}

const Phantom& phantom(const std::string& name) {
  std::vector<std::string> names;
  for (const Phantom& p : phantoms()) {
    if (p.name == name) return p;
    names.push_back(p.name);
  }
  throw UsageError(fmt::format("there is no phantom '{}'{}", name, suggestion(name, names)));
}

Phantom phantom(const std::string& name, const std::map<std::string, double>& parameters) {
  const Phantom& usual = phantom(name);
  std::map<std::string, double> values;
  std::vector<std::string> names;
  for (const PhantomParameter& parameter : usual.parameters) {
    const auto given = parameters.find(parameter.name);
    const double value = given == parameters.end() ? parameter.value : given->second;
    if (!(value >= parameter.min && value <= parameter.max)) {
      throw UsageError(fmt::format("phantom '{}': {} must be {} to {} mm, not {}", name, parameter.name, parameter.min,
                                   parameter.max, value));
    }
    values[parameter.name] = value;
    names.push_back(parameter.name);
  }
  for (const auto& given : parameters) {
    if (values.count(given.first) == 0) {
      throw UsageError(
          fmt::format("phantom '{}' has no parameter '{}'{}", name, given.first, suggestion(given.first, names)));
    }
  }
  if (name == "thin-sheets") return thin_sheets(values.at("thickness"), values.at("gap"));
  if (name == "near-spheres") return near_spheres(values.at("gap"));
  return usual;
}

FloatVolume sample_phantom(const Phantom& phantom, int nodes, int margin) {
  const int cells = nodes - 2 - 2 * margin;
  if (margin < 0 || cells < 4) {
    throw UsageError(fmt::format(
        "phantom '{}': {} nodes with a margin of {} leave fewer than 4 cells across it; take at least {} nodes",
        phantom.name, nodes, margin, 6 + 2 * std::max(0, margin)));
  }
  const Vector3d off_centre(0.29, 0.41, 0.13);  // voxels
  const double spacing = 2.0 * phantom.half_extent.maxCoeff() / cells;
  FloatVolume volume;
  Lattice& lattice = volume.lattice;
  lattice.spacing = Vector3d::Constant(spacing);
  for (int axis = 0; axis < 3; ++axis) {
    const double across = 2.0 * phantom.half_extent[axis] / spacing + off_centre[axis];
    lattice.size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(across - 1e-9)) + 2 * margin + 1;
    lattice.origin[axis] = -phantom.half_extent[axis] - (margin + off_centre[axis]) * spacing;
  }
  volume.samples.resize(lattice.nodes());
  tbb::parallel_for(0, lattice.size[2], [&](int k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i) {
        volume.at(i, j, k) = static_cast<float>(phantom.function(lattice.to_world(Vector3d(i, j, k) * spacing)));
      }
    }
  });
  return volume;
}

}  // namespace isobench
