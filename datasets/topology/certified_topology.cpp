#include "isobench/datasets/topology/certified_topology.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "isobench/foundation/union_find.h"

namespace isobench {

namespace {

/// A node of a layer's trees; without a layer, the outside of the lattice.
struct TreePlace {
  const CellLayer* layer = nullptr;
  std::uint32_t node = 0;
  int depth = -1;

  bool is_outside() const { return layer == nullptr; }
  const TreeNode& get() const { return layer->nodes[node]; }
  bool is_leaf() const { return is_outside() || !get().is_cut; }
  bool is_without_surface() const { return !is_outside() && !get().is_cut && get().kind == BoxKind::without_surface; }
  bool is_inside(unsigned corner) const { return (get().inside >> corner & 1U) != 0; }
  TreePlace part(unsigned number) const { return is_leaf() ? *this : TreePlace{layer, get().next + number, depth + 1}; }
};

/// A disc: the k of its layer, and its number in it.
using Disc = std::pair<int, std::uint32_t>;

struct LayerCount {
  std::vector<int> euler;                     // of each disc: 1, less its arcs, plus its points
  std::vector<std::pair<Disc, Disc>> joined;  // discs on both sides of an arc
  bool is_open = false;
};

/// Counts the arcs and points of one layer. It visits each smallest face and edge once, by descending into all boxes
/// around it at the same time (as Ju, Losasso, Schaefer, Warren 2002, Dual contouring of Hermite data, do).
class Counter {
 public:
  Counter(const std::vector<CellLayer>& layers, const std::array<int, 3>& cells, int k)
      : layers_(layers), cells_(cells), k_(k) {
    const std::size_t columns = static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]);
    for (const int from : {0, 1}) {
      if (k - from < 0) continue;
      std::vector<std::int32_t>& index = index_[static_cast<std::size_t>(from)];
      index.assign(columns, -1);
      const CellLayer& layer = layers[static_cast<std::size_t>(k - from)];
      for (std::size_t n = 0; n < layer.cells.size(); ++n) index[layer.cells[n]] = static_cast<std::int32_t>(n);
    }
    count_.euler.assign(layers[static_cast<std::size_t>(k)].discs, 1);
  }

  LayerCount run() {
    const CellLayer& layer = layers_[static_cast<std::size_t>(k_)];
    for (std::size_t n = 0; n < layer.cells.size(); ++n) {
      const int i = static_cast<int>(layer.cells[n]) % cells_[0];
      const int j = static_cast<int>(layer.cells[n]) / cells_[0];
      within({&layer, layer.roots[n], 0});
      faces_and_edges({i, j, k_});
    }
    return std::move(count_);
  }

