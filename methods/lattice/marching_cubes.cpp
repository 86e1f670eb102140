#include "isobench/methods/lattice/marching_cubes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vtkMarchingCubesTriangleCases.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "isobench/foundation/error.h"
#include "isobench/methods/lattice/lattice_signs.h"

namespace isobench {
namespace {

/// The triangles of each case of VTK, as triples of cell edges.
struct Cases {
  std::array<int, 256> triangles{};
  std::array<std::array<int, 15>, 256> edges{};

  Cases() {
    const vtkMarchingCubesTriangleCases* cases = vtkMarchingCubesTriangleCases::GetCases();
    for (std::size_t c = 0; c < 256; ++c) {
      std::size_t n = 0;
      for (; n < 15 && cases[c].edges[n] >= 0; ++n) edges[c][n] = cases[c].edges[n];
      triangles[c] = static_cast<int>(n / 3);
    }
  }
};

const Cases& cases() {
  static const Cases table;
  return table;
}

/// The vertex numbers of the crossed edges of one slab, indexed by the first node of the edge. Only entries of crossed
/// edges are written or read, so they are not cleared between slabs.
struct SlabEdges {
  std::vector<std::uint32_t> x, y;
  explicit SlabEdges(std::size_t nodes) : x(nodes), y(nodes) {}
};

/// The numbers of vertices and triangles in the slabs before slab k. In slab k, the vertices on its x- and y-edges
/// come first, row by row; then the vertices on the z-edges to slab k + 1.
struct Numbering {
  std::vector<std::size_t> vertices, z_vertices, triangles;
};

/// A root in [0, 1] of the cubic with these values at 0, 1/3, 2/3 and 1, by Newton steps within a bracket.
double cubic_root(const std::array<double, 4>& v) {
  if (v[0] == 0.0) return 0.0;
  if (v[3] == 0.0) return 1.0;
  // node_values rounds to float, so an end very close to zero may have the other sign in double. That end is the root.
  if ((v[0] > 0.0) == (v[3] > 0.0)) return std::abs(v[0]) <= std::abs(v[3]) ? 0.0 : 1.0;
  const double a = 4.5 * (v[3] - 3.0 * v[2] + 3.0 * v[1] - v[0]);
  const double b = 4.5 * (2.0 * v[0] - 5.0 * v[1] + 4.0 * v[2] - v[3]);
  const double c = v[3] - v[0] - a - b;
  double low = 0.0, high = 1.0;
  double t = v[0] / (v[0] - v[3]);
  for (int step = 0; step < 100; ++step) {
    const double value = ((a * t + b) * t + c) * t + v[0];
    const double newton = t - value / ((3.0 * a * t + 2.0 * b) * t + c);
    if (value == 0.0 || std::abs(newton - t) < 1e-14) break;
    ((value > 0.0) == (v[0] > 0.0) ? low : high) = t;
    t = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return t;
}

class Extractor {
 public:
  Extractor(const Isosurface& surface, Monitor& monitor)
      : surface_(surface), monitor_(monitor), signs_(surface, monitor), nx_(static_cast<std::size_t>(signs_.nx())) {}

  TriangleMesh mesh() {
    count();
    mesh_.vertices.resize(numbering_.vertices.back());
    mesh_.triangles.resize(numbering_.triangles.back());
    monitor_.progress(0.3);
    tbb::parallel_for(tbb::blocked_range<int>(0, signs_.nz(), 8), [&](const auto& slabs) { fill(slabs); });
    monitor_.progress(1.0);
    return std::move(mesh_);
  }

 private:
  /// Counts the vertices and triangles of each slab and converts the counts to first numbers.
  void count() {
    const auto slabs = static_cast<std::size_t>(signs_.nz());
    std::vector<std::size_t> plane(slabs, 0), upright(slabs, 0), triangles(slabs, 0);
    tbb::parallel_for(std::size_t{0}, slabs, [&](std::size_t slab) {
      monitor_.check();
      const int k = static_cast<int>(slab);
      for_each_plane_edge(k, [&](int, int, int) { ++plane[slab]; });
      for_each_upright_edge(k, [&](int, int) { ++upright[slab]; });
      for_each_crossed_cell(k, [&](int i, int j) {
        triangles[slab] += static_cast<std::size_t>(cases().triangles[signs_.cell_case(i, j, k)]);
      });
    });
    numbering_.vertices.assign(slabs + 1, 0);
    numbering_.z_vertices.assign(slabs, 0);
    numbering_.triangles.assign(slabs + 1, 0);
    for (std::size_t k = 0; k < slabs; ++k) {
      numbering_.z_vertices[k] = numbering_.vertices[k] + plane[k];
      numbering_.vertices[k + 1] = numbering_.z_vertices[k] + upright[k];
      numbering_.triangles[k + 1] = numbering_.triangles[k] + triangles[k];
    }
    if (numbering_.vertices.back() > std::numeric_limits<std::uint32_t>::max()) {
      throw DataError("marching cubes: the surface has more than 2^32 vertices; resample the volume more coarsely");
    }
  }

  void fill(const tbb::blocked_range<int>& slabs) {
    const std::size_t nodes = nx_ * static_cast<std::size_t>(signs_.ny());
    SlabEdges lower(nodes), upper(nodes);
    std::vector<std::uint32_t> z(nodes);
    number_plane(slabs.begin(), upper);
    for (int k = slabs.begin(); k < slabs.end(); ++k) {
      monitor_.check();
      std::swap(lower, upper);
      place_vertices(k, lower, z);
      if (k + 1 == signs_.nz()) break;
      number_plane(k + 1, upper);
      add_triangles(k, lower, upper, z);
    }
  }

  void number_plane(int k, SlabEdges& edges) const {
    auto number = static_cast<std::uint32_t>(numbering_.vertices[static_cast<std::size_t>(k)]);
    for_each_plane_edge(k, [&](int axis, int i, int j) { (axis == 0 ? edges.x : edges.y)[node(i, j)] = number++; });
  }

  /// Computes the vertices of slab k and numbers its z-edges.
  void place_vertices(int k, const SlabEdges& edges, std::vector<std::uint32_t>& z) {
    for_each_plane_edge(k, [&](int axis, int i, int j) {
      mesh_.vertices[(axis == 0 ? edges.x : edges.y)[node(i, j)]] = root_on_edge(axis, i, j, k);
    });
    auto number = static_cast<std::uint32_t>(numbering_.z_vertices[static_cast<std::size_t>(k)]);
    for_each_upright_edge(k, [&](int i, int j) {
      mesh_.vertices[number] = root_on_edge(2, i, j, k);
      z[node(i, j)] = number++;
    });
  }

  void add_triangles(int k, const SlabEdges& lower, const SlabEdges& upper, const std::vector<std::uint32_t>& z) {
    std::size_t next = numbering_.triangles[static_cast<std::size_t>(k)];
    for_each_crossed_cell(k, [&](int i, int j) {
      // VTK's order of the edges of a cell.
      const std::size_t n = node(i, j), right = node(i + 1, j), back = node(i, j + 1), across = node(i + 1, j + 1);
      const std::array<std::uint32_t, 12> vertex{lower.x[n], lower.y[right], lower.x[back], lower.y[n],
                                                 upper.x[n], upper.y[right], upper.x[back], upper.y[n],
                                                 z[n],       z[right],       z[back],       z[across]};
      const unsigned c = signs_.cell_case(i, j, k);
      const std::array<int, 15>& edges = cases().edges[c];
      for (std::size_t t = 0; t < static_cast<std::size_t>(cases().triangles[c]); ++t) {
        const auto corner = [&](std::size_t m) { return vertex[static_cast<std::size_t>(edges[3 * t + m])]; };
        mesh_.triangles[next++] = {corner(0), corner(1), corner(2)};
      }
    });
  }

  /// Along a lattice edge, f is a cubic polynomial for any kernel, so four values determine it.
  Eigen::Vector3d root_on_edge(int axis, int i, int j, int k) const {
    const Eigen::Vector3d& spacing = surface_.lattice().spacing;
    Eigen::Vector3d x(spacing[0] * i, spacing[1] * j, spacing[2] * k);
    const double start = x[axis];
    std::array<double, 4> values{};
    for (int n = 0; n < 4; ++n) {
      x[axis] = start + spacing[axis] * n / 3.0;
      values[static_cast<std::size_t>(n)] = surface_.value(x);
    }
    x[axis] = start + spacing[axis] * cubic_root(values);
    return x;
  }

  template <typename Visit>
  void for_each_plane_edge(int k, Visit&& visit) const {
    for (int j = 0; j < signs_.ny(); ++j) {
      for (int w = 0; w < signs_.words(); ++w) {
        for_each_bit(signs_.x_crossings(w, j, k), w, [&](int i) { visit(0, i, j); });
      }
      if (j + 1 == signs_.ny()) break;
      for (int w = 0; w < signs_.words(); ++w) {
        for_each_bit(signs_.y_crossings(w, j, k), w, [&](int i) { visit(1, i, j); });
      }
    }
  }

  template <typename Visit>
  void for_each_upright_edge(int k, Visit&& visit) const {
    if (k + 1 == signs_.nz()) return;
    for (int j = 0; j < signs_.ny(); ++j) {
      for (int w = 0; w < signs_.words(); ++w) {
        for_each_bit(signs_.z_crossings(w, j, k), w, [&](int i) { visit(i, j); });
      }
    }
  }

  template <typename Visit>
  void for_each_crossed_cell(int k, Visit&& visit) const {
    if (k + 1 == signs_.nz()) return;
    for (int j = 0; j + 1 < signs_.ny(); ++j) {
      for (int w = 0; w < signs_.words(); ++w) {
        for_each_bit(signs_.crossed_cells(w, j, k), w, [&](int i) { visit(i, j); });
      }
    }
  }

  std::size_t node(int i, int j) const { return static_cast<std::size_t>(j) * nx_ + static_cast<std::size_t>(i); }

  const Isosurface& surface_;
  Monitor& monitor_;
  LatticeSigns signs_;
  std::size_t nx_;
  Numbering numbering_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh marching_cubes(const Isosurface& surface, Monitor& monitor) { return Extractor(surface, monitor).mesh(); }

}  // namespace isobench
