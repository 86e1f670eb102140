#include "isobench/datasets/topology/regular_value.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::array<double, 3> shares = {1e-4, 1e-3, 1e-2};  // of the range, in this order

/// The largest curvature of f, 1/mm², at the singular places.
double largest_curvature(const Isosurface& surface, const std::vector<CellBox>& places) {
  double largest = 0.0;
  for (const CellBox& place : places) {
    const Jet jet = surface.jet(0.5 * (place.low + place.high));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(jet.hessian, Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues().cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Whether f is above `value` at a node of the lattice's border.
bool is_inside_at_border(const Isosurface& surface, double value) {
  const auto [nx, ny, nz] = surface.lattice().size;
  std::vector<float> slab;
  for (int k = 0; k < nz; ++k) {
    surface.node_values(k, slab);
    for (int j = 0; j < ny; ++j) {
      const bool whole_row = k == 0 || k == nz - 1 || j == 0 || j == ny - 1;
      const int step = whole_row ? 1 : std::max(nx - 1, 1);
      for (int i = 0; i < nx; i += step) {
        if (slab[surface.lattice().index(i, j, 0)] > value) return true;
      }
    }
  }
  return false;
}

class Search {
 public:
  Search(const Isosurface& surface, double narrowest, std::vector<CellBox> singular, Monitor& monitor)
      : surface_(surface),
        monitor_(monitor),
        narrowest_(narrowest * surface.voxel()),
        range_(coefficient_range(surface)),
        curvature_(largest_curvature(surface, singular)) {
    found_.singular = std::move(singular);
  }

  RegularValue run() {
    for (const double sign : {-1.0, 1.0}) {
      if (find_next_to_zero(sign)) return std::move(found_);
    }
    found_.passes_others = true;
    for (const double sign : {-1.0, 1.0}) {
      for (const double share : shares) {
        if (take(sign * share * range_)) return std::move(found_);
      }
    }
    if (unusable_) return std::move(*unusable_);
    throw DataError(
        fmt::format("isovalue {} is no regular value of F, and neither are those that were tried up to a hundredth of "
                    "the samples' range away; choose another isovalue, or smooth the volume",
                    surface_.isovalue()));
  }

 private:
  /// Whether f = `value` is a surface whose object stays away from the border. If its object reaches the border, as on
  /// one side of a plateau that does, or it is empty, it is kept for the case that there is none else.
  bool take(double value) {
    found_.topology = certified_topology(surface_, monitor_, usual_cut, value);
    found_.value = value;
    if (!found_.topology.is_regular) return false;
    if (!found_.topology.components.empty() && !is_inside_at_border(surface_, value)) return true;
    if (!unusable_) unusable_ = found_;
    return false;
  }

  /// Looks on one side of 0, as far as there is no further critical value.
  bool find_next_to_zero(double sign) {
    std::optional<double> widest;
    double before = shares.front() / 4.0;
    for (const double share : shares) {
      if (has_critical_value(sign * before * range_, sign * share * range_)) break;
      before = share;
      widest = sign * share * range_;
      if (width_at(share * range_) > narrowest_) break;
    }
    return widest && take(*widest);
  }

  bool has_critical_value(double from, double to) {
    return !singular_boxes(surface_, std::min(from, to), std::max(from, to), rounding_of(range_), usual_cut, monitor_)
                .empty();
  }

  double width_at(double away) const {
    if (curvature_ == 0.0) return std::numeric_limits<double>::infinity();
    return 2.0 * std::sqrt(2.0 * away / curvature_);
  }

  const Isosurface& surface_;
  Monitor& monitor_;
  const double narrowest_;  // mm
  const double range_;
  const double curvature_;
  RegularValue found_;
  std::optional<RegularValue> unusable_;
};

}  // namespace

RegularValue find_regular_value(const Isosurface& surface, double narrowest, Monitor& monitor) {
  RegularValue found;
  found.topology = certified_topology(surface, monitor);
  if (found.topology.is_regular) return found;
  return Search(surface, narrowest, std::move(found.topology.singular), monitor).run();
}

}  // namespace isobench
