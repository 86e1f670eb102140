#include "isobench/methods/cvt/optimise.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "isobench/methods/cvt/cells.h"

namespace isobench::cvt {

namespace {

using particles::Particles;

constexpr double settled = 1e-7;  // the iterations end when the energy falls by less than this share of itself
constexpr double longest = 0.3;   // largest step, times the spacing; flips can follow it
constexpr std::size_t memory = 7;
constexpr int most_tries = 6;

template <class Body>
void for_all(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 512), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) body(n);
  });
}

/// One value for each coordinate of each point.
using Field = Eigen::Matrix<double, 3, Eigen::Dynamic>;

double dot(const Field& a, const Field& b) { return a.cwiseProduct(b).sum(); }

/// The last steps, the changes of the gradient over them, and the direction that follows from both (Nocedal 1980).
class History {
 public:
  void remember(Field step, Field change) {
    const double curvature = dot(step, change);
    if (curvature <= 1e-10 * std::sqrt(step.squaredNorm() * change.squaredNorm())) return;
    if (pairs_.size() == memory) pairs_.pop_front();
    pairs_.push_back({std::move(step), std::move(change), curvature});
  }

  void forget() { pairs_.clear(); }

  /// −H · gradient, where H approximates the inverse Hessian. `inverse` is the diagonal of its first guess.
  Field direction(Field gradient, const Eigen::RowVectorXd& inverse) const {
    std::vector<double> along(pairs_.size());
    for (std::size_t n = pairs_.size(); n-- > 0;) {
      along[n] = dot(pairs_[n].step, gradient) / pairs_[n].curvature;
      gradient -= along[n] * pairs_[n].change;
    }
    double scale = 1.0;
    if (!pairs_.empty()) {
      const Field& change = pairs_.back().change;
      scale = pairs_.back().curvature / (change.colwise().squaredNorm().cwiseProduct(inverse)).sum();
    }
    gradient = gradient.cwiseProduct((scale * inverse).replicate(3, 1)).eval();
    for (std::size_t n = 0; n < pairs_.size(); ++n) {
      gradient += (along[n] - dot(pairs_[n].change, gradient) / pairs_[n].curvature) * pairs_[n].step;
    }
    return -gradient;
  }

 private:
  struct Pair {
    Field step;
    Field change;
    double curvature;
  };
  std::deque<Pair> pairs_;
};

class Optimiser {
 public:
  Optimiser(const particles::SizedSurface& sized, Particles& sites, DelaunayMesh& mesh, Monitor& monitor)
      : sized_(sized), sites_(sites), mesh_(mesh), monitor_(monitor) {
    for_all(sites_.size(), [&](std::size_t n) { sites_.spacing[n] = sized_.spacing(sites_.points[n]); });
    update_cells();
  }

  Optimised run(const Iterations& iterations) {
    const double all = std::max(1, iterations.lloyd + iterations.quasi_newton);
    double before = 2.0 * cells_.energy;
    while (done_.lloyd < iterations.lloyd && cells_.energy < (1.0 - settled) * before) {
      monitor_.progress(done_.lloyd / all);
      trace_energy();
      before = cells_.energy;
      move_to(towards_centroids());
      ++done_.lloyd;
    }
    before = 2.0 * cells_.energy;
    while (done_.quasi_newton < iterations.quasi_newton && cells_.energy < (1.0 - settled) * before) {
      monitor_.progress((iterations.lloyd + done_.quasi_newton) / all);
      trace_energy();
      before = cells_.energy;
      step_by_history();
      ++done_.quasi_newton;
    }
    trace_energy();
    done_.energy = cells_.energy / cells_.hexagonal;
    return done_;
  }

 private:
  void trace_energy() { monitor_.trace("energy", cells_.energy / cells_.hexagonal); }

  void update_cells() {
    done_.flips += mesh_.flip(sites_.points);
    cells_ = voronoi_cells(sites_.points, sites_.spacing, mesh_.triangles());
  }

  Field towards_centroids() const {
    Field step(3, sites_.size());
    for_all(sites_.size(), [&](std::size_t n) {
      step.col(static_cast<Eigen::Index>(n)) = tangential(n, cells_.centroids[n] - sites_.points[n]);
    });
    return step;
  }

  Eigen::Vector3d tangential(std::size_t n, const Eigen::Vector3d& v) const {
    return v - v.dot(sites_.normals[n]) * sites_.normals[n];
  }

  /// Moves all sites by their steps and projects them to F = c. A site that would get to another sheet stays.
  void move_to(const Field& step, double length = 1.0) {
    const Particles from = sites_;
    for_all(from.size(), [&](std::size_t n) {
      Eigen::Vector3d by = length * step.col(static_cast<Eigen::Index>(n));
      const double most = longest * from.spacing[n];
      if (by.squaredNorm() > most * most) by *= most / by.norm();
      const auto foot = sized_.surface().project(from.points[n] + by);
      if (!foot) return;
      const Eigen::Vector3d normal = outward_normal(sized_.surface().value_gradient(*foot).gradient);
      if (normal.dot(from.normals[n]) <= 0.0) return;
      sites_.points[n] = *foot;
      sites_.normals[n] = normal;
      sites_.spacing[n] = sized_.spacing(*foot);
    });
    update_cells();
  }

  Field gradient() const {
    Field gradient = -towards_centroids();
    for_all(sites_.size(),
            [&](std::size_t n) { gradient.col(static_cast<Eigen::Index>(n)) *= 2.0 * std::max(0.0, cells_.mass[n]); });
    return gradient;
  }

  Eigen::RowVectorXd inverse_masses() const {
    Eigen::RowVectorXd inverse(sites_.size());
    for (std::size_t n = 0; n < sites_.size(); ++n) {
      inverse[static_cast<Eigen::Index>(n)] = cells_.mass[n] > 0.0 ? 0.5 / cells_.mass[n] : 0.0;
    }
    return inverse;
  }

  void step_by_history() {
    const Field before = gradient();
    Field direction = history_.direction(before, inverse_masses());
    double slope = dot(before, direction);
    if (slope >= 0.0) {
      history_.forget();
      direction = history_.direction(before, inverse_masses());
      slope = dot(before, direction);
    }
    const Particles start = sites_;
    const Cells cells = cells_;
    double length = 1.0;
    for (int tries = 0; tries < most_tries; ++tries, length *= 0.5) {
      if (tries > 0) {
        sites_ = start;
        ++done_.shortened;
      }
      move_to(direction, length);
      if (cells_.energy <= cells.energy + 1e-4 * length * slope) {
        Field moved(3, sites_.size());
        for (std::size_t n = 0; n < sites_.size(); ++n) {
          moved.col(static_cast<Eigen::Index>(n)) = sites_.points[n] - start.points[n];
        }
        history_.remember(std::move(moved), gradient() - before);
        return;
      }
    }
    // The remembered steps are of no use here. Forget them, and take a step of Lloyd's.
    history_.forget();
    sites_ = start;
    update_cells();
    move_to(towards_centroids());
  }

  const particles::SizedSurface& sized_;
  Particles& sites_;
  DelaunayMesh& mesh_;
  Monitor& monitor_;
  Cells cells_;
  History history_;
  Optimised done_;
};

}  // namespace

Optimised optimise(const particles::SizedSurface& sized, Particles& sites, DelaunayMesh& mesh,
                   const Iterations& iterations, Monitor& monitor) {
  return Optimiser(sized, sites, mesh, monitor).run(iterations);
}

}  // namespace isobench::cvt
