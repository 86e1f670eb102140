// Moves a front over the surface until nothing is left to do (Schreiner, Scheidegger, Silva 2006).
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

/// How many triangles came from what.
struct Counts {
  std::size_t seed = 0;
  std::size_t grown = 0;      ///< with a new vertex
  std::size_t connected = 0;  ///< ears, and the last triangles of loops
  std::size_t split = 0;      ///< that made two loops of one
  std::size_t merged = 0;     ///< that made one loop of two
  std::size_t failsafe = 0;
};

/// Grows where there is room, best triangle first, and connects where there is none. Edges where neither is allowed are
/// tried again under looser rules when all others are done; what then remains is left to the failsafe.
class Advance {
 public:
  /// Keeps references. Nothing grows out of `bounds`.
  Advance(const Isosurface& surface, Step step, Front& front, Counts& counts, const Eigen::AlignedBox3d& bounds)
      : surface_(surface), step_(std::move(step)), front_(front), counts_(counts), bounds_(bounds) {}

  /// All edges of the loop through a node will be advanced.
  void add_loop(int node);
  /// Throws Cancelled.
  void run(const Monitor& monitor);
  /// Whether the front wanted to leave the bounds.
  bool strayed() const { return strayed_; }

 private:
  struct Rules;
  enum class Kind : std::uint8_t { grow, connect };
  struct Entry {
    Kind kind;
    int rules;
    double key;  ///< the smaller the sooner, within a kind
    std::uint64_t order;
    int node;
    std::uint32_t stamp;
    bool operator<(const Entry& other) const {  // std::priority_queue gives the largest
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
  bool strayed_ = false;
  std::priority_queue<Entry> queue_;
  std::uint64_t order_ = 0;
  std::vector<std::optional<Vertex>> apexes_;  // by node: what its edge would grow
  std::vector<Entry> waiting_;
  std::size_t triangles_at_retry_ = 0;
  int retry_rules_ = 0;
  std::vector<int> near_;
  std::vector<int> changed_;
  std::vector<Candidate> candidates_;
};

}  // namespace isobench::advancing_front
