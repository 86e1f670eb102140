#include "isobench/methods/closing/outer_walk.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace isobench {

namespace {

/// A facet seen from one of its cells.
struct Side {
  std::uint32_t cell;
  std::uint32_t facet;
};

class Walk {
 public:
  Walk(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
       const std::vector<Eigen::Vector3d>& normals, const Cocone& cocone)
      : cells_(cells),
        points_(points),
        normals_(normals),
        cocone_(cocone),
        turn_(points.size(), 0),
        candidate_(4 * cells.size(), 0),
        piece_(4 * cells.size(), 0),
        walked_(4 * cells.size(), 0),
        kept_(4 * cells.size(), 0) {
    for (const Cocone::Facet& facet : cocone.facets) mark(candidate_, {facet.cell, facet.index}, char{1});
  }

  std::vector<char> run() {
    std::uint32_t pieces = 0;
    for (const Cocone::Facet& facet : cocone_.facets) {
      const Side first{facet.cell, facet.index};
      if (piece_[slot(first)] != 0) continue;
      const std::vector<Side> piece = piece_of(first, ++pieces);
      if (const auto start = outside_of(piece, pieces)) walk(*start);
    }
    return std::move(kept_);
  }

 private:
  static std::size_t slot(const Side& side) { return 4 * std::size_t{side.cell} + side.facet; }

  Side other(const Side& side) const {
    return {cells_.neighbours[side.cell][side.facet], static_cast<std::uint32_t>(cells_.mirror(side.cell, side.facet))};
  }

  template <typename Value>
  void mark(std::vector<Value>& values, const Side& side, Value value) const {
    values[slot(side)] = value;
    values[slot(other(side))] = value;
  }

  /// The next candidate around the edge that the facet shares with facet `to` of its cell, on the same side of the
  /// facet.
  Side next(Side side, std::uint32_t to) const {
    while (candidate_[4 * std::size_t{side.cell} + to] == 0) {
      const std::uint32_t stays = cells_.vertices[side.cell][side.facet];
      const Side beyond = other({side.cell, to});
      to = static_cast<std::uint32_t>(cells_.index_of(beyond.cell, stays));
      side = beyond;
    }
    return {side.cell, to};
  }

  /// The candidates connected to this one over edges, each from one side.
  std::vector<Side> piece_of(const Side& first, std::uint32_t number) {
    std::vector<Side> piece{first};
    mark(piece_, first, number);
    for (std::size_t n = 0; n < piece.size(); ++n) {
      for (std::uint32_t to = 0; to < 4; ++to) {
        if (to == piece[n].facet) continue;
        // Goes once around the edge.
        const Side start = piece[n];
        for (Side at = next(start, to); slot(at) != slot(other(start));) {
          if (piece_[slot(at)] == 0) {
            mark(piece_, at, number);
            piece.push_back(at);
          }
          const Side beyond = other(at);
          at = next(beyond, edge_side(beyond, start, to));
        }
      }
    }
    return piece;
  }

