#include "isobench/methods/particles/mesh_edits/valence_edits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "isobench/methods/particles/mesh_edits/smoothing.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;
using Eigen::Vector3d;

int defect(int valence) { return (valence - 6) * (valence - 6); }
int valence(const EditableMesh& mesh, Index v) { return static_cast<int>(mesh.valence(v)); }

/// The cosine of the largest angle between a triangle and the normals at its corners.
double normal_cosine(const EditableMesh& mesh, Index a, Index b, Index c) {
  const Vector3d across = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
  const double length = across.norm();
  if (!(length > 0.0)) return -1.0;
  return std::min({across.dot(mesh.normals[a]), across.dot(mesh.normals[b]), across.dot(mesh.normals[c])}) / length;
}

double ratio(const EditableMesh& mesh, Index a, Index b, Index c) {
  return radius_ratio(mesh.points[a], mesh.points[b], mesh.points[c]);
}

std::vector<Index> out_edges(const EditableMesh& mesh, Index v) {
  std::vector<Index> edges;
  Index e = mesh.out(v);
  do {
    edges.push_back(e);
    e = mesh.turn(e);
  } while (e != mesh.out(v));
  return edges;
}

/// The worst values among the triangles around a vertex.
struct Fan {
  double least_q = 1.0;
  double least_normal_cosine = 1.0;
};

Fan fan_of(const EditableMesh& mesh, Index v) {
  Fan fan;
  for (const Index e : out_edges(mesh, v)) {
    fan.least_q = std::min(fan.least_q, ratio(mesh, v, mesh.target(e), mesh.apex(e)));
    fan.least_normal_cosine = std::min(fan.least_normal_cosine, normal_cosine(mesh, v, mesh.target(e), mesh.apex(e)));
  }
  return fan;
}

struct OnSurface {
  Vector3d point;
  Vector3d normal;
};

std::optional<OnSurface> on_surface(const Isosurface& surface, const Vector3d& x) {
  const auto foot = surface.project(x, 1e-4);
  if (!foot) return std::nullopt;
  return OnSurface{*foot, outward_normal(surface.value_gradient(*foot).gradient)};
}

}  // namespace

FinishEnergies finish_energies(const SizingField& sizing, double weight) {
  if (sizing.uniform()) return {{5, 4, 0.04 * weight, 2.0}, {5, 5, 1e-3 * weight, 2.0}};
  return {{5, 4, 0.01 * weight, 1.7}, {5, 4, 0.01 * weight, 1.7}};
}

double edge_over_h0(const FinishContext& context, const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() * 2.0 / (context.sizing.h0(a) + context.sizing.h0(b));
}

int flip_gain(const EditableMesh& mesh, Index e) {
  const int a = valence(mesh, mesh.origin(e));
  const int b = valence(mesh, mesh.target(e));
  const int c = valence(mesh, mesh.apex(e));
  const int d = valence(mesh, mesh.apex(mesh.twin(e)));
  return defect(a) + defect(b) + defect(c) + defect(d) - defect(a - 1) - defect(b - 1) - defect(c + 1) - defect(d + 1);
}

bool flip_keeps_shape(const FinishContext& context, const EditableMesh& mesh, Index e, double least_q) {
  const Index a = mesh.origin(e);
  const Index b = mesh.target(e);
  const Index c = mesh.apex(e);
  const Index d = mesh.apex(mesh.twin(e));
  const double q = std::min(ratio(mesh, a, d, c), ratio(mesh, b, c, d));
  if (q < least_q && q <= std::min(ratio(mesh, a, b, c), ratio(mesh, b, a, d))) return false;
  const double cosine = std::min(normal_cosine(mesh, a, d, c), normal_cosine(mesh, b, c, d));
  if (cosine < least_cosine && cosine < std::min(normal_cosine(mesh, a, b, c), normal_cosine(mesh, b, a, d)))
    return false;
  if (context.sizing.uniform()) return true;
  return edge_over_h0(context, mesh.points[c], mesh.points[d]) <=
         std::max(1.0, edge_over_h0(context, mesh.points[a], mesh.points[b]));
}

bool collapse_keeps_shape(const FinishContext& context, const EditableMesh& mesh, Index e, double least_q) {
  const Index a = mesh.origin(e);
  const Index b = mesh.target(e);
  for (const Index o : out_edges(mesh, a)) {
    const Index p = mesh.target(o);
    const Index q = mesh.apex(o);
    if (p == b || q == b) continue;
    if (ratio(mesh, b, p, q) < least_q) return false;
    if (normal_cosine(mesh, b, p, q) < least_cosine) return false;
    if (!context.sizing.uniform() && edge_over_h0(context, mesh.points[b], mesh.points[p]) > 1.0) return false;
  }
  return true;
}

std::size_t flip_for_valence(const FinishContext& context, EditableMesh& mesh) {
  constexpr int rounds = 4;
  constexpr double least_q = 0.5;
  std::size_t all = 0;
  for (int round = 0; round < rounds; ++round) {
    std::size_t flips = 0;
    for (Index e = 0; e < mesh.half_edge_count(); ++e) {
      if (mesh.origin(e) == EditableMesh::none || mesh.twin(e) == EditableMesh::none || mesh.twin(e) < e) continue;
      if (flip_gain(mesh, e) <= 0 || !mesh.can_flip(e) || !flip_keeps_shape(context, mesh, e, least_q)) continue;
      mesh.flip(e);
      ++flips;
    }
    all += flips;
    if (flips == 0) break;
  }
  return all;
}

