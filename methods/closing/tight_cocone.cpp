#include "isobench/methods/closing/tight_cocone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "isobench/methods/closing/cocone.h"
#include "isobench/methods/closing/outer_walk.h"

namespace isobench {

namespace {

enum class Mark : char { none, outside, inside };

Mark opposite(Mark mark) { return mark == Mark::outside ? Mark::inside : Mark::outside; }

/// Whether the manifold's facets at a point form exactly one closed umbrella.
bool has_umbrella(const DelaunayCells& cells, const std::vector<char>& manifold, std::uint32_t point) {
  std::vector<std::array<std::uint32_t, 2>> spokes;  // the other two vertices of each facet
  for (const std::uint32_t cell : cells.around[point]) {
    for (std::size_t i = 0; i < 4; ++i) {
      // Takes each facet once, from the cell with the lower index.
      if (manifold[4 * std::size_t{cell} + i] == 0 || cells.neighbours[cell][i] < cell) continue;
      const auto ends = cells.facet(cell, i);
      const auto at = std::find(ends.begin(), ends.end(), point);
      if (at == ends.end()) continue;
      const auto k = static_cast<std::size_t>(at - ends.begin());
      spokes.push_back({ends[(k + 1) % 3], ends[(k + 2) % 3]});
    }
  }
  if (spokes.size() < 3) return false;
  // Goes from facet to facet around the point. All facets must come before the first one comes again.
  std::uint32_t end = spokes[0][1];
  std::size_t at = 0;
  for (std::size_t steps = 1; steps < spokes.size(); ++steps) {
    std::size_t next = spokes.size();
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      if (s == at || (spokes[s][0] != end && spokes[s][1] != end)) continue;
      if (next != spokes.size()) return false;  // three facets share an edge
      next = s;
    }
    if (next == spokes.size() || next == 0) return false;
    end = spokes[next][0] == end ? spokes[next][1] : spokes[next][0];
    at = next;
  }
  return end == spokes[0][0];
}

/// Marks cells as inside or outside: first from the umbrellas of good points, then by extending the outside.
class Sides {
 public:
  Sides(const DelaunayCells& cells, const std::vector<char>& manifold, const std::vector<char>& good)
      : cells_(cells), manifold_(manifold), good_(good), marks_(cells.size(), Mark::none), passed_(good.size(), 0) {}

  /// Spreads the marks from the infinite cells inwards. Returns the number of conflicts.
  std::size_t spread() {
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      if (cells_.is_infinite(cell)) set(cell, Mark::outside);
    }
    for (std::size_t n = 0; n < queue_.size(); ++n) {
      for (const std::uint32_t v : cells_.vertices[queue_[n]]) {
        if (v != DelaunayCells::infinite && good_[v] != 0 && passed_[v] == 0) pass(v, queue_[n]);
      }
    }
    return conflicts_;
  }