  /// Facet `to` of start's cell shares an edge with `start`. Returns the other facet of at's cell with this edge.
  std::uint32_t edge_side(const Side& at, const Side& start, std::uint32_t to) const {
    std::uint32_t result = 0;
    const auto& corners = cells_.vertices[start.cell];
    const auto on_edge = [&](std::uint32_t v) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (i != start.facet && i != to && corners[i] == v) return true;
      }
      return false;
    };
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (i != at.facet && !on_edge(cells_.vertices[at.cell][i])) result = i;
    }
    return result;
  }

  /// A facet of the piece at its lowest vertex (along x), seen from its outer side.
  std::optional<Side> outside_of(const std::vector<Side>& piece, std::uint32_t number) const {
    std::uint32_t lowest = DelaunayCells::infinite;
    for (const Side& side : piece) {
      for (const std::uint32_t v : cells_.facet(side.cell, side.facet)) {
        if (lowest == DelaunayCells::infinite || points_[v][0] < points_[lowest][0]) lowest = v;
      }
    }
    // Spreads around the vertex from the cell below it until it reaches a facet of the piece.
    std::vector<std::uint32_t> reached{cell_below(lowest)};
    for (std::size_t n = 0; n < reached.size(); ++n) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (cells_.vertices[reached[n]][i] == lowest) continue;
        if (piece_[slot({reached[n], i})] == number) return Side{reached[n], i};
        const std::uint32_t beyond = cells_.neighbours[reached[n]][i];
        if (std::find(reached.begin(), reached.end(), beyond) == reached.end()) reached.push_back(beyond);
      }
    }
    return std::nullopt;
  }

  /// The cell at a vertex into which the direction −x points; an infinite cell if that direction leaves the hull.
  std::uint32_t cell_below(std::uint32_t vertex) const {
    std::uint32_t best = cells_.around[vertex].front();
    double most = -1e-9;
    for (const std::uint32_t cell : cells_.around[vertex]) {
      if (cells_.is_infinite(cell)) {
        if (most < 0.0) best = cell;
        continue;
      }
      Eigen::Matrix3d edges;
      Eigen::Index column = 0;
      for (const std::uint32_t v : cells_.vertices[cell]) {
        if (v != vertex) edges.col(column++) = points_[v] - points_[vertex];
      }
      const double least = (edges.inverse() * -Eigen::Vector3d::UnitX()).normalized().minCoeff();
      if (least > most) {
        most = least;
        best = cell;
      }
    }
    return best;
  }

  /// Whether the walk may enter a side. If so, records the outer side at its flat vertices. Normals that are nearly in
  /// the plane of the facet do not count.
  bool turned_outwards(const Side& side) {
    const auto ends = cells_.facet(side.cell, side.facet);
    const Eigen::Vector3d out =
        -(points_[ends[1]] - points_[ends[0]]).cross(points_[ends[2]] - points_[ends[0]]).normalized();
    std::array<double, 3> cosines{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (cocone_.flat[ends[k]] == 0) continue;
      cosines[k] = out.dot(normals_[ends[k]]);
      if (cosines[k] * turn_[ends[k]] < -0.3) return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (turn_[ends[k]] == 0 && std::abs(cosines[k]) > 0.5) turn_[ends[k]] = cosines[k] > 0.0 ? 1 : -1;
    }
    return true;
  }

  void walk(const Side& start) {
    if (!turned_outwards(start)) return;
    // Breadth first, so that the outer side of a vertex is known before a detour can reach its inner side.
    std::vector<Side> open{start};
    walked_[slot(start)] = 1;
    for (std::size_t n = 0; n < open.size(); ++n) {
      const Side side = open[n];
      mark<char>(kept_, side, 1);
      for (std::uint32_t to = 0; to < 4; ++to) {
        if (to == side.facet) continue;
        const Side found = next(side, to);
        // At an edge with a single facet, the next candidate is the other side of the same facet.
        if (walked_[slot(found)] != 0 || slot(found) == slot(other(side)) || !turned_outwards(found)) continue;
        walked_[slot(found)] = 1;
        open.push_back(found);
      }
    }
  }

  const DelaunayCells& cells_;
  const std::vector<Eigen::Vector3d>& points_;
  const std::vector<Eigen::Vector3d>& normals_;
  const Cocone& cocone_;
  std::vector<signed char> turn_;  // flat vertices: 1 if the normal points outwards, −1 if inwards, 0 if not known yet
  std::vector<char> candidate_;
  std::vector<std::uint32_t> piece_;  // of each candidate: the number of its piece, from 1 on
  std::vector<char> walked_;          // sides, each by itself
  std::vector<char> kept_;
};

}  // namespace

std::vector<char> outer_manifold(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Eigen::Vector3d>& normals, const Cocone& cocone) {
  return Walk(cells, points, normals, cocone).run();
}

}  // namespace isobench
