#include "isobench/methods/sizing/critical_points/critical_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "isobench/methods/sizing/critical_points/hidden_cells.h"

namespace isobench {

namespace {

using Eigen::Vector3d;

/// The cell whose lowest corner is a given node.
struct Cell {
  Cell(const Lattice& lattice, const std::array<int, 3>& node)
      : low(lattice.spacing.cwiseProduct(Vector3d(node[0], node[1], node[2]))),
        high(low + lattice.spacing),
        size(lattice.spacing.minCoeff()) {}

  Vector3d low;
  Vector3d high;
  double size;  // shortest side

  Vector3d middle() const { return 0.5 * (low + high); }
  /// The low faces belong to the cell, the high faces to the next cells.
  bool contains(const Vector3d& x) const {
    return (x.array() >= low.array()).all() && (x.array() < high.array()).all();
  }
  bool is_near(const Vector3d& x) const {
    const Vector3d margin = 0.5 * (high - low);
    return (x.array() >= (low - margin).array()).all() && (x.array() <= (high + margin).array()).all();
  }
};

/// A step of Newton's method for ∇f = 0.
std::optional<Vector3d> newton_step(const Jet& jet) {
  Eigen::Matrix3d inverse;
  bool invertible = false;
  jet.hessian.computeInverseWithCheck(inverse, invertible, 1e-300);
  if (!invertible) return std::nullopt;
  const Vector3d step = -inverse * jet.gradient;
  return step.allFinite() ? std::optional(step) : std::nullopt;
}

std::optional<Vector3d> root_from(const Isosurface& surface, const Cell& cell, Vector3d x) {
  constexpr int most_steps = 12;
  constexpr double tolerance = 1e-7;
  for (int n = 0; n < most_steps; ++n) {
    auto step = newton_step(surface.jet(x));
    if (!step) return std::nullopt;
    const double length = step->norm();
    if (length > 0.5 * cell.size) *step *= 0.5 * cell.size / length;
    x += *step;
    if (!cell.is_near(x)) return std::nullopt;
    if (length < tolerance * cell.size) return cell.contains(x) ? std::optional(x) : std::nullopt;
  }
  return std::nullopt;
}

CriticalPoint described(const Isosurface& surface, const Vector3d& x) {
  CriticalPoint point;
  point.position = x;
  const Jet jet = surface.jet(x);
  point.value = jet.value;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(jet.hessian, Eigen::EigenvaluesOnly);
  double bend = 0.0;
  for (const double eigenvalue : solver.eigenvalues()) {
    if (eigenvalue < 0.0) ++point.falling;
    if (eigenvalue * jet.value < 0.0) bend = std::max(bend, std::abs(eigenvalue));
  }
  point.distance = bend > 0.0 ? std::sqrt(2.0 * std::abs(jet.value) / bend) : std::numeric_limits<double>::infinity();
  return point;
}

/// Whether ∇f can be 0 in the cell whose lowest corner is the node. The components of ∇f are weighted means, with
/// positive weights, of differences between neighbouring coefficients. If these differences have one sign along an
/// axis, ∇f is not 0.
bool gradient_may_vanish(const Isosurface& surface, const std::array<int, 3>& node) {
  std::array<float, 64> taps{};
  auto* out = taps.data();
  for (int k = -1; k < 3; ++k) {
    for (int j = -1; j < 3; ++j) {
      for (int i = -1; i < 3; ++i) *out++ = surface.coefficient(node[0] + i, node[1] + j, node[2] + k);
    }
  }
  for (const std::size_t step : {std::size_t{1}, std::size_t{4}, std::size_t{16}}) {
    int rising = 0;
    int falling = 0;
    for (std::size_t n = 0; n < taps.size(); ++n) {
      if (n / step % 4 == 3) continue;
      rising += taps[n + step] > taps[n] ? 1 : 0;
      falling += taps[n + step] < taps[n] ? 1 : 0;
    }
    constexpr int differences = 48;
    if (rising == differences || falling == differences) return false;
  }
  return true;
}

std::vector<CriticalPoint> points_in(const Isosurface& surface, const std::array<int, 3>& node, double reach) {
  const Cell cell(surface.lattice(), node);
  std::vector<CriticalPoint> found;
  const Vector3d middle = cell.middle();
  // F is cubic in each coordinate. If Newton's first step leads far out of the cell, there is no root in it.
  const auto first = newton_step(surface.jet(middle));
  if (first && !(first->cwiseAbs().array() < 1.5 * (cell.high - cell.low).array()).all()) return found;
  if (!gradient_may_vanish(surface, node)) return found;
  for (int start = 0; start < 9; ++start) {
    Vector3d x = middle;
    if (start > 0) {
      const int eighth = start - 1;
      const Vector3d side((eighth & 1) != 0 ? 0.25 : -0.25, (eighth & 2) != 0 ? 0.25 : -0.25,
                          (eighth & 4) != 0 ? 0.25 : -0.25);
      x += side.cwiseProduct(cell.high - cell.low);
    }
    const auto root = root_from(surface, cell, x);
    if (!root) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const CriticalPoint& other) {
      return (other.position - *root).norm() < 1e-4 * cell.size;
    });
    if (!known) found.push_back(described(surface, *root));
  }
  std::erase_if(found, [reach](const CriticalPoint& point) { return !(point.distance < reach); });
  return found;
}

using InCells = std::vector<std::vector<CriticalPoint>>;

InCells near_the_surface(const Isosurface& surface, const Band& band, double reach) {
  InCells found(band.size());
  const std::array<int, 3>& size = surface.lattice().size;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, band.size(), 512), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto& [i, j, k] = band.node(n);
      if (i + 1 >= size[0] || j + 1 >= size[1] || k + 1 >= size[2]) continue;
      found[n] = points_in(surface, band.node(n), reach);
    }
  });
  return found;
}

InCells extrema_of_hidden_cells(const Isosurface& surface) {
  const std::vector<std::array<int, 3>> cells = hidden_cells(surface);
  InCells found(cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 64), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      found[n] = points_in(surface, cells[n], std::numeric_limits<double>::infinity());
      const bool corners_inside = surface.value(Cell(surface.lattice(), cells[n]).low) > 0.0;
      std::erase_if(found[n], [corners_inside](const CriticalPoint& point) {
        return corners_inside ? point.falling != 0 || point.value > 0.0 : point.falling != 3 || !(point.value > 0.0);
      });
    }
  });
  return found;
}

/// Adds the points that are not in `all` yet. A point on the face between two cells may be found from both.
void add(const InCells& found, double voxel, std::vector<CriticalPoint>& all) {
  const double same = 1e-4 * voxel;
  for (const auto& in_cell : found) {
    for (const CriticalPoint& point : in_cell) {
      const bool known = std::any_of(all.begin(), all.end(), [&](const CriticalPoint& other) {
        return (other.position - point.position).norm() < same;
      });
      if (!known) all.push_back(point);
    }
  }
}

}  // namespace

std::vector<CriticalPoint> critical_points(const Isosurface& surface, const Band& band, double reach) {
  std::vector<CriticalPoint> all;
  add(near_the_surface(surface, band, reach), surface.voxel(), all);
  add(extrema_of_hidden_cells(surface), surface.voxel(), all);
  return all;
}

}  // namespace isobench
