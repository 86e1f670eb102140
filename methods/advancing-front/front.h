// The mesh made so far and its rim: doubly linked loops of edges beyond which nothing is meshed yet
// (Schreiner, Scheidegger, Silva 2006).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/advancing-front/edge_table.h"
#include "isobench/methods/advancing-front/spatial_hash.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::advancing_front {

struct Vertex {
  Eigen::Vector3d x;       ///< on F = c, mm
  Eigen::Vector3d normal;  ///< outward, unit
  double step = 0.0;       ///< how long edges shall be here, mm
};

/// One passage of a loop through a vertex. Where loops touch, a vertex has several: one for every gap between its
/// triangles. A node also stands for the edge from it to the next node; what is not meshed lies to the left of it.
struct Node {
  std::uint32_t vertex = 0;
  int previous = -1;
  int next = -1;
  std::uint32_t stamp = 0;  ///< grows whenever the node's edge becomes another one, or none
  bool alive = false;
};

/// What became of the loops when an edge was connected to a node.
enum class Link { ear, split, merge, closed };

/// Every triangle is made by grow, connect or seed, which keep directed edges unique and gaps in their order round a
/// vertex: whatever the geometry, the mesh is an oriented manifold, and closed once no node is alive.
class Front {
 public:
  /// `finest` (mm): about the shortest edge to come.
  explicit Front(double finest) : edges_(finest), points_(finest) {}

  /// A triangle on its own, counter-clockwise from outside; its three edges become a loop. Returns its first node.
  int seed(const std::array<Vertex, 3>& corners);
  /// A loop of existing edges round what is to be meshed, on its left, without a triangle: a boundary. Returns its
  /// first node.
  int boundary(const std::vector<Vertex>& loop);
  /// A triangle on edge `node` with a new vertex. Returns the new node, which precedes the edge's old end.
  int grow(int node, const Vertex& apex);
  /// A triangle on edge `node` with the vertex of node `apex`, which must be connectable. An ear is cut where apex is
  /// the neighbour of one end; otherwise the loop is split in two or merged with another. The edges that changed are
  /// appended to `changed`.
  Link connect(int node, int apex, std::vector<int>& changed);
  /// Whether that triangle would use a directed edge twice, or an edge whose two sides are in different gaps.
  bool connectable(int node, int apex) const;
  /// Takes a loop off the front without closing it, and returns how many edges it had.
  std::size_t abandon(int node);

  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  int next(int n) const { return node(n).next; }
  int previous(int n) const { return node(n).previous; }
  const Vertex& vertex(int n) const { return vertices_[node(n).vertex]; }
  /// All nodes, alive or not, are below this.
  int node_count() const { return static_cast<int>(nodes_.size()); }
  std::size_t alive() const { return alive_; }
  double edge_length(int n) const { return (vertex(next(n)).x - vertex(n).x).norm(); }

  /// Where the edges of the front are, by their nodes.
  const SpatialHash& edges() const { return edges_; }
  /// Whether a vertex that the front has left behind lies within `distance` (mm) of x on a sheet that faces the same
  /// way: then x is meshed already. `least` (mm) is the smallest step to be expected there.
  bool is_behind(const Vertex& x, double distance, double least) const;
  /// The same of all vertices, those on the front too.
  bool covers(const Vertex& x, double distance, double least) const;

  /// Whether a node of a vertex from this number on is alive.
  bool is_open_from(std::size_t vertex) const;
  /// Takes back the triangles from this number on, which must share no vertex with those before them, and takes their
  /// loops off the front. Their vertices stay, unused.
  void take_back(std::size_t triangle, std::size_t vertex);
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  std::uint32_t make_vertex(const Vertex& vertex);
  int make_node(std::uint32_t vertex);
  void free_node(int n);
  int link_loop(const std::vector<std::uint32_t>& vertices);
  void join(int from, int to);
  void edge_changed(int n);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  bool has_vertex_near(const Vertex& x, double distance, double least, bool on_front_too) const;
  bool same_loop(int node, int apex) const;

  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<int> free_nodes_;
  std::size_t alive_ = 0;
  EdgeTable used_;
  std::vector<std::uint16_t> passages_;  // of the front through each vertex
  SpatialHash edges_;
  SpatialHash points_;
  mutable std::vector<int> near_;
};

}  // namespace isobench::advancing_front