std::size_t flip_for_shape(const FinishContext& context, EditableMesh& mesh) {
  std::size_t flips = 0;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (mesh.origin(e) == EditableMesh::none || mesh.twin(e) == EditableMesh::none || mesh.twin(e) < e) continue;
    const Index a = mesh.origin(e);
    const Index b = mesh.target(e);
    const Index c = mesh.apex(e);
    const Index d = mesh.apex(mesh.twin(e));
    const double q = std::min(ratio(mesh, a, b, c), ratio(mesh, b, a, d));
    if (q > 0.8) continue;
    if (valence(mesh, a) <= 5 || valence(mesh, b) <= 5 || valence(mesh, c) >= 7 || valence(mesh, d) >= 7) continue;
    if (std::min(ratio(mesh, a, d, c), ratio(mesh, b, c, d)) <= q) continue;
    if (!mesh.can_flip(e) || !flip_keeps_shape(context, mesh, e, q)) continue;
    mesh.flip(e);
    ++flips;
  }
  return flips;
}

Index best_collapse(const FinishContext& context, const EditableMesh& mesh, Index v, double least_q) {
  Index best = EditableMesh::none;
  int best_defect = 0;
  for (const Index e : out_edges(mesh, v)) {
    if (!mesh.can_collapse(e) || !collapse_keeps_shape(context, mesh, e, least_q)) continue;
    const int b = valence(mesh, mesh.target(e));
    const int c = valence(mesh, mesh.apex(e));
    const int d = valence(mesh, mesh.apex(mesh.twin(e)));
    const int after =
        defect(b + valence(mesh, v) - 4) - defect(b) + defect(c - 1) - defect(c) + defect(d - 1) - defect(d);
    if (best != EditableMesh::none && after >= best_defect) continue;
    best = e;
    best_defect = after;
  }
  return best;
}

std::size_t collapse_low_valence(const FinishContext& context, EditableMesh& mesh) {
  constexpr double least_q = 0.3;
  std::size_t collapsed = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.movable(v) || mesh.valence(v) > 4) continue;
    const Index best = best_collapse(context, mesh, v, least_q);
    if (best == EditableMesh::none) continue;
    mesh.collapse(best);
    ++collapsed;
  }
  return collapsed;
}

Index divide_vertex(const FinishContext& context, EditableMesh& mesh, Index v) {
  const std::vector<Index> edges = out_edges(mesh, v);
  const std::size_t count = edges.size();
  if (count < 6) return EditableMesh::none;
  std::size_t first = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < count; ++k) {
    const int p = valence(mesh, mesh.target(edges[k]));
    const int q = valence(mesh, mesh.target(edges[(k + count / 2) % count]));
    const int cost = defect(p + 1) - defect(p) + defect(q + 1) - defect(q);
    if (cost >= least) continue;
    least = cost;
    first = k;
  }
  const std::size_t last = (first + count / 2) % count;
  const Vector3d x = mesh.points[v];
  const auto middle = [&](std::size_t from, std::size_t to) {
    Vector3d sum = Vector3d::Zero();
    int terms = 0;
    for (std::size_t k = from;; k = (k + 1) % count, ++terms) {
      sum += mesh.points[mesh.target(edges[k])];
      if (k == to) break;
    }
    return Vector3d(sum / (terms + 1));
  };
  const auto one = on_surface(context.surface, x + 0.5 * (middle(first, last) - x));
  const auto other = on_surface(context.surface, x + 0.5 * (middle(last, first) - x));
  if (!one || !other) return EditableMesh::none;
  EditableMesh::Index w = mesh.split_vertex(edges[first], edges[last], one->point, one->normal);
  const OnSurface before{mesh.points[v], mesh.normals[v]};
  mesh.points[v] = other->point;
  mesh.normals[v] = other->normal;
  const Fan fan_v = fan_of(mesh, v);
  const Fan fan_w = fan_of(mesh, w);
  if (std::min(fan_v.least_q, fan_w.least_q) > 0.15 &&
      std::min(fan_v.least_normal_cosine, fan_w.least_normal_cosine) > least_cosine)
    return w;
  // Undoes the split by the opposite collapse.
  Index back = mesh.out(w);
  while (mesh.target(back) != v) back = mesh.turn(back);
  mesh.collapse(back);
  mesh.points[v] = before.point;
  mesh.normals[v] = before.normal;
  return EditableMesh::none;
}

std::size_t split_high_valence(const FinishContext& context, EditableMesh& mesh) {
  std::size_t split = 0;
  const auto count = static_cast<Index>(mesh.vertex_count());
  for (Index v = 0; v < count; ++v) {
    if (!mesh.movable(v) || mesh.valence(v) < 8) continue;
    if (divide_vertex(context, mesh, v) != EditableMesh::none) ++split;
  }
  return split;
}

Index split_edge_at_middle(const FinishContext& context, EditableMesh& mesh, Index e) {
  const Vector3d middle = 0.5 * (mesh.points[mesh.origin(e)] + mesh.points[mesh.target(e)]);
  const auto on = on_surface(context.surface, middle);
  if (!on || (on->point - middle).norm() > 0.3 * (mesh.points[mesh.origin(e)] - middle).norm())
    return EditableMesh::none;
  return mesh.split_edge(e, on->point, on->normal);
}

}  // namespace isobench::particles
