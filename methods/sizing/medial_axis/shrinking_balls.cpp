#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench {

namespace {

using Key = std::array<std::int64_t, 3>;

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t h = 0x9E3779B97F4A7C15U;
    for (const std::int64_t part : key) {
      h ^= static_cast<std::uint64_t>(part);
      h *= 0xBF58476D1CE4E5B9U;
      h ^= h >> 31;
    }
    return static_cast<std::size_t>(h);
  }
};

Key key_of(const Eigen::Vector3d& x, double cell) {
  return {static_cast<std::int64_t>(std::floor(x[0] / cell)), static_cast<std::int64_t>(std::floor(x[1] / cell)),
          static_cast<std::int64_t>(std::floor(x[2] / cell))};
}

/// Thins points: accepts a point unless an accepted point is nearer than `distance`.
class Thinning {
 public:
  Thinning(double distance, std::size_t expected) : distance_(distance), cell_(4.0 * distance) {
    heads_.reserve(expected);
    kept_.reserve(expected);
    next_.reserve(expected);
  }

  bool accept(const Eigen::Vector3d& x) {
    // The cells are wide, so that for most points one or two cells are searched.
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(distance_);
    const Key low = key_of(x - reach, cell_);
    const Key high = key_of(x + reach, cell_);
    for (std::int64_t k = low[2]; k <= high[2]; ++k) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t i = low[0]; i <= high[0]; ++i) {
          if (occupied(Key{i, j, k}, x)) return false;
        }
      }
    }
    const auto [head, fresh] = heads_.try_emplace(key_of(x, cell_), kept_.size());
    next_.push_back(fresh ? none : head->second);
    head->second = kept_.size();
    kept_.push_back(x);
    return true;
  }

  std::vector<Eigen::Vector3d> take() { return std::move(kept_); }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool occupied(const Key& key, const Eigen::Vector3d& x) const {
    const auto head = heads_.find(key);
    if (head == heads_.end()) return false;
    for (std::size_t n = head->second; n != none; n = next_[n]) {
      if ((kept_[n] - x).norm() < distance_) return true;
    }
    return false;
  }

  double distance_;
  double cell_;
  std::unordered_map<Key, std::size_t, KeyHash> heads_;
  std::vector<Eigen::Vector3d> kept_;
  std::vector<std::size_t> next_;
};

/// Finds the largest empty ball that touches a sample on one side: centre = point + radius · direction.
class BallSearch {
 public:
  BallSearch(const SurfaceSamples& samples, const PointTree& tree) : samples_(samples), tree_(tree) {}

  /// `start` > 0 is a guess; the ball grows from it if it is empty. Starting with a huge ball would be slow, because
  /// nearest-neighbour queries far from all samples are slow.
  double radius(std::size_t sample, const Eigen::Vector3d& direction, double osculating, double start) const {
    double radius = std::min(start, osculating);
    for (;;) {
      const double shrunk = shrink(sample, direction, radius);
      if (shrunk < radius || radius >= osculating) return shrunk;
      radius = std::min(2.0 * radius, osculating);
    }
  }

 private:
  double shrink(std::size_t sample, const Eigen::Vector3d& direction, double radius) const {
    const Eigen::Vector3d& p = samples_.points[sample];
    constexpr int max_steps = 50;
    // The search starts at the sample that the ball touched last; its distance from the centre is at most `radius`.
    std::size_t touched = sample;
    for (int step = 0; step < max_steps; ++step) {
      const auto [nearest, distance] = tree_.nearest(p + radius * direction, touched);
      if (distance >= radius * (1.0 - 1e-6)) return radius;
      touched = nearest;
      const Eigen::Vector3d to = samples_.points[nearest] - p;
      const double height = direction.dot(to);
      if (!(height > 0.0)) return radius;  // the sample itself, or one that no tangent ball touches
      const double next = to.squaredNorm() / (2.0 * height);
      if (!(next < radius)) return radius;
      radius = next;
    }
    return radius;
  }

  const SurfaceSamples& samples_;
  const PointTree& tree_;
};

}  // namespace

