// Bringing a method's mesh to a given number of vertices by scaling the edge lengths that are asked of the method.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace isobench {

/// Searches for the scale of the edge lengths at which a method gives a target number of vertices. The number falls as
/// scale^−p with p near 2, so this is a secant method on the logarithms; once two tries bracket the target, it stays
/// between them.
class VertexMatch {
 public:
  static constexpr double tolerance = 0.02;  ///< relative; this near to the target counts as matched
  static constexpr std::size_t most_tries = 10;

  /// target ≥ 1.
  explicit VertexMatch(double target) : target_(target) {}

  /// The scale to try next, 1 at first; std::nullopt once the target is reached or the tries show that it cannot be.
  std::optional<double> next() const;
  /// The number of vertices that a try gave, ≥ 1.
  void tried(double scale, double vertices) { tries_.push_back({scale, vertices}); }

  std::size_t tries() const { return tries_.size(); }
  /// The index of the try that came nearest to the target, the first of equally near ones. There must be a try.
  std::size_t best() const;
  double best_scale() const { return tries_[best()].scale; }
  /// Why the target was not reached, as a sentence without a full stop; "" where it was.
  std::string reason() const;

 private:
  struct Try {
    double scale;
    double vertices;
  };
  double relative_error(const Try& attempt) const;
  bool all_gave_the_same() const;
  double extrapolated_scale() const;

  double target_;
  std::vector<Try> tries_;
};

}  // namespace isobench
