#include "isobench/methods/particles/sampling/seeds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/foundation/random.h"
#include "isobench/methods/mesh/morton.h"
#include "isobench/methods/particles/sampling/neighbours.h"

namespace isobench::particles {

namespace {

/// Running sums over the triangles: how many particles a hexagonal packing has on a triangle and all before it.
std::vector<double> cumulative_count(const SizedSurface& sized, const TriangleMesh& mesh) {
  std::vector<double> sums(mesh.triangles.size() + 1, 0.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.triangles.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Triangle& t = mesh.triangles[n];
      const Eigen::Vector3d& a = mesh.vertices[t[0]];
      const Eigen::Vector3d& b = mesh.vertices[t[1]];
      const Eigen::Vector3d& c = mesh.vertices[t[2]];
      const double area = 0.5 * (b - a).cross(c - a).norm();
      const double spacing = sized.spacing((a + b + c) / 3.0);
      sums[n + 1] = area * 2.0 / (std::sqrt(3.0) * spacing * spacing);
    }
  });
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) sums[n + 1] += sums[n];
  return sums;
}

/// `sums` is cumulative_count() of the mesh.
std::vector<Eigen::Vector3d> draw_candidates(const Isosurface& surface, const TriangleMesh& mesh,
                                             const std::vector<double>& sums, std::size_t count, std::uint64_t seed) {
  std::vector<std::optional<Eigen::Vector3d>> drawn(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      // Stratified: one candidate in each of `count` equal shares of the ideal number, so that no part stays empty.
      const double at =
          sums.back() * (static_cast<double>(n) + uniform_random(seed, n, 0)) / static_cast<double>(count);
      const auto above = std::upper_bound(sums.begin(), sums.end(), at);
      const auto t = std::min<std::size_t>(static_cast<std::size_t>(above - sums.begin()) - 1, sums.size() - 2);
      const double root = std::sqrt(uniform_random(seed, n, 1));
      const double v = root * uniform_random(seed, n, 2);
      const Triangle& triangle = mesh.triangles[t];
      drawn[n] = surface.project((1.0 - root) * mesh.vertices[triangle[0]] + (root - v) * mesh.vertices[triangle[1]] +
                                 v * mesh.vertices[triangle[2]]);
    }
  });
  std::vector<Eigen::Vector3d> candidates;
  candidates.reserve(count);
  for (const auto& point : drawn) {
    if (point) candidates.push_back(*point);
  }
  return candidates;
}

/// A heap of candidates with the most crowded on top. The weight of a candidate in the heap can be lowered.
class CrowdingHeap {
 public:
  explicit CrowdingHeap(std::vector<float> weights)
      : weights_(std::move(weights)), heap_(weights_.size()), position_(weights_.size()) {
    for (std::uint32_t n = 0; n < heap_.size(); ++n) heap_[n] = n;
    std::sort(heap_.begin(), heap_.end(), [&](std::uint32_t a, std::uint32_t b) { return before(a, b); });
    for (std::uint32_t n = 0; n < heap_.size(); ++n) position_[heap_[n]] = n;
  }

  std::size_t size() const { return heap_.size(); }
  bool contains(std::uint32_t n) const { return position_[n] != removed; }
  const std::vector<std::uint32_t>& remaining() const { return heap_; }

  std::uint32_t pop() {
    const std::uint32_t top = heap_.front();
    position_[top] = removed;
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      heap_.front() = last;
      position_[last] = 0;
      sink(0);
    }
    return top;
  }

  void lower(std::uint32_t n, float by) {
    weights_[n] -= by;
    sink(position_[n]);
  }

 private:
  static constexpr std::uint32_t removed = ~std::uint32_t{0};

  bool before(std::uint32_t a, std::uint32_t b) const {
    return weights_[a] != weights_[b] ? weights_[a] > weights_[b] : a < b;
  }

  void sink(std::size_t at) {
    const std::uint32_t moving = heap_[at];
    for (std::size_t child = 2 * at + 1; child < heap_.size(); child = 2 * at + 1) {
      if (child + 1 < heap_.size() && before(heap_[child + 1], heap_[child])) ++child;
      if (!before(heap_[child], moving)) break;
      heap_[at] = heap_[child];
      position_[heap_[at]] = static_cast<std::uint32_t>(at);
      at = child;
    }
    heap_[at] = moving;
    position_[moving] = static_cast<std::uint32_t>(at);
  }

  std::vector<float> weights_;
  std::vector<std::uint32_t> heap_;
  std::vector<std::uint32_t> position_;  // of each candidate in the heap
};