 private:
  /// The cell's tree, the outside, or nothing where F = c does not cross the cell.
  struct Neighbour {
    TreePlace place;
    bool has_surface = true;
  };
  Neighbour at(const std::array<int, 3>& cell) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= cells_[axis]) return {};
    }
    const auto from = static_cast<std::size_t>(k_ - cell[2]);
    const auto column = static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(cells_[0]);
    const std::int32_t n = index_[from][column + static_cast<std::size_t>(cell[0])];
    if (n < 0) return {{}, false};
    const CellLayer& layer = layers_[static_cast<std::size_t>(cell[2])];
    return {{&layer, layer.roots[static_cast<std::size_t>(n)], 0}, true};
  }

  // For each cell, the faces and edges on its low sides, and those on the lattice's high border.
  void faces_and_edges(const std::array<int, 3>& cell) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto u = static_cast<std::size_t>((axis + 1) % 3);
      const auto v = static_cast<std::size_t>((axis + 2) % 3);
      const auto a = static_cast<std::size_t>(axis);
      for (int side = 0; side <= last_side(cell, a); ++side) {
        const Neighbour low = at(moved(cell, a, side - 1));
        const Neighbour high = at(moved(cell, a, side));
        if (low.has_surface && high.has_surface) face(axis, low.place, high.place);
      }
      for (int at_u = 0; at_u <= last_side(cell, u); ++at_u) {
        for (int at_v = 0; at_v <= last_side(cell, v); ++at_v) {
          std::array<TreePlace, 4> around;
          bool has_surface = true;
          for (int q = 0; q < 4; ++q) {
            const Neighbour next = at(moved(moved(cell, u, at_u - 1 + (q & 1)), v, at_v - 1 + (q >> 1)));
            has_surface = has_surface && next.has_surface;
            around[static_cast<std::size_t>(q)] = next.place;
          }
          if (has_surface) edge(axis, around);
        }
      }
    }
  }
  /// Sides are 0, the low one, and 1, the high one, which belongs to the cell only on the lattice's border.
  int last_side(const std::array<int, 3>& cell, std::size_t axis) const {
    return cell[axis] + 1 == cells_[axis] ? 1 : 0;
  }
  static std::array<int, 3> moved(std::array<int, 3> cell, std::size_t axis, int by) {
    cell[axis] += by;
    return cell;
  }

  void within(const TreePlace& place) {
    if (place.is_leaf()) return;
    for (unsigned part = 0; part < 8; ++part) within(place.part(part));
    for (int axis = 0; axis < 3; ++axis) {
      const unsigned a = 1U << axis;
      const unsigned u = 1U << (axis + 1) % 3;
      const unsigned v = 1U << (axis + 2) % 3;
      for (const unsigned p : {0U, u, v, u | v}) face(axis, place.part(p), place.part(p | a));
      for (const unsigned p : {0U, a})
        edge(axis, {place.part(p), place.part(p | u), place.part(p | v), place.part(p | u | v)});
    }
  }

  void face(int axis, const TreePlace& low, const TreePlace& high) {
    if (low.is_without_surface() || high.is_without_surface()) return;
    const unsigned a = 1U << axis;
    const unsigned u = 1U << (axis + 1) % 3;
    const unsigned v = 1U << (axis + 2) % 3;
    if (low.is_leaf() && high.is_leaf()) {
      const bool of_low = low.depth > high.depth;
      const TreePlace& finer = of_low ? low : high;
      const unsigned base = of_low ? a : 0U;
      const bool first = finer.is_inside(base);
      if (first == finer.is_inside(base | u) && first == finer.is_inside(base | v) &&
          first == finer.is_inside(base | u | v))
        return;
      const TreePlace& own = is_own(high) ? high : low;
      --count_.euler[own.get().next];
      if (low.is_outside() || high.is_outside())
        count_.is_open = true;
      else
        count_.joined.push_back({disc(low), disc(high)});
      return;
    }
    for (const unsigned p : {0U, u, v, u | v}) face(axis, low.part(p | a), high.part(p));
    // The edges between these four faces, along v and along u.
    for (const unsigned half : {0U, v})
      edge((axis + 2) % 3, {low.part(a | half), high.part(half), low.part(a | u | half), high.part(u | half)});
    for (const unsigned half : {0U, u})
      edge((axis + 1) % 3, {low.part(a | half), low.part(a | v | half), high.part(half), high.part(v | half)});
  }

  /// `around`: the places at the low and high side of the edge along the two other axes, in the order of axes axis + 1
  /// and axis + 2: number q is on the high side of the first if q has bit 1, and of the second if it has bit 2.
  void edge(int axis, const std::array<TreePlace, 4>& around) {
    bool leaves = true;
    std::size_t finest = 0;
    for (std::size_t q = 0; q < 4; ++q) {
      if (around[q].is_without_surface()) return;
      leaves = leaves && around[q].is_leaf();
      if (around[q].depth > around[finest].depth) finest = q;
    }
    const unsigned a = 1U << axis;
    const unsigned u = 1U << (axis + 1) % 3;
    const unsigned v = 1U << (axis + 2) % 3;
    const auto corner = [&](std::size_t q) { return ((q & 1U) != 0 ? 0U : u) | ((q & 2U) != 0 ? 0U : v); };
    if (leaves) {
      const TreePlace& finer = around[finest];
      if (finer.is_inside(corner(finest)) == finer.is_inside(corner(finest) | a)) return;
      for (const TreePlace& place : around) {
        if (!is_own(place)) continue;
        ++count_.euler[place.get().next];
        return;
      }
      return;
    }
    for (const unsigned half : {0U, a}) {
      std::array<TreePlace, 4> parts;
      for (std::size_t q = 0; q < 4; ++q) parts[q] = around[q].part(corner(q) | half);
      edge(axis, parts);
    }
  }

  bool is_own(const TreePlace& place) const { return place.layer == &layers_[static_cast<std::size_t>(k_)]; }
  Disc disc(const TreePlace& place) const { return {is_own(place) ? k_ : k_ - 1, place.get().next}; }

  const std::vector<CellLayer>& layers_;
  const std::array<int, 3> cells_;
  const int k_;
  std::array<std::vector<std::int32_t>, 2> index_;  // of the layer itself and of the one before
  LayerCount count_;
};

