#include "isobench/methods/closing/cocone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isobench {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
// The sine of the cocone's angle to the tangent plane, π/8.
const double cocone_sine = std::cos(3.0 * std::numbers::pi / 8.0);
constexpr double least_height = 1.2;     // of the Voronoi cell of a flat point, times its width
constexpr double least_agreement = 0.5;  // cosine between the normals of flat neighbours
constexpr double least_wedge = std::numbers::pi / 3.0;

/// The Voronoi edge dual to a facet of a finite cell: from the centre of the cell to the point `far`; if `ray`, endless
/// in the direction `far`.
struct DualEdge {
  Eigen::Vector3d from;
  Eigen::Vector3d far;
  bool ray;
};

DualEdge dual_of(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points, std::size_t cell,
                 std::size_t facet) {
  const std::size_t beyond = cells.neighbours[cell][facet];
  if (!cells.is_infinite(beyond)) return {cells.centres[cell], cells.centres[beyond], false};
  const auto [a, b, c] = cells.facet(cell, facet);
  return {cells.centres[cell], (points[b] - points[a]).cross(points[c] - points[a]).normalized(), true};
}

/// Calls visit(cell, facet) once for every finite facet at a point, from a finite cell.
template <typename Visit>
void for_each_facet_at(const DelaunayCells& cells, std::uint32_t point, Visit visit) {
  for (const std::uint32_t cell : cells.around[point]) {
    if (cells.is_infinite(cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      if (cells.vertices[cell][i] == point) continue;
      const std::uint32_t beyond = cells.neighbours[cell][i];
      if (cell < beyond || cells.is_infinite(beyond)) visit(cell, i);
    }
  }
}

/// Whether part of a dual edge, seen from x, is within the cocone around the plane normal to n. The sets above and
/// below the cocone are convex, so an edge with both ends in one of them does not pass the cocone.
bool passes_cocone(const DualEdge& edge, const Eigen::Vector3d& x, const Eigen::Vector3d& n) {
  const double first = (edge.from - x).normalized().dot(n);
  const double second = edge.ray ? edge.far.dot(n) : (edge.far - x).normalized().dot(n);
  return std::min(first, second) <= cocone_sine && std::max(first, second) >= -cocone_sine;
}

/// Whether the Voronoi cell of a point is high enough on both sides for its width.
bool is_high(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points, std::uint32_t point,
             const Eigen::Vector3d& n) {
  const Eigen::Vector3d& x = points[point];
  double above = 0.0;
  double below = 0.0;
  double width = 0.0;
  const auto reach = [&](double height, double distance) {
    if (height > 0.0) above = std::max(above, distance);
    if (height < 0.0) below = std::max(below, distance);
  };
  for_each_facet_at(cells, point, [&](std::size_t cell, std::size_t facet) {
    const DualEdge edge = dual_of(cells, points, cell, facet);
    const Eigen::Vector3d along = edge.ray ? edge.far : Eigen::Vector3d(edge.far - edge.from);
    const double start = (edge.from - x).dot(n);
    const double slope = along.dot(n);
    reach(start, (edge.from - x).norm());
    if (edge.ray)
      reach(slope, endless);
    else
      reach(start + slope, (edge.far - x).norm());
    const double t = -start / slope;  // where the edge meets the tangent plane
    if (std::isfinite(t) && t >= 0.0 && (edge.ray || t <= 1.0)) {
      width = std::max(width, (edge.from + t * along - x).norm());
    }
  });
  return least_height * width <= std::min(above, below);
}

bool neighbours_agree(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                      const std::vector<Eigen::Vector3d>& normals, std::uint32_t point) {
  bool agree = true;
  for_each_facet_at(cells, point, [&](std::size_t cell, std::size_t facet) {
    if (!agree || !passes_cocone(dual_of(cells, points, cell, facet), points[point], normals[point])) return;
    for (const std::uint32_t other : cells.facet(cell, facet)) {
      agree = agree && std::abs(normals[point].dot(normals[other])) >= least_agreement;
    }
  });
  return agree;
}

bool is_candidate(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                  const std::vector<Eigen::Vector3d>& normals, const std::vector<char>& flat, std::size_t cell,
                  std::size_t facet) {
  const DualEdge edge = dual_of(cells, points, cell, facet);
  const auto ends = cells.facet(cell, facet);
  const bool any_flat = std::any_of(ends.begin(), ends.end(), [&](std::uint32_t v) { return flat[v] != 0; });
  return std::all_of(ends.begin(), ends.end(), [&](std::uint32_t v) {
    return (any_flat && flat[v] == 0) || passes_cocone(edge, points[v], normals[v]);
  });
}

/// Removes facets at sharp edges until no edge is sharp.
class Pruning {
 public:
  Pruning(const std::vector<Eigen::Vector3d>& points, const std::vector<char>& flat,
          const std::vector<Cocone::Facet>& facets)
      : points_(points), flat_(flat), facets_(facets), alive_(facets.size(), 1), edge_of_(facets.size()) {
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(facets[f].ends[k], facets[f].ends[(k + 1) % 3]);
        sides_.push_back({low, high, facets[f].ends[(k + 2) % 3], f});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    std::vector<std::size_t> filled(facets.size(), 0);
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      if (s == 0 || !sides_[s].same_edge(sides_[s - 1])) first_.push_back(s);
      const std::uint32_t f = sides_[s].facet;
      edge_of_[f][filled[f]++] = static_cast<std::uint32_t>(first_.size() - 1);
    }
    first_.push_back(static_cast<std::uint32_t>(sides_.size()));
  }

  std::vector<Cocone::Facet> run() {
    std::vector<std::uint32_t> edges(first_.size() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e) edges[e] = e;
    while (!edges.empty()) {
      const std::uint32_t edge = edges.back();
      edges.pop_back();
      if (!sharp(edge)) continue;
      for (std::uint32_t s = first_[edge]; s < first_[edge + 1]; ++s) {
        const std::uint32_t f = sides_[s].facet;
        if (alive_[f] == 0) continue;
        alive_[f] = 0;
        edges.insert(edges.end(), edge_of_[f].begin(), edge_of_[f].end());
      }
    }
    std::vector<Cocone::Facet> kept;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (alive_[f] != 0) kept.push_back(facets_[f]);
    }
    return kept;
  }

 private:
  struct Side {
    std::uint32_t low, high, opposite, facet;
    bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
    bool operator<(const Side& other) const {
      if (low != other.low) return low < other.low;
      return high != other.high ? high < other.high : facet < other.facet;
    }
  };

  bool sharp(std::uint32_t edge) const {
    const Side& any = sides_[first_[edge]];
    if (flat_[any.low] == 0 || flat_[any.high] == 0) return false;
    const Eigen::Vector3d along = (points_[any.high] - points_[any.low]).normalized();
    const Eigen::Vector3d u = along.unitOrthogonal();
    const Eigen::Vector3d v = along.cross(u);
    std::vector<double> angles;
    for (std::uint32_t s = first_[edge]; s < first_[edge + 1]; ++s) {
      if (alive_[sides_[s].facet] == 0) continue;
      const Eigen::Vector3d to = points_[sides_[s].opposite] - points_[any.low];
      angles.push_back(std::atan2(v.dot(to), u.dot(to)));
    }
    if (angles.size() < 2) return false;
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2.0 * std::numbers::pi - angles.back();
    for (std::size_t a = 1; a < angles.size(); ++a) gap = std::max(gap, angles[a] - angles[a - 1]);
    return gap > 2.0 * std::numbers::pi - least_wedge;
  }

  const std::vector<Eigen::Vector3d>& points_;
  const std::vector<char>& flat_;
  const std::vector<Cocone::Facet>& facets_;
  std::vector<char> alive_;
  std::vector<std::array<std::uint32_t, 3>> edge_of_;  // edges of each facet
  std::vector<Side> sides_;                            // sorted by edge
  std::vector<std::uint32_t> first_;                   // first side of each edge
};

}  // namespace

