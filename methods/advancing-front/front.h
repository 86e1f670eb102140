// The mesh made so far and its boundary, the front: doubly linked loops of edges (Schreiner, Scheidegger, Silva 2006).
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
  double step = 0.0;       ///< desired edge length, mm
};

/// One passage of a loop through a vertex. Where loops touch, a vertex has several nodes, one for every gap between its
/// triangles. A node also stands for the edge from it to the next node; the region to mesh is on the left of that edge.
struct Node {
  std::uint32_t vertex = 0;
  int previous = -1;
  int next = -1;
  std::uint32_t stamp = 0;  ///< grows whenever the node's edge changes or is removed
  bool alive = false;
};

/// The effect on the loops when an edge is connected to a node.
enum class Link { ear, split, merge, closed };

/// Every triangle is made by seed, grow or connect. These keep directed edges unique and the order of the gaps round a
/// vertex. The mesh is therefore an oriented manifold for any positions of its vertices, and closed once no node is
/// alive.
class Front {
 public:
  /// `finest` (mm): about the length of the shortest edge.
  explicit Front(double finest) : edges_(finest), points_(finest) {}

  /// Adds a triangle, counter-clockwise from outside, whose three edges become a loop. Returns a node of the loop.
  int seed(const std::array<Vertex, 3>& corners);
  /// Adds a loop without a triangle: the boundary of a region to mesh, which is on its left. Returns the first node.
  int boundary(const std::vector<Vertex>& loop);
  /// Adds a triangle of edge `node` and a new vertex. Returns the new node, which precedes the edge's old end.
  int grow(int node, const Vertex& apex);
  /// Adds a triangle of edge `node` and the vertex of node `apex`; they must be connectable. If `apex` is next to an
  /// end of the edge, this cuts off an ear; otherwise it splits the loop in two or merges it with another. Appends the
  /// edges that changed to `changed`.
  Link connect(int node, int apex, std::vector<int>& changed);
  /// Whether connect() is allowed: the triangle must have three different vertices, and its new edges must not be used.
  bool connectable(int node, int apex) const;
  /// Takes a loop off the front without closing it and returns the number of its edges.
  std::size_t abandon(int node);

  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  int next(int n) const { return node(n).next; }
  int previous(int n) const { return node(n).previous; }
  const Vertex& vertex(int n) const { return vertices_[node(n).vertex]; }
  /// One more than the largest number of a node, alive or not.
  int node_count() const { return static_cast<int>(nodes_.size()); }
  std::size_t alive() const { return alive_; }
  double edge_length(int n) const { return (vertex(next(n)).x - vertex(n).x).norm(); }

  /// The edges of the front by position, named by their nodes.
  const SpatialHash& edges() const { return edges_; }
  /// Whether a vertex that the front has passed lies within `distance` (mm) of x, on a sheet that faces the same way: x
  /// is then meshed already. `least` (mm) is a lower bound on the steps there.
  bool is_behind(const Vertex& x, double distance, double least) const;
  /// The same for all vertices, including those on the front.
  bool covers(const Vertex& x, double distance, double least) const;

  /// Whether a vertex with this number or a larger one has a node that is alive.
  bool is_open_from(std::size_t vertex) const;
  /// Removes the triangles from number `triangle` on and takes their loops off the front. They must use only vertices
  /// from number `vertex` on, and no other triangle may use those. The vertices stay, unused.
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
  std::vector<std::uint16_t> passages_;  // by vertex: number of nodes that are alive
  SpatialHash edges_;
  SpatialHash points_;
  mutable std::vector<int> near_;
};

}  // namespace isobench::advancing_front
