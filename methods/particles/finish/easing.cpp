#include "isobench/methods/particles/finish/easing.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/methods/particles/finish/local_spectrum.h"
#include "isobench/methods/particles/finish/thinning.h"

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;
using RaisedBound = AskedAreas::RaisedBound;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double dense = 0.6;  // share of the area asked for; even areas are within 0.65 and 1.5
constexpr int rings = 4;       // around the vertices of a place
constexpr double moves_per_trial = 2e5;
constexpr double moves_per_attempt = 5e4;

/// By how much the bounds of a place are raised, in the order of attempts.
constexpr std::array<double, 6> factors{infinite, 4.0, 2.8, 2.0, 1.4, 1.2};

/// The dense vertices at which one bound holds.
struct Place {
  std::uint32_t bound = 0;
  double share = 1.0;  // the least of the vertices' area shares
  std::vector<Index> vertices;
};

/// The surroundings of a place, and what came of it.
struct Trial {
  std::uint32_t bound = 0;
  Submesh submesh;
  std::size_t factor = factors.size();  // the one that succeeded
  std::vector<RaisedBound> raised;
  double moves = 0.0;
};

bool is_gain(const LocalSpectrum& before, const LocalSpectrum& after) {
  constexpr double gain = 0.95;
  constexpr double well_conditioned = 1.58;  // uniform meshes have 1.5 to 1.6
  return after.step_factor <= gain * before.step_factor && after.scaled <= std::max(well_conditioned, before.scaled);
}

class Easing {
 public:
  Easing(const FinishContext& context, const SizedSurface& sized, EditableMesh& mesh, const ShapeGoal& goal,
         SearchBudget& budget)
      : context_(context),
        sized_(sized),
        bounds_(sized.bounds()),
        unbounded_(context.areas.with_bounds({})),
        mesh_(mesh),
        goal_(goal),
        budget_(budget),
        least_h_(bounds_.size(), 0.0),
        first_factor_(bounds_.size(), 0) {}

  std::size_t run() {
    while (budget_.moves > 0.0) {
      const std::vector<Place> places = densest_places();
      if (places.empty() || is_closed(places.front())) break;
      try_at(places);
    }
    return static_cast<std::size_t>(std::count_if(least_h_.begin(), least_h_.end(), [](double h) { return h > 0.0; }));
  }

 private:
  bool is_closed(const Place& place) const { return first_factor_[place.bound] == factors.size(); }
  double bound_at(std::uint32_t n, const Eigen::Vector3d& x) const {
    return std::max(least_h_[n], bounds_.bound(n, x));
  }

  std::optional<std::uint32_t> holding_at(const Eigen::Vector3d& x) const;
  std::vector<Place> densest_places() const;
  void try_at(const std::vector<Place>& places);
  std::vector<Trial> separate_trials(const std::vector<Place>& places) const;
  void carry_out(Trial& trial, double moves) const;
  bool attempt(Trial& trial, std::size_t factor, SearchBudget& budget) const;
  std::vector<RaisedBound> raised_bounds(const Trial& trial, double least_h) const;

  const FinishContext& context_;
  const SizedSurface& sized_;
  const SizeBounds& bounds_;
  const AskedAreas unbounded_;  // the areas that the sizing asks for without the bounds
  EditableMesh& mesh_;
  const ShapeGoal& goal_;
  SearchBudget& budget_;
  std::vector<double> least_h_;            // mm: to which each bound has been raised; 0: not raised
  std::vector<std::size_t> first_factor_;  // the factor with which to begin at each bound
};

/// The bound that is smallest at x, if it is smaller than the sizing field.
std::optional<std::uint32_t> Easing::holding_at(const Eigen::Vector3d& x) const {
  std::optional<std::uint32_t> smallest;
  double least = sized_.field().h(x);
  for (const std::uint32_t n : bounds_.reaching(x)) {
    const double h = bound_at(n, x);
    if (h >= least) continue;
    least = h;
    smallest = n;
  }
  return smallest;
}

/// The densest place first, and those with up to twice its share of area after it.
std::vector<Place> Easing::densest_places() const {
  const std::vector<double> shares = area_shares(mesh_, unbounded_);
  std::map<std::uint32_t, Place> by_bound;
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    if (!mesh_.movable(v) || shares[v] >= dense) continue;
    const auto bound = holding_at(mesh_.points[v]);
    if (!bound) continue;
    Place& place = by_bound[*bound];
    place.bound = *bound;
    place.share = std::min(place.share, shares[v]);
    place.vertices.push_back(v);
  }
  std::vector<Place> places;
  for (auto& [bound, place] : by_bound) places.push_back(std::move(place));
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.share < b.share; });
  while (!places.empty() && places.back().share > 2.0 * places.front().share) places.pop_back();
  return places;
}

