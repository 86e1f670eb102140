#include "isobench/methods/particles/mesh_edits/editable_mesh.h"

#include <algorithm>
#include <numeric>

namespace isobench::particles {

using Index = EditableMesh::Index;

EditableMesh::EditableMesh(std::vector<Eigen::Vector3d> vertices, std::vector<Eigen::Vector3d> vertex_normals,
                           std::span<const Triangle> triangles)
    : points(std::move(vertices)), normals(std::move(vertex_normals)) {
  origin_.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) origin_.insert(origin_.end(), t.begin(), t.end());
  twin_.assign(origin_.size(), none);
  out_.assign(points.size(), none);
  valence_.assign(points.size(), 0);
  fixed_.assign(points.size(), 0);
  std::vector<Index> all(origin_.size());
  std::iota(all.begin(), all.end(), Index{0});
  pair_up(all);
  find_fixed();
}

/// Links two half-edges if they are the only ones between their vertices and run in opposite directions. Others have no
/// twin.
void EditableMesh::pair_up(std::span<const Index> half_edges) {
  struct Keyed {
    std::uint64_t ends;
    Index half_edge;
    bool operator<(const Keyed& other) const {
      return ends != other.ends ? ends < other.ends : half_edge < other.half_edge;
    }
  };
  std::vector<Keyed> keyed;
  keyed.reserve(half_edges.size());
  for (const Index e : half_edges) {
    const std::uint64_t low = std::min(origin(e), target(e));
    keyed.push_back({low << 32U | std::max(origin(e), target(e)), e});
  }
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t first = 0; first < keyed.size();) {
    std::size_t last = first + 1;
    while (last < keyed.size() && keyed[last].ends == keyed[first].ends) ++last;
    if (last - first == 2 && origin(keyed[first].half_edge) != origin(keyed[first + 1].half_edge))
      link(keyed[first].half_edge, keyed[first + 1].half_edge);
    first = last;
  }
}

void EditableMesh::find_fixed() {
  for (Index e = 0; e < origin_.size(); ++e) {
    out_[origin_[e]] = e;
    ++valence_[origin_[e]];
    if (twin_[e] == none) fixed_[origin_[e]] = fixed_[target(e)] = 1;
  }
  for (Index v = 0; v < points.size(); ++v) {
    if (!movable(v)) continue;
    Index fan = 0;
    Index e = out_[v];
    do {
      ++fan;
      e = turn(e);
    } while (e != out_[v]);
    if (fan != valence_[v]) fixed_[v] = 1;
  }
}

void EditableMesh::link(Index e, Index f) {
  twin_[e] = f;
  if (f != none) twin_[f] = e;
}

bool EditableMesh::adjacent(Index u, Index v) const {
  if (fixed(u)) std::swap(u, v);
  if (fixed(u)) return true;
  Index e = out_[u];
  do {
    if (target(e) == v) return true;
    e = turn(e);
  } while (e != out_[u]);
  return false;
}

bool EditableMesh::can_flip(Index e) const {
  const Index f = twin_[e];
  if (f == none || valence_[origin(e)] <= 3 || valence_[origin(f)] <= 3) return false;
  return apex(e) != apex(f) && !adjacent(apex(e), apex(f));
}

bool EditableMesh::can_collapse(Index e) const {
  const Index a = origin(e);
  const Index b = target(e);
  if (!movable(a)) return false;
  const Index c = apex(e);
  const Index d = apex(twin_[e]);
  if (c == d || valence_[c] <= 3 || valence_[d] <= 3) return false;
  // Link condition: only c and d may be neighbours of both a and b. Otherwise two triangles would coincide.
  Index around = out_[a];
  do {
    const Index r = target(around);
    if (r != b && r != c && r != d && adjacent(r, b)) return false;
    around = turn(around);
  } while (around != out_[a]);
  return true;
}

void EditableMesh::flip(Index e0) {
  const Index f0 = twin_[e0];
  const Index e1 = next(e0);
  const Index f1 = next(f0);
  const Index a = origin_[e0];
  const Index b = origin_[f0];
  const Index c = apex(e0);
  const Index d = apex(f0);
  const Index beyond_bc = twin_[e1];
  const Index beyond_ad = twin_[f1];
  // (a b c), (b a d) become (a d c), (b c d).
  origin_[e1] = d;
  origin_[f1] = c;
  link(e0, beyond_ad);
  link(f0, beyond_bc);
  link(e1, f1);
  out_[a] = e0;
  out_[b] = f0;
  --valence_[a];
  --valence_[b];
  ++valence_[c];
  ++valence_[d];
}

