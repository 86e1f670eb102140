#include "isobench/experiments/plan/vertex_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isobench {

double VertexMatch::relative_error(const Try& attempt) const { return std::abs(attempt.vertices / target_ - 1.0); }

std::size_t VertexMatch::best() const {
  const auto nearer = [this](const Try& a, const Try& b) { return relative_error(a) < relative_error(b); };
  return static_cast<std::size_t>(std::min_element(tries_.begin(), tries_.end(), nearer) - tries_.begin());
}

bool VertexMatch::all_gave_the_same() const {
  return std::all_of(tries_.begin(), tries_.end(),
                     [this](const Try& attempt) { return attempt.vertices == tries_.front().vertices; });
}

// From the last try along the slope of the last two. If all tries gave the same number, by n ∝ 1/scale², as on a
// surface.
double VertexMatch::extrapolated_scale() const {
  const Try& last = tries_.back();
  double power = 2.0;
  if (!all_gave_the_same()) {
    const Try& before = tries_[tries_.size() - 2];
    power = -std::log(last.vertices / before.vertices) / std::log(last.scale / before.scale);
    power = std::isfinite(power) ? std::clamp(power, 0.1, 4.0) : 2.0;
  }
  // A larger step would trust the slope too far, and a mesh much finer than wanted may not fit into memory.
  constexpr double largest_step = 4.0;
  double step = std::clamp(std::pow(last.vertices / target_, 1.0 / power), 1.0 / largest_step, largest_step);
  // A method that refines in stages gives the same number for similar scales; a larger step leaves such a plateau.
  constexpr double stride = 2.0;
  if (tries_.size() > 1 && all_gave_the_same())
    step = step > 1.0 ? std::max(step, stride) : std::min(step, 1.0 / stride);
  return last.scale * step;
}

std::optional<double> VertexMatch::next() const {
  if (tries_.empty()) return 1.0;
  if (relative_error(tries_[best()]) <= tolerance || tries_.size() >= most_tries) return std::nullopt;
  // A method such as marching cubes, whose number of vertices does not depend on the sizing.
  if (tries_.size() > 2 && all_gave_the_same()) return std::nullopt;
  // The smallest scale that gave too few vertices, and the largest one that gave too many.
  const Try* few = nullptr;
  const Try* many = nullptr;
  for (const Try& attempt : tries_) {
    if (attempt.vertices < target_ && (few == nullptr || attempt.scale < few->scale)) few = &attempt;
    if (attempt.vertices > target_ && (many == nullptr || attempt.scale > many->scale)) many = &attempt;
  }
  // They are no bracket if `few` is the smaller scale, which happens if the number does not fall steadily.
  if (few == nullptr || many == nullptr || few->scale <= many->scale) return extrapolated_scale();
  // Every other step halves the bracket, because the secant of a convex curve moves only one of its ends.
  const double secant = std::log(many->vertices / target_) / std::log(many->vertices / few->vertices);
  const double at = tries_.size() % 2 == 0 ? std::clamp(secant, 0.05, 0.95) : 0.5;
  return many->scale * std::pow(few->scale / many->scale, at);
}

std::string VertexMatch::reason() const {
  const Try& nearest = tries_[best()];
  if (relative_error(nearest) <= tolerance) return "";
  if (all_gave_the_same()) return "its number of vertices does not follow the sizing";
  return fmt::format("the nearest of {} tries was {:.1f} % off", tries_.size(), 100.0 * relative_error(nearest));
}

}  // namespace isobench