/// Those places whose surroundings do not overlap.
std::vector<Trial> Easing::separate_trials(const std::vector<Place>& places) const {
  std::vector<Trial> trials;
  std::vector<std::uint8_t> taken(mesh_.vertex_count(), 0);
  for (const Place& place : places) {
    if (is_closed(place)) continue;
    Submesh submesh = extract_submesh(mesh_, place.vertices, rings);
    const std::vector<Index>& vertices = submesh.vertices;
    if (std::any_of(vertices.begin(), vertices.end(), [&taken](Index v) { return taken[v] != 0; })) continue;
    for (const Index v : vertices) taken[v] = 1;
    trials.push_back({.bound = place.bound, .submesh = std::move(submesh), .raised = {}});
  }
  return trials;
}

void Easing::try_at(const std::vector<Place>& places) {
  std::vector<Trial> trials = separate_trials(places);
  const double moves = std::min(moves_per_trial, budget_.moves / static_cast<double>(trials.size()));
  tbb::parallel_for(std::size_t{0}, trials.size(), [&](std::size_t k) { carry_out(trials[k], moves); });
  for (const Trial& trial : trials) {
    budget_.moves -= std::max(1.0, trial.moves);
    first_factor_[trial.bound] = trial.factor;
    if (trial.factor == factors.size()) continue;
    for (const auto& [bound, least_h] : trial.raised) least_h_[bound] = least_h;
    put_back_submesh(mesh_, trial.submesh);
  }
}

/// Attempts one factor after another until one succeeds.
void Easing::carry_out(Trial& trial, double moves) const {
  double left = moves;
  for (std::size_t f = first_factor_[trial.bound]; f < factors.size() && left > 0.0; ++f) {
    SearchBudget budget{std::min(moves_per_attempt, left)};
    left -= budget.moves;
    const bool succeeded = attempt(trial, f, budget);
    left += budget.moves;
    if (succeeded) break;
  }
  trial.moves = moves - left;
}

bool Easing::attempt(Trial& trial, std::size_t factor, SearchBudget& budget) const {
  const double h = bound_at(trial.bound, bounds_.at(trial.bound).position);
  std::vector<RaisedBound> raised = raised_bounds(trial, factors[factor] * h);
  const AskedAreas before = context_.areas.with_bounds(raised_bounds(trial, 0.0));
  FinishContext context = context_;
  context.areas = context_.areas.with_bounds(raised);
  context.energies.rounds.range = infinite;  // vertices must spread
  EditableMesh mesh = trial.submesh.mesh;
  if (!thin_out(context, before, goal_, mesh, budget)) return false;
  const auto spectrum = [this](const EditableMesh& of) { return local_spectrum(of, unbounded_.at_vertices(of)); };
  if (!is_gain(spectrum(trial.submesh.mesh), spectrum(mesh))) return false;
  trial.factor = factor;
  trial.raised = std::move(raised);
  trial.submesh.mesh = std::move(mesh);
  return true;
}

/// The bounds that reach the surroundings of a place; those that belong to the place are raised. Bounds come in groups,
/// and raising one of a group would change nothing.
std::vector<RaisedBound> Easing::raised_bounds(const Trial& trial, double least_h) const {
  Eigen::AlignedBox3d surroundings;
  for (const Eigen::Vector3d& x : trial.submesh.mesh.points) surroundings.extend(x);
  Eigen::AlignedBox3d core;
  for (const Index v : trial.submesh.core) core.extend(trial.submesh.mesh.points[v]);
  const double margin = 2.0 * bounds_.at(trial.bound).h;
  std::vector<RaisedBound> result;
  for (const std::uint32_t n : bounds_.reaching(surroundings)) {
    const bool belongs = n == trial.bound || core.exteriorDistance(bounds_.at(n).position) <= margin;
    result.push_back({n, belongs ? std::max(least_h_[n], least_h) : least_h_[n]});
  }
  return result;
}

}  // namespace

std::size_t ease_bounds(const FinishContext& context, const SizedSurface& sized, EditableMesh& mesh,
                        const ShapeGoal& goal, SearchBudget& budget) {
  return Easing(context, sized, mesh, goal, budget).run();
}

}  // namespace isobench::particles