void EditableMesh::collapse(Index e0) {
  const Index f0 = twin_[e0];
  const Index a = origin_[e0];
  const Index b = origin_[f0];
  const Index c = apex(e0);
  const Index d = apex(f0);
  Index e = out_[a];
  std::vector<Index> moved;
  do {
    moved.push_back(e);
    e = turn(e);
  } while (e != out_[a]);
  for (const Index m : moved) origin_[m] = b;

  const Index bc = twin_[previous(e0)];
  const Index cb = twin_[next(e0)];
  const Index db = twin_[next(f0)];
  const Index bd = twin_[previous(f0)];
  if (cb != none)
    link(cb, bc);
  else
    twin_[bc] = none;
  if (bd != none)
    link(bd, db);
  else
    twin_[db] = none;
  out_[b] = bc;
  if (cb != none)
    out_[c] = cb;
  else
    out_[c] = next(bc);
  out_[d] = db;
  out_[a] = none;
  valence_[b] += valence_[a] - 4;
  --valence_[c];
  --valence_[d];
  valence_[a] = 0;
  for (const Index t : {e0 / 3, f0 / 3}) {
    for (Index k = 0; k < 3; ++k) origin_[3 * t + k] = twin_[3 * t + k] = none;
  }
}

Index EditableMesh::add_vertex(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  points.push_back(point);
  normals.push_back(normal);
  out_.push_back(none);
  valence_.push_back(0);
  fixed_.push_back(0);
  return static_cast<Index>(points.size() - 1);
}

Index EditableMesh::add_triangle() {
  origin_.resize(origin_.size() + 3, none);
  twin_.resize(twin_.size() + 3, none);
  return static_cast<Index>(origin_.size() - 3);
}

Index EditableMesh::split_edge(Index e0, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Index f0 = twin_[e0];
  const Index e1 = next(e0);
  const Index f2 = previous(f0);
  const Index b = origin_[f0];
  const Index c = apex(e0);
  const Index d = apex(f0);
  const Index m = add_vertex(point, normal);
  const Index g = add_triangle();
  const Index h = add_triangle();
  const Index beyond_bc = twin_[e1];
  const Index beyond_db = twin_[f2];
  // (a b c), (b a d) become (a m c), (m a d) and, new, (m b c), (b m d).
  origin_[e1] = m;
  origin_[f0] = m;
  origin_[g] = m;
  origin_[g + 1] = b;
  origin_[g + 2] = c;
  origin_[h] = b;
  origin_[h + 1] = m;
  origin_[h + 2] = d;
  link(e1, g + 2);
  link(g + 1, beyond_bc);
  link(g, h);
  link(f2, h + 1);
  link(h + 2, beyond_db);
  out_[m] = e1;
  out_[b] = g + 1;
  valence_[m] = 4;
  ++valence_[c];
  ++valence_[d];
  return m;
}

Index EditableMesh::split_vertex(Index first, Index last, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Index v = origin_[first];
  const Index p = target(first);
  const Index q = target(last);
  const Index w = add_vertex(point, normal);
  Index taken = 0;
  std::vector<Index> moved;
  for (Index e = first; e != last; e = turn(e)) moved.push_back(e);
  for (const Index e : moved) {
    origin_[e] = w;
    ++taken;
  }
  const Index right_of_p = twin_[first];
  const Index left_of_q = twin_[last];
  const Index g = add_triangle();
  const Index h = add_triangle();
  origin_[g] = v;
  origin_[g + 1] = p;
  origin_[g + 2] = w;
  origin_[h] = w;
  origin_[h + 1] = q;
  origin_[h + 2] = v;
  link(g, right_of_p);
  link(g + 1, first);
  link(g + 2, h + 2);
  link(h, left_of_q);
  link(h + 1, last);
  out_[w] = first;
  out_[v] = last;
  valence_[w] = taken + 2;
  valence_[v] += 2 - taken;
  ++valence_[p];
  ++valence_[q];
  return w;
}

void EditableMesh::replace(std::span<const Index> old, std::span<const Triangle> fresh) {
  std::vector<Index> half_edges;
  for (const Index t : old) {
    for (Index k = 0; k < 3; ++k) {
      const Index e = 3 * t + k;
      --valence_[origin_[e]];
      const Index beyond = twin_[e];
      // Half-edges across the border of the replaced triangles need a new twin.
      if (beyond != none && std::find(old.begin(), old.end(), beyond / 3) == old.end()) half_edges.push_back(beyond);
    }
  }
  for (const Index t : old) {
    for (Index k = 0; k < 3; ++k) {
      const Index e = 3 * t + k;
      if (out_[origin_[e]] / 3 == t) out_[origin_[e]] = none;
      origin_[e] = twin_[e] = none;
    }
  }
  for (std::size_t n = 0; n < fresh.size(); ++n) {
    const Index first = n < old.size() ? 3 * old[n] : add_triangle();
    for (Index k = 0; k < 3; ++k) {
      origin_[first + k] = fresh[n][k];
      half_edges.push_back(first + k);
      ++valence_[fresh[n][k]];
      out_[fresh[n][k]] = first + k;
    }
  }
  pair_up(half_edges);
}

TriangleMesh EditableMesh::triangle_mesh() const {
  TriangleMesh result;
  std::vector<Index> place(points.size(), none);
  for (Index v = 0; v < points.size(); ++v) {
    if (!alive(v)) continue;
    place[v] = static_cast<Index>(result.vertices.size());
    result.vertices.push_back(points[v]);
  }
  for (Index e = 0; e < origin_.size(); e += 3) {
    if (origin_[e] == none) continue;
    result.triangles.push_back({place[origin_[e]], place[origin_[e + 1]], place[origin_[e + 2]]});
  }
  return result;
}

}  // namespace isobench::particles
