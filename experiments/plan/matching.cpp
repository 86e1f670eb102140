#include "isobench/experiments/plan/matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isobench {

double VertexMatch::off(const Try& attempt) const { return std::abs(attempt.vertices / target_ - 1.0); }

std::size_t VertexMatch::best() const {
  const auto nearer = [this](const Try& a, const Try& b) { return off(a) < off(b); };
  return static_cast<std::size_t>(std::min_element(tries_.begin(), tries_.end(), nearer) - tries_.begin());
}

bool VertexMatch::constant() const {
  return std::all_of(tries_.begin(), tries_.end(),
                     [this](const Try& attempt) { return attempt.vertices == tries_.front().vertices; });
}

// From the last try along the slope of the last two, or of a surface's n ∝ 1/scale² where they cannot tell.
double VertexMatch::extrapolated() const {
  const Try& last = tries_.back();
  double power = 2.0;
  if (!constant()) {
    const Try& before = tries_[tries_.size() - 2];
    power = -std::log(last.vertices / before.vertices) / std::log(last.scale / before.scale);
    power = std::isfinite(power) ? std::clamp(power, 0.1, 4.0) : 2.0;
  }
  // One step may not change the number beyond what the slope can be trusted for, or memory holds.
  constexpr double largest_step = 4.0;
  double step = std::clamp(std::pow(last.vertices / target_, 1.0 / power), 1.0 / largest_step, largest_step);
  // The same number twice may be a stair's tread: a stride shows whether it is one.
  constexpr double stride = 2.0;
  if (tries_.size() > 1 && constant()) step = step > 1.0 ? std::max(step, stride) : std::min(step, 1.0 / stride);
  return last.scale * step;
}

std::optional<double> VertexMatch::next() const {
  if (tries_.empty()) return 1.0;
  if (off(tries_[best()]) <= tolerance || tries_.size() >= largest_tries) return std::nullopt;
  // Marching cubes meshes its lattice whatever it is asked for.
  if (tries_.size() > 2 && constant()) return std::nullopt;
  // The finest of the scales that gave too few vertices and the coarsest of those that gave too many.
  const Try* few = nullptr;
  const Try* many = nullptr;
  for (const Try& attempt : tries_) {
    if (attempt.vertices < target_ && (few == nullptr || attempt.scale < few->scale)) few = &attempt;
    if (attempt.vertices > target_ && (many == nullptr || attempt.scale > many->scale)) many = &attempt;
  }
  // Where the number does not fall throughout, the two may lie the wrong way round and say nothing.
  if (few == nullptr || many == nullptr || few->scale <= many->scale) return extrapolated();
  // Every other step halves, as a secant of a bent curve moves one end of the bracket alone.
  const double secant = std::log(many->vertices / target_) / std::log(many->vertices / few->vertices);
  const double at = tries_.size() % 2 == 0 ? std::clamp(secant, 0.05, 0.95) : 0.5;
  return many->scale * std::pow(few->scale / many->scale, at);
}

std::string VertexMatch::reason() const {
  const Try& nearest = tries_[best()];
  if (off(nearest) <= tolerance) return "";
  if (constant()) return "its number of vertices does not follow the sizing";
  return fmt::format("the nearest of {} tries was {:.1f} % off", tries_.size(), 100.0 * off(nearest));
}

}  // namespace isobench