/// Counts, and returns the component of each disc.
std::vector<std::uint32_t> count(const Isosurface& surface, const std::vector<CellLayer>& layers, Monitor& monitor,
                                 CertifiedTopology& result) {
  const std::array<int, 3>& size = surface.lattice().size;
  std::vector<LayerCount> counts(layers.size());
  tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t k) {
    if (monitor.is_cancelled()) return;
    counts[k] = Counter(layers, {size[0] - 1, size[1] - 1, size[2] - 1}, static_cast<int>(k)).run();
  });
  monitor.check();
  std::vector<std::size_t> first(layers.size() + 1, 0);
  for (std::size_t k = 0; k < layers.size(); ++k) first[k + 1] = first[k] + layers[k].discs;
  UnionFind pieces(first.back());
  const auto number = [&first](const Disc& disc) {
    return static_cast<std::uint32_t>(first[static_cast<std::size_t>(disc.first)] + disc.second);
  };
  for (const LayerCount& of_layer : counts) {
    for (const auto& [a, b] : of_layer.joined) pieces.unite(number(a), number(b));
    result.is_open = result.is_open || of_layer.is_open;
  }
  std::vector<std::uint32_t> component(first.back(), 0);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    for (std::uint32_t d = 0; d < layers[k].discs; ++d) {
      const std::uint32_t n = number({static_cast<int>(k), d});
      const std::uint32_t root = pieces.find(n);
      if (root == n) {
        component[n] = static_cast<std::uint32_t>(result.components.size());
        result.components.emplace_back();
      }
      component[n] = component[root];
      SurfaceComponent& of = result.components[component[n]];
      of.euler += counts[k].euler[d];
      ++of.boxes;
    }
  }
  for (const SurfaceComponent& of : result.components) result.euler += of.euler;
  return component;
}

/// Counts at a value, with what is within `margin` of it.
bool count_at(const Isosurface& surface, double value, const Margins& margins, double cut_at, Monitor& monitor,
              CertifiedTopology& result) {
  auto layers = subdivide(surface, -value, margins, cut_at, monitor);
  if (!layers) return false;
  result.is_regular = true;
  std::vector<std::uint32_t> component = count(surface, *layers, monitor, result);
  result.boxes =
      std::make_shared<const SurfaceBoxes>(surface.lattice(), cut_at, std::move(*layers), std::move(component));
  return true;
}

}  // namespace

std::size_t CertifiedTopology::kept_components() const {
  const auto is_kept = [](const SurfaceComponent& component) { return !component.is_left_out; };
  return static_cast<std::size_t>(std::count_if(components.begin(), components.end(), is_kept));
}

double coefficient_range(const Isosurface& surface) {
  const auto [nx, ny, nz] = surface.lattice().size;
  float least = std::numeric_limits<float>::infinity();
  float most = -least;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const float c = surface.coefficient(i, j, k);
        least = std::min(least, c);
        most = std::max(most, c);
      }
    }
  }
  return static_cast<double>(most) - static_cast<double>(least);
}

CertifiedTopology certified_topology(const Isosurface& surface, Monitor& monitor, double cut_at, double value) {
  CertifiedTopology result;
  const double range = coefficient_range(surface);
  const Margins margins{same_value * range, rounding_of(range)};
  if (count_at(surface, value, margins, cut_at, monitor, result)) return result;
  // Either f takes the value at corners of boxes or touches their faces there, or it is a critical value. If a band
  // around it has no critical value, the surfaces of all values in the band have the same topology, and most of them
  // avoid corners and faces. Of the millions of boxes of a large rough surface, some always have a corner within a wide
  // margin: for them the margin is that of rounding.
  for (const double width : {1e-6, 1e-8, 2.0 * same_value}) {
    const double band = width * range;
    result.singular = singular_boxes(surface, value - band, value + band, margins.difference, cut_at, monitor);
    if (!result.singular.empty()) continue;
    for (const double margin : {0.01 * band, margins.difference}) {
      for (const double part : {0.618, -0.618, 0.377, -0.377, 0.854, -0.854, 0.146, -0.146}) {
        const Margins narrow{margin, margins.difference};
        if (!count_at(surface, value + part * band, narrow, cut_at, monitor, result)) continue;
        result.counted_at = part * band;
        return result;
      }
    }
  }
  return result;
}

}  // namespace isobench