  /// Extends the outside through transparent cells. Returns the number of transparent cells.
  std::size_t peel(const std::vector<Eigen::Vector3d>& points) {
    std::vector<std::uint32_t> open;
    std::size_t transparent_cells = 0;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      transparent_cells += transparent(cell) ? 1 : 0;
      if (marks_[cell] == Mark::outside) open.push_back(cell);
    }
    while (!open.empty()) {
      const std::uint32_t cell = open.back();
      open.pop_back();
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t beyond = cells_.neighbours[cell][i];
        if (marks_[beyond] == Mark::outside || !transparent(beyond)) continue;
        if (opaque_facet(beyond, points) == cells_.mirror(cell, i)) continue;
        if (transparent(cell) && opaque_facet(cell, points) == i) continue;
        marks_[beyond] = Mark::outside;
        open.push_back(beyond);
      }
    }
    return transparent_cells;
  }

  std::vector<Triangle> boundary() const {
    std::vector<Triangle> triangles;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      if (marks_[cell] == Mark::outside) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        if (marks_[cells_.neighbours[cell][i]] == Mark::outside) triangles.push_back(cells_.facet(cell, i));
      }
    }
    return triangles;
  }

 private:
  void set(std::uint32_t cell, Mark mark) {
    if (marks_[cell] == Mark::none) {
      marks_[cell] = mark;
      queue_.push_back(cell);
    } else if (marks_[cell] != mark) {
      ++conflicts_;
    }
  }

  /// The umbrella of a good point separates its cells: those on the side of `from` get its mark, the others the
  /// opposite.
  void pass(std::uint32_t point, std::uint32_t from) {
    passed_[point] = 1;
    const Mark mark = marks_[from];
    std::vector<std::uint32_t> same{from};
    for (std::size_t n = 0; n < same.size(); ++n) {
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t beyond = cells_.neighbours[same[n]][i];
        if (cells_.vertices[same[n]][i] == point || manifold_[4 * std::size_t{same[n]} + i] != 0) continue;
        if (std::find(same.begin(), same.end(), beyond) == same.end()) same.push_back(beyond);
      }
    }
    for (const std::uint32_t cell : cells_.around[point]) {
      const bool on_this_side = std::find(same.begin(), same.end(), cell) != same.end();
      set(cell, on_this_side ? mark : opposite(mark));
    }
  }

  bool transparent(std::uint32_t cell) const {
    return std::none_of(cells_.vertices[cell].begin(), cells_.vertices[cell].end(),
                        [&](std::uint32_t v) { return v == DelaunayCells::infinite || good_[v] != 0; });
  }

  /// The facet with the smallest circumradius.
  std::size_t opaque_facet(std::uint32_t cell, const std::vector<Eigen::Vector3d>& points) const {
    std::size_t smallest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [a, b, c] = cells_.facet(cell, i);
      const Eigen::Vector3d u = points[b] - points[a];
      const Eigen::Vector3d v = points[c] - points[a];
      const double radius = u.norm() * v.norm() * (u - v).norm() / u.cross(v).norm();
      if (radius < least) {
        least = radius;
        smallest = i;
      }
    }
    return smallest;
  }

  const DelaunayCells& cells_;
  const std::vector<char>& manifold_;
  const std::vector<char>& good_;
  std::vector<Mark> marks_;
  std::vector<char> passed_;          // points whose umbrella has been used
  std::vector<std::uint32_t> queue_;  // marked cells, in order
  std::size_t conflicts_ = 0;
};

TightCocone close_cells(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                        const std::vector<Eigen::Vector3d>& normals, Monitor& monitor) {
  TightCocone result;
  const Cocone pieces = cocone(cells, points, normals);
  monitor.progress(0.7);
  result.candidates = pieces.candidates;
  result.pruned = pieces.candidates - pieces.facets.size();
  result.undersampled = static_cast<std::size_t>(std::count(pieces.flat.begin(), pieces.flat.end(), 0));
  const std::vector<char> manifold = outer_manifold(cells, points, normals, pieces);
  monitor.progress(0.8);
  std::vector<char> good(points.size(), 0);
  for (std::uint32_t p = 0; p < points.size(); ++p) good[p] = has_umbrella(cells, manifold, p) ? 1 : 0;
  result.bad = static_cast<std::size_t>(std::count(good.begin(), good.end(), 0));
  Sides sides(cells, manifold, good);
  result.conflicts = sides.spread();
  result.transparent = sides.peel(points);
  result.triangles = sides.boundary();
  return result;
}

}  // namespace

TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, Monitor& monitor) {
  const DelaunayCells cells = delaunay_cells(points);
  monitor.progress(0.4);
  return close_cells(cells, points, pole_normals(cells, points), monitor);
}

TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                         Monitor& monitor) {
  const DelaunayCells cells = delaunay_cells(points);
  monitor.progress(0.4);
  return close_cells(cells, points, normals, monitor);
}

}  // namespace isobench