std::vector<Eigen::Vector3d> pole_normals(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::UnitX());
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    Eigen::Vector3d hull = Eigen::Vector3d::Zero();
    Eigen::Vector3d pole = Eigen::Vector3d::Zero();
    for (const std::uint32_t cell : cells.around[p]) {
      if (cells.is_infinite(cell)) {
        // An infinite cell sees the hull's facet with the opposite orientation.
        const auto [a, b, c] = cells.facet(cell, cells.index_of(cell, DelaunayCells::infinite));
        hull -= (points[b] - points[a]).cross(points[c] - points[a]).normalized();
      } else if ((cells.centres[cell] - points[p]).squaredNorm() > pole.squaredNorm()) {
        pole = cells.centres[cell] - points[p];
      }
    }
    const Eigen::Vector3d& towards = hull.squaredNorm() > 0.0 ? hull : pole;
    if (towards.squaredNorm() > 0.0) normals[p] = towards.normalized();
  }
  return normals;
}

Cocone cocone(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
              const std::vector<Eigen::Vector3d>& normals) {
  Cocone result;
  result.flat.assign(points.size(), 0);
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    const bool flat = is_high(cells, points, p, normals[p]) && neighbours_agree(cells, points, normals, p);
    result.flat[p] = flat ? 1 : 0;
  }
  std::vector<Cocone::Facet> candidates;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.is_infinite(cell)) continue;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t beyond = cells.neighbours[cell][i];
      if (beyond < cell && !cells.is_infinite(beyond)) continue;
      if (is_candidate(cells, points, normals, result.flat, cell, i)) {
        candidates.push_back({cell, i, cells.facet(cell, i)});
      }
    }
  }
  result.candidates = candidates.size();
  result.facets = Pruning(points, result.flat, candidates).run();
  return result;
}

}  // namespace isobench
