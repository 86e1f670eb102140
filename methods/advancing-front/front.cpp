#include "isobench/methods/advancing-front/front.h"

#include <algorithm>
#include <utility>

namespace isobench::advancing_front {

std::uint32_t Front::make_vertex(const Vertex& vertex) {
  const auto number = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back(vertex);
  passages_.push_back(0);
  points_.insert(static_cast<int>(number), vertex.x, 0.0, vertex.step);
  return number;
}

int Front::make_node(std::uint32_t vertex) {
  int n = 0;
  if (free_nodes_.empty()) {
    n = node_count();
    nodes_.emplace_back();
  } else {
    n = free_nodes_.back();
    free_nodes_.pop_back();
  }
  Node& node = nodes_[static_cast<std::size_t>(n)];
  node = {vertex, -1, -1, node.stamp + 1, true};
  ++passages_[vertex];
  ++alive_;
  return n;
}

void Front::free_node(int n) {
  edges_.erase(n);
  Node& node = nodes_[static_cast<std::size_t>(n)];
  --passages_[node.vertex];
  node.alive = false;
  ++node.stamp;
  free_nodes_.push_back(n);
  --alive_;
}

void Front::join(int from, int to) {
  nodes_[static_cast<std::size_t>(from)].next = to;
  nodes_[static_cast<std::size_t>(to)].previous = from;
}

void Front::edge_changed(int n) {
  const Vertex &a = vertex(n), &b = vertex(next(n));
  edges_.erase(n);
  ++nodes_[static_cast<std::size_t>(n)].stamp;
  edges_.insert(n, 0.5 * (a.x + b.x), 0.5 * (b.x - a.x).norm(), std::max(a.step, b.step));
}

bool Front::has_vertex_near(const Vertex& x, double distance, double least, bool on_front_too) const {
  near_.clear();
  points_.near(x.x, distance, least, near_);
  return std::any_of(near_.begin(), near_.end(), [&](int n) {
    const Vertex& v = vertices_[static_cast<std::size_t>(n)];
    return (on_front_too || passages_[static_cast<std::size_t>(n)] == 0) &&
           (v.x - x.x).squaredNorm() < distance * distance && v.normal.dot(x.normal) > 0.3;
  });
}

bool Front::is_behind(const Vertex& x, double distance, double least) const {
  return has_vertex_near(x, distance, least, false);
}

bool Front::covers(const Vertex& x, double distance, double least) const {
  return has_vertex_near(x, distance, least, true);
}

bool Front::is_open_from(std::size_t vertex) const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [&](const Node& node) { return node.alive && node.vertex >= vertex; });
}

void Front::take_back(std::size_t triangle, std::size_t vertex) {
  triangles_.resize(triangle);
  for (int n = 0; n < node_count(); ++n) {
    if (node(n).alive && node(n).vertex >= vertex) free_node(n);
  }
}

void Front::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles_.push_back({a, b, c});
  used_.insert(a, b);
  used_.insert(b, c);
  used_.insert(c, a);
}

int Front::link_loop(const std::vector<std::uint32_t>& vertices) {
  const int first = make_node(vertices.front());
  int last = first;
  for (std::size_t n = 1; n < vertices.size(); ++n) {
    const int node = make_node(vertices[n]);
    join(last, node);
    last = node;
  }
  join(last, first);
  int node = first;
  do {
    edge_changed(node);
    node = next(node);
  } while (node != first);
  return first;
}

int Front::seed(const std::array<Vertex, 3>& corners) {
  const std::uint32_t a = make_vertex(corners[0]), b = make_vertex(corners[1]), c = make_vertex(corners[2]);
  add_triangle(a, b, c);
  return link_loop({a, c, b});  // clockwise: the region to mesh, outside the triangle, is on the left
}

int Front::boundary(const std::vector<Vertex>& loop) {
  std::vector<std::uint32_t> numbers;
  for (const Vertex& vertex : loop) numbers.push_back(make_vertex(vertex));
  return link_loop(numbers);
}

int Front::grow(int node, const Vertex& apex) {
  const int end = next(node);
  const std::uint32_t number = make_vertex(apex);
  add_triangle(this->node(node).vertex, this->node(end).vertex, number);
  const int made = make_node(number);
  join(node, made);
  join(made, end);
  edge_changed(node);
  edge_changed(made);
  return made;
}

bool Front::connectable(int n, int apex) const {
  const int end = next(n);
  const std::uint32_t a = node(n).vertex, b = node(end).vertex, c = node(apex).vertex;
  if (c == a || c == b) return false;
  const bool has_end_side = next(end) == apex, has_start_side = next(apex) == n;
  return (has_end_side || !(used_.contains(b, c) || used_.contains(c, b))) &&
         (has_start_side || !(used_.contains(c, a) || used_.contains(a, c)));
}

bool Front::same_loop(int node, int apex) const {
  // Two walks in step, so that the shorter of the two ways bounds the cost.
  const int end = next(node);
  int from_apex = apex, from_end = end;
  while (true) {
    from_apex = next(from_apex);
    if (from_apex == node) return true;
    if (from_apex == apex) return false;
    from_end = next(from_end);
    if (from_end == apex) return true;
    if (from_end == end) return false;
  }
}

Link Front::connect(int node, int apex, std::vector<int>& changed) {
  const int end = next(node);
  const bool ear_at_end = next(end) == apex, ear_at_start = next(apex) == node;
  const bool same = ear_at_end || ear_at_start || same_loop(node, apex);
  add_triangle(this->node(node).vertex, this->node(end).vertex, this->node(apex).vertex);
  if (ear_at_end && ear_at_start) {
    free_node(node);
    free_node(end);
    free_node(apex);
    return Link::closed;
  }
  if (ear_at_end) {
    free_node(end);
    join(node, apex);
    edge_changed(node);
    changed.push_back(node);
    return Link::ear;
  }
  if (ear_at_start) {
    free_node(node);
    join(apex, end);
    edge_changed(apex);
    changed.push_back(apex);
    return Link::ear;
  }
  const int twin = make_node(this->node(apex).vertex);
  join(previous(apex), twin);
  join(twin, end);
  join(node, apex);
  edge_changed(node);
  edge_changed(twin);
  changed.push_back(node);
  changed.push_back(twin);
  return same ? Link::split : Link::merge;
}

std::size_t Front::abandon(int node) {
  std::size_t edges = 0;
  for (int n = node; this->node(n).alive; ++edges) {
    const int after = next(n);
    free_node(n);
    n = after;
  }
  return edges;
}

}  // namespace isobench::advancing_front
