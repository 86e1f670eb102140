// Moves a front over the surface until no edge can be advanced any more (Schreiner, Scheidegger, Silva 2006).
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/advancing-front/apex.h"
#include "isobench/methods/advancing-front/fences.h"
#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// The number of triangles by the operation that made them.
struct Counts {
  std::size_t seed = 0;       ///< the first triangle of a front
  std::size_t grown = 0;      ///< with a new vertex
  std::size_t connected = 0;  ///< ears, and the last triangles of loops
  std::size_t split = 0;      ///< split one loop into two
  std::size_t merged = 0;     ///< merged two loops into one
  std::size_t failsafe = 0;   ///< closed a hole that the front had left
};

/// Advances the edges of a front. An edge grows a triangle with a new vertex if there is room, best triangle first;
/// otherwise it is connected to a vertex of the front. Edges for which both fail are tried again under looser rules
/// after all others. The failsafe closes what then remains.
class Advance {
 public:
  /// Keeps references. New vertices stay within `bounds`. Advancing stops when the front has `most` triangles: sheets
  /// that cross each other could make it go round for ever.
  Advance(const Isosurface& surface, Step step, Front& front, Counts& counts, const Eigen::AlignedBox3d& bounds,
          std::size_t most)
      : surface_(surface), step_(std::move(step)), front_(front), counts_(counts), bounds_(bounds), most_(most) {}

  /// Queues all edges of the loop through a node.
  void add_loop(int node);
  /// Throws Cancelled.
  void run(const Monitor& monitor);
  /// Whether the bounds have kept an edge from growing.
  bool strayed() const { return strayed_; }
  /// Whether advancing stopped early.
  bool is_endless() const { return front_.triangles().size() >= most_; }

 private:
  struct Rules;
  enum class Kind : std::uint8_t { grow, connect };
  struct Entry {
    Kind kind;
    int rules;
    double key;  ///< entries of one kind are taken in ascending order of it
    std::uint64_t order;
    int node;
    std::uint32_t stamp;
    bool operator<(const Entry& other) const {  // reversed: std::priority_queue returns the largest entry
      if (kind != other.kind) return kind > other.kind;
      if (key != other.key) return key > other.key;
      return order > other.order;
    }
  };
  struct Candidate {
    int node;
    double angle;
  };

  static const Rules& rules(int n);
  bool valid(const Entry& entry) const;
  std::optional<Vertex> apex_of(int node, int rules);
  void push_grow(int node, int rules);
  void push_connect(int node, int rules, double angle);
  void try_grow(const Entry& entry);
  void try_connect(const Entry& entry);
  bool retry_waiting();
  void connect(int node, int apex);
  std::optional<Candidate> best_candidate(int node, int rules);
  bool is_meshed(const Vertex& apex, int rules) const;
  std::optional<int> vertex_at(const Vertex& apex) const;

  const Isosurface& surface_;
  Step step_;
  Front& front_;
  Counts& counts_;
  Eigen::AlignedBox3d bounds_;
  std::size_t most_;
  bool strayed_ = false;
  std::priority_queue<Entry> queue_;
  std::uint64_t order_ = 0;
  std::vector<std::optional<Vertex>> apexes_;  // by node: the vertex that its edge would grow
  std::vector<Entry> waiting_;
  std::size_t triangles_at_retry_ = 0;
  int retry_rules_ = 0;
  std::vector<int> near_;
  std::vector<int> changed_;
  std::vector<Candidate> candidates_;
};

}  // namespace isobench::advancing_front
