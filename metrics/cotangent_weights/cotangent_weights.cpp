#include "isobench/metrics/cotangent_weights/cotangent_weights.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/metrics/finite_elements/finite_elements.h"

namespace isobench {

namespace {

// Right angles are common, and their cotangents are 0 only up to rounding.
constexpr double below_zero = -1e-9;

double percent_of(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::size_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

}  // namespace

CotangentWeights measure_cotangent_weights(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides) {
  CotangentWeights figures;
  std::vector<std::uint8_t> has_triangle(mesh.vertices.size(), 0);
  std::vector<std::uint8_t> negative_row(mesh.vertices.size(), 0);
  std::vector<std::uint8_t> obtuse(mesh.triangles.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    end = edge_end(sides, begin);
    const auto [low, high] = std::pair(sides[begin].low, sides[begin].high);
    double sum = 0.0;
    for (std::size_t s = begin; s < end; ++s) {
      const Triangle& t = mesh.triangles[sides[s].triangle];
      const Eigen::Vector3d& apex = mesh.vertices[t[(sides[s].corner + 2U) % 3U]];
      const double cot = cotangent(mesh.vertices[low] - apex, mesh.vertices[high] - apex);
      if (cot < below_zero) obtuse[sides[s].triangle] = 1;
      sum += cot;
    }
    has_triangle[low] = has_triangle[high] = 1;
    // −∞ + ∞, of two triangles without area, is no number and counts as negative.
    if (sum >= below_zero) continue;
    ++figures.negative;
    negative_row[low] = negative_row[high] = 1;
  }
  figures.negative_row_percent = percent_of(count(negative_row), count(has_triangle));
  figures.obtuse_percent = percent_of(count(obtuse), sides.size() / 3);
  return figures;
}

}  // namespace isobench