SurfaceSamples surface_samples(const Isosurface& surface, const std::vector<Eigen::Vector3d>& candidates) {
  constexpr double tolerance = 1e-9;         // voxels
  constexpr double nearest_allowed = 0.1;    // voxels
  constexpr double largest_curvature = 2.0;  // 1/voxel
  std::vector<std::optional<Eigen::Vector3d>> feet(candidates.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, candidates.size(), 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) feet[n] = surface.project(candidates[n], tolerance);
  });
  Thinning thinning(nearest_allowed * surface.voxel(), candidates.size());
  for (const auto& foot : feet) {
    if (foot) thinning.accept(*foot);
  }
  SurfaceSamples samples;
  samples.points = thinning.take();
  const std::size_t count = samples.points.size();
  samples.normals.resize(count);
  samples.curvature.resize(count);
  samples.slope.resize(count);
  const double cap = largest_curvature / surface.voxel();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Jet jet = surface.jet(samples.points[n]);
      const Curvatures k = curvatures(jet);
      samples.normals[n] = outward_normal(jet.gradient);
      samples.curvature[n] = {std::clamp(k.k1, -cap, cap), std::clamp(k.k2, -cap, cap)};
      samples.slope[n] = jet.gradient.norm();
    }
  });
  return samples;
}

MedialBalls shrinking_balls(const SurfaceSamples& samples, double voxel, double cap, Monitor& monitor) {
  const std::size_t count = samples.points.size();
  const PointTree tree(samples.points);
  const BallSearch search(samples, tree);
  // Times the radius of the previous sample; usually large enough, and needs little shrinking.
  constexpr double guess = 1.2;
  const auto osculating = [cap](double bend) { return bend > 1.0 / cap ? 1.0 / bend : cap; };
  MedialBalls balls;
  balls.centres.resize(2 * count);
  balls.radii.resize(2 * count);
  // Slices let the calling thread report progress. Consecutive samples are mostly neighbours on the surface, so the
  // balls of one are the guess for the next. Rows begin at the same samples for any number of threads, because the last
  // digits of a radius depend on the guess.
  constexpr std::size_t slice = 1 << 16;
  constexpr std::size_t row = 256;
  for (std::size_t first = 0; first < count; first += slice) {
    monitor.progress(static_cast<double>(first) / static_cast<double>(count));
    const std::size_t rows = (std::min(count, first + slice) - first + row - 1) / row;
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
      double inner = 4.0 * voxel;
      double outer = inner;
      const std::size_t begin = first + r * row;
      for (std::size_t n = begin; n < std::min(count, begin + row); ++n) {
        const Eigen::Vector3d& normal = samples.normals[n];
        // Inside, a ball touches where the surface is convex (κ1 > 0); outside, where it is concave (κ2 < 0).
        inner = search.radius(n, -normal, osculating(samples.curvature[n].k1), guess * inner);
        outer = search.radius(n, normal, osculating(-samples.curvature[n].k2), guess * outer);
        balls.centres[2 * n] = samples.points[n] - inner * normal;
        balls.radii[2 * n] = inner;
        balls.centres[2 * n + 1] = samples.points[n] + outer * normal;
        balls.radii[2 * n + 1] = outer;
      }
    });
  }
  return balls;
}

struct FeatureSize::Tree {
  Tree(std::vector<Eigen::Vector3d> thinned, double farthest)
      : points(std::move(thinned)), index(points), cap(farthest) {}
  std::vector<Eigen::Vector3d> points;
  PointTree index;
  double cap;
};

FeatureSize::FeatureSize(const MedialBalls& balls, double voxel, double cap) {
  const double cell = voxel / 20.0;
  std::unordered_map<Key, char, KeyHash> seen;
  seen.reserve(balls.centres.size());
  std::vector<Eigen::Vector3d> thinned;
  for (const Eigen::Vector3d& centre : balls.centres) {
    if (seen.emplace(key_of(centre, cell), 0).second) thinned.push_back(centre);
  }
  tree_ = std::make_unique<Tree>(std::move(thinned), cap);
}

FeatureSize::~FeatureSize() = default;
FeatureSize::FeatureSize(FeatureSize&&) noexcept = default;

double FeatureSize::operator()(const Eigen::Vector3d& x) const {
  return tree_->points.empty() ? tree_->cap : std::min(tree_->cap, tree_->index.nearest(x).second);
}

}  // namespace isobench
