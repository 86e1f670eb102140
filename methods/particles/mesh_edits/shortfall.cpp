#include "isobench/methods/particles/mesh_edits/shortfall.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isobench::particles {

namespace {

using Index = EditableMesh::Index;

// Added to the shortfall of every bad triangle or edge, so that few large ones are better than many small ones.
constexpr double base_shortfall = 0.2;
// Searches must not pay for the shapes of a few triangles with a valence that is out of bounds.
constexpr double extreme_valence = 4.0;

}  // namespace

double triangle_shortfall(const EditableMesh& mesh, const Triangle& t, const ShapeGoal& goal) {
  const double a = (mesh.points[t[1]] - mesh.points[t[2]]).norm();
  const double b = (mesh.points[t[2]] - mesh.points[t[0]]).norm();
  const double c = (mesh.points[t[0]] - mesh.points[t[1]]).norm();
  const double q = (b + c - a) * (c + a - b) * (a + b - c) / std::max(a * b * c, 1e-300);
  if (q > 0.93) return 0.0;  // all angles are then within 42.5° to 79°
  double low = std::min({a, b, c});
  double high = std::max({a, b, c});
  const double middle = a + b + c - low - high;
  const auto angle = [](double opposite, double left, double right) {
    const double cosine = (left * left + right * right - opposite * opposite) / std::max(2.0 * left * right, 1e-300);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  };
  const double miss = std::max({(goal.radius_ratio - q) / 0.05, (goal.least_angle - angle(low, middle, high)) / 5.0,
                                (angle(high, middle, low) - goal.largest_angle) / 5.0});
  return miss > 0.0 ? miss + base_shortfall : 0.0;
}

double valence_shortfall(const EditableMesh& mesh, Index v) {
  const double away = std::abs(static_cast<double>(mesh.valence(v)) - 6.0);
  return away > 1.0 ? extreme_valence * (away - 1.0) : 0.0;
}

double edge_shortfall(double over_h0) {
  const double over = over_h0 - 0.999;
  return over > 0.0 ? base_shortfall + 20.0 * over : 0.0;
}

double edge_shortfall(const FinishContext& context, const EditableMesh& mesh, Index e) {
  if (context.sizing.uniform()) return 0.0;
  return edge_shortfall(edge_over_h0(context, mesh.points[mesh.origin(e)], mesh.points[mesh.target(e)]));
}

bool is_first_of_edge(const EditableMesh& mesh, Index e) {
  return mesh.origin(e) != EditableMesh::none && (mesh.twin(e) == EditableMesh::none || e < mesh.twin(e));
}

double shortfall(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal) {
  double sum = 0.0;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (mesh.origin(e) == EditableMesh::none) continue;
    if (e % 3 == 0) sum += triangle_shortfall(mesh, mesh.triangle(e / 3), goal);
    if (is_first_of_edge(mesh, e)) sum += edge_shortfall(context, mesh, e);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.alive(v)) sum += valence_shortfall(mesh, v);
  }
  return sum;
}

}  // namespace isobench::particles
