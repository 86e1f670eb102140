#include "isobench/methods/particles/relaxation/gauss_seidel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "isobench/methods/particles/relaxation/potential.h"

namespace isobench::particles {

namespace {

constexpr double first_lambda = 0.1;
constexpr double largest_lambda = 1e15;  // its inverse is the smallest
constexpr int most_tries = 12;
constexpr double list_skin = 0.4;  // share by which neighbour lists reach beyond the potential
// The share of the skin that a particle may move before the lists are renewed. It is less than a half, because
// neighbours move as well and the spacing changes on the way.
constexpr double leash = 0.4;

class GaussSeidel {
 public:
  GaussSeidel(const SizedSurface& sized, Particles& particles, const std::vector<char>& fixed)
      : sized_(sized), particles_(particles), fixed_(fixed), lambda_(particles.size(), first_lambda) {
    list_neighbours();
    const std::vector<double> each = energies(particles_, near_);
    energy_ = 0.5 * std::accumulate(each.begin(), each.end(), 0.0);
  }

  double energy() const { return energy_; }

  /// Returns how many particles moved.
  std::size_t sweep() {
    if (strayed_) list_neighbours();
    std::size_t moved = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      if (fixed_.empty() || fixed_[i] == 0) moved += move(i) ? 1 : 0;
    }
    return moved;
  }

 private:
  struct Place {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;
    double spacing = 0.0;
  };
  struct Forces {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // Σ E′ unit(x_i − x_j)
    double energy = 0.0;
  };

  void list_neighbours() {
    near_ = acting_neighbours(particles_, list_skin);
    anchor_ = particles_.points;
    leash_.resize(particles_.size());
    for (std::size_t i = 0; i < leash_.size(); ++i) leash_[i] = leash * list_skin / beta * particles_.spacing[i];
    strayed_ = false;
  }

  Forces forces_at(std::size_t i, const Place& place) const {
    const PotentialTable& potential = PotentialTable::instance();
    Forces result;
    for (const std::uint32_t j : near_.of(i)) {
      const Eigen::Vector3d apart = place.point - particles_.points[j];
      const double scale = beta / std::min(place.spacing, particles_.spacing[j]);
      const double square = apart.squaredNorm() * scale * scale;
      if (square >= 1.0 || place.normal.dot(particles_.normals[j]) <= 0.0) continue;
      const double d = std::sqrt(square);
      const PotentialTable::Entry entry = potential.at(d);
      result.energy += entry.energy;
      if (square > 0.0) result.force += apart * (entry.derivative * scale / d);
    }
    return result;
  }

  /// Where a step from `from` ends on the surface; nothing if the step is refused whatever its energy.
  std::optional<Place> place_after(std::size_t i, const Place& from, const Eigen::Vector3d& step) const {
    const Eigen::Vector3d to = (from.point + step).cwiseMax(0.0).cwiseMin(sized_.surface().extent());
    const auto foot = sized_.surface().project(to);
    if (!foot || (*foot - anchor_[i]).norm() > leash_[i]) return std::nullopt;
    const Eigen::Vector3d normal = outward_normal(sized_.surface().value_gradient(*foot).gradient);
    if (!(normal.dot(from.normal) > 0.0)) return std::nullopt;
    return Place{*foot, normal, sized_.spacing(*foot)};
  }

  bool move(std::size_t i) {
    const Place from{particles_.points[i], particles_.normals[i], particles_.spacing[i]};
    const Forces now = forces_at(i, from);
    const Eigen::Vector3d downhill = -from.spacing * (now.force - from.normal * from.normal.dot(now.force));
    const double length = downhill.norm();
    if (!(length > 0.0)) return false;
    double& lambda = lambda_[i];
    while (length > lambda * from.spacing) lambda *= 10.0;
    for (int tries = 0; tries < most_tries && lambda <= largest_lambda; ++tries, lambda *= 10.0) {
      const auto place = place_after(i, from, downhill / lambda);
      if (!place) continue;
      const double energy = forces_at(i, *place).energy;
      if (!(energy < now.energy)) continue;
      energy_ += energy - now.energy;
      settle(i, *place);
      lambda = std::max(0.1 * lambda, 1.0 / largest_lambda);
      return true;
    }
    // No lower energy in reach. This may change once the neighbours have moved.
    lambda = first_lambda;
    return false;
  }

  void settle(std::size_t i, const Place& place) {
    particles_.points[i] = place.point;
    particles_.normals[i] = place.normal;
    particles_.spacing[i] = place.spacing;
    if ((place.point - anchor_[i]).norm() > 0.5 * leash_[i]) strayed_ = true;
  }

  const SizedSurface& sized_;
  Particles& particles_;
  const std::vector<char>& fixed_;
  std::vector<double> lambda_;
  NeighbourLists near_;
  std::vector<Eigen::Vector3d> anchor_;  // positions when the neighbour lists were made
  std::vector<double> leash_;            // how far from there the lists are valid
  bool strayed_ = false;
  double energy_ = 0.0;
};

}  // namespace

GaussSeidelResult relax_by_gauss_seidel(const SizedSurface& sized, Particles& particles, Monitor& monitor,
                                        const StopCriterion& stop, const std::vector<char>& fixed) {
  GaussSeidelResult result;
  if (particles.size() == 0) return result;
  GaussSeidel relaxation(sized, particles, fixed);
  const auto count = static_cast<double>(particles.size());
  for (bool done = false; !done && result.sweeps < stop.sweeps; ++result.sweeps) {
    monitor.check();
    const double before = relaxation.energy();
    const auto moved = static_cast<double>(relaxation.sweep());
    done = before - relaxation.energy() < stop.relative_fall * before;
    monitor.trace("energy", 2.0 * relaxation.energy() / count);
    monitor.trace("moves", moved / count);
  }
  result.energy = relaxation.energy();
  return result;
}

}  // namespace isobench::particles