/// Yuksel's weight (1 − d/d_max)⁸ of two points at distance d; d_max is the smaller of the two reaches. 0 beyond d_max.
float crowding(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double reach_a, double reach_b) {
  const double closeness = 1.0 - (a - b).norm() / std::min(reach_a, reach_b);
  if (closeness <= 0.0) return 0.0F;
  const double square = closeness * closeness;
  return static_cast<float>(square * square * square * square);
}

std::vector<std::uint32_t> eliminate(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& reach,
                                     std::size_t count, Monitor& monitor) {
  const NeighbourLists near = find_neighbours(points, reach);
  std::vector<float> weights(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      for (const std::uint32_t j : near.of(i)) weights[i] += crowding(points[i], points[j], reach[i], reach[j]);
    }
  });
  CrowdingHeap heap(std::move(weights));
  const std::size_t surplus = points.size() - std::min(count, points.size());
  for (std::size_t n = 0; n < surplus; ++n) {
    if (n % 65536 == 0) monitor.progress(static_cast<double>(n) / static_cast<double>(surplus));
    const std::uint32_t i = heap.pop();
    for (const std::uint32_t j : near.of(i)) {
      if (heap.contains(j)) heap.lower(j, crowding(points[i], points[j], reach[i], reach[j]));
    }
  }
  return heap.remaining();
}

}  // namespace

double ideal_count(const SizedSurface& sized, const TriangleMesh& mesh) { return cumulative_count(sized, mesh).back(); }

std::vector<Eigen::Vector3d> eliminate_to_seeds(const SizedSurface& sized, const TriangleMesh& mesh, std::size_t count,
                                                double per_seed, std::uint64_t seed, Monitor& monitor) {
  constexpr double d_max = 1.65;  // times the spacing; the second ring of the ideal packing is at √3
  const std::vector<double> sums = cumulative_count(sized, mesh);
  const auto candidates = static_cast<std::size_t>(std::ceil(per_seed * static_cast<double>(count)));
  std::vector<Eigen::Vector3d> points = draw_candidates(sized.surface(), mesh, sums, candidates, seed);
  sort_by_morton(points);
  std::vector<double> reach(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) reach[n] = d_max * sized.spacing(points[n]);
  });
  std::vector<std::uint32_t> kept = eliminate(points, reach, count, monitor);
  std::sort(kept.begin(), kept.end());  // restores the Morton order
  std::vector<Eigen::Vector3d> seeds;
  seeds.reserve(kept.size());
  for (const std::uint32_t n : kept) seeds.push_back(points[n]);
  return seeds;
}

std::vector<Eigen::Vector3d> lattice_seeds(const Isosurface& surface, const TriangleMesh& mesh) {
  constexpr std::size_t every = 4;
  const std::size_t count = (mesh.vertices.size() + every - 1) / every;
  std::vector<std::optional<Eigen::Vector3d>> feet(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) feet[n] = surface.project(mesh.vertices[every * n]);
  });
  std::vector<Eigen::Vector3d> points;
  for (const auto& foot : feet) {
    if (foot) points.push_back(*foot);
  }
  const double coincident = 0.01 * surface.voxel();
  const NeighbourLists near = find_neighbours(points, std::vector<double>(points.size(), coincident));
  std::vector<Eigen::Vector3d> seeds;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto others = near.of(n);
    if (std::none_of(others.begin(), others.end(), [n](std::uint32_t j) { return j < n; })) seeds.push_back(points[n]);
  }
  return seeds;
}

}  // namespace isobench::particles
