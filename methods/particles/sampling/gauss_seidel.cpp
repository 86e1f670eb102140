#include "isobench/methods/particles/sampling/gauss_seidel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "isobench/methods/particles/sampling/energy.h"

namespace isobench::particles {

namespace {

constexpr double first_lambda = 0.1;
constexpr double lambda_bound = 1e15;  // and its inverse
constexpr int most_tries = 12;
constexpr double list_skin = 0.4;  // lists reach this much farther than the potential
// Of the list_skin: neighbours may come as near, and h may change on the way.
constexpr double leash = 0.4;

class GaussSeidel {
 public:
  GaussSeidel(const Isosurface& surface, const Spacing& spacing, Particles& particles, const std::vector<char>& fixed)
      : surface_(surface),
        spacing_(spacing),
        particles_(particles),
        fixed_(fixed),
        lambda_(particles.size(), first_lambda) {
    list_neighbours();
    const std::vector<double> each = energies(particles_, near_);
    energy_ = 0.5 * std::accumulate(each.begin(), each.end(), 0.0);
  }

  double energy() const { return energy_; }

  /// How many particles moved.
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
  struct Pull {
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

  Pull pull(std::size_t i, const Place& place) const {
    const PotentialTable& potential = PotentialTable::instance();
    Pull result;
    for (const std::uint32_t j : near_.of(i)) {
      const Eigen::Vector3d apart = place.point - particles_.points[j];
      const double scale = beta / std::min(place.spacing, particles_.spacing[j]);
      const double square = apart.squaredNorm() * scale * scale;
      if (square >= 1.0 || place.normal.dot(particles_.normals[j]) <= 0.0) continue;
      const double d = std::sqrt(square);
      const PotentialTable::Entry entry = potential.at(d);
      result.energy += entry.energy;
      if (square > 0.0) result.force += apart * (entry.first * scale / d);
    }
    return result;
  }

  /// Where a step from `from` ends on the surface; nothing if it does not count wherever its energy is.
  std::optional<Place> place_after(std::size_t i, const Place& from, const Eigen::Vector3d& step) const {
    const Eigen::Vector3d to = (from.point + step).cwiseMax(0.0).cwiseMin(surface_.extent());
    const auto foot = surface_.project(to);
    if (!foot || (*foot - anchor_[i]).norm() > leash_[i]) return std::nullopt;
    const Eigen::Vector3d normal = outward_normal(surface_.value_gradient(*foot).gradient);
    if (!(normal.dot(from.normal) > 0.0)) return std::nullopt;
    return Place{*foot, normal, spacing_(*foot)};
  }

  bool move(std::size_t i) {
    const Place from{particles_.points[i], particles_.normals[i], particles_.spacing[i]};
    const Pull now = pull(i, from);
    const Eigen::Vector3d downhill = -from.spacing * (now.force - from.normal * from.normal.dot(now.force));
    const double length = downhill.norm();
    if (!(length > 0.0)) return false;
    double& lambda = lambda_[i];
    while (length > lambda * from.spacing) lambda *= 10.0;
    for (int tries = 0; tries < most_tries && lambda <= lambda_bound; ++tries, lambda *= 10.0) {
      const auto place = place_after(i, from, downhill / lambda);
      if (!place) continue;
      const double energy = pull(i, *place).energy;
      if (!(energy < now.energy)) continue;
      energy_ += energy - now.energy;
      settle(i, *place);
      lambda = std::max(0.1 * lambda, 1.0 / lambda_bound);
      return true;
    }
    // Nowhere lower within reach; where the neighbours go will change that.
    lambda = first_lambda;
    return false;
  }

  void settle(std::size_t i, const Place& place) {
    particles_.points[i] = place.point;
    particles_.normals[i] = place.normal;
    particles_.spacing[i] = place.spacing;
    if ((place.point - anchor_[i]).norm() > 0.5 * leash_[i]) strayed_ = true;
  }

  const Isosurface& surface_;
  const Spacing& spacing_;
  Particles& particles_;
  const std::vector<char>& fixed_;
  std::vector<double> lambda_;
  NeighbourLists near_;
  std::vector<Eigen::Vector3d> anchor_;  // where the particles were when the lists were made
  std::vector<double> leash_;            // how far from there the lists serve them
  bool strayed_ = false;
  double energy_ = 0.0;
};

}  // namespace

Round relax_in_order(const Isosurface& surface, const Spacing& spacing, Particles& particles, Monitor& monitor,
                     const RoundEnd& end, const std::vector<char>& fixed) {
  Round round;
  if (particles.size() == 0) return round;
  GaussSeidel relaxation(surface, spacing, particles, fixed);
  const auto count = static_cast<double>(particles.size());
  for (bool done = false; !done && round.sweeps < end.sweeps; ++round.sweeps) {
    monitor.check();
    const double before = relaxation.energy();
    const auto moved = static_cast<double>(relaxation.sweep());
    done = before - relaxation.energy() < end.settled * before;
    monitor.trace("energy", 2.0 * relaxation.energy() / count);
    monitor.trace("moves", moved / count);
  }
  round.energy = relaxation.energy();
  return round;
}

}  // namespace isobench::particles
