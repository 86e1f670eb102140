// Bringing a method to a given number of vertices by scaling what it is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace isobench {

/// The search for the scale of the edge lengths at which a method gives a number of vertices: a secant method on the
/// logarithms, as the number goes with scale^−p, p near 2; kept within the bracket once there is one.
class VertexMatch {
 public:
  static constexpr double tolerance = 0.02;  ///< relative; what counts as matched
  static constexpr std::size_t largest_tries = 10;

  /// target ≥ 1.
  explicit VertexMatch(double target) : target_(target) {}

  /// The scale to try next, 1 at first; std::nullopt once the number is reached, or there is no hope that it will be.
  std::optional<double> next() const;
  /// What a try came to; vertices ≥ 1.
  void tried(double scale, double vertices) { tries_.push_back({scale, vertices}); }

  std::size_t tries() const { return tries_.size(); }
  /// The index of the try that is nearest to the target, the first of equals; there must be one.
  std::size_t best() const;
  double best_scale() const { return tries_[best()].scale; }
  /// Why the number was not reached, as a sentence without a full stop; "" where it was.
  std::string reason() const;

 private:
  struct Try {
    double scale;
    double vertices;
  };
  double off(const Try& attempt) const;
  bool constant() const;
  double extrapolated() const;

  double target_;
  std::vector<Try> tries_;
};

}  // namespace isobench
