#include "isobench/metrics/finite_elements/finite_elements.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace isobench {

namespace {

double area_of(const TriangleMesh& mesh, const Triangle& t) {
  const auto& x = mesh.vertices;
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
}

/// The cotangent of the angle opposite to a side of a triangle.
double opposite_cotangent(const TriangleMesh& mesh, const HalfEdge& side) {
  const Triangle& t = mesh.triangles[side.triangle];
  const Eigen::Vector3d& apex = mesh.vertices[t[(side.corner + 2U) % 3U]];
  return cotangent(mesh.vertices[side.low] - apex, mesh.vertices[side.high] - apex);
}

/// For each vertex its unknown. Sets the vertex of each unknown.
std::vector<std::int32_t> number_unknowns(const TriangleMesh& mesh, std::vector<std::uint32_t>& vertex) {
  std::vector<std::int32_t> unknown(mesh.vertices.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    if (is_collapsed(t)) continue;
    for (const std::uint32_t v : t) unknown[v] = 0;
  }
  for (std::uint32_t v = 0; v < unknown.size(); ++v) {
    if (unknown[v] < 0) continue;
    unknown[v] = static_cast<std::int32_t>(vertex.size());
    vertex.push_back(v);
  }
  return unknown;
}

using Triplets = std::vector<Eigen::Triplet<double, std::int32_t>>;

void add_edge(Triplets& entries, std::int32_t a, std::int32_t b, double value) {
  entries.emplace_back(a, b, value);
  entries.emplace_back(b, a, value);
}

SparseMatrix matrix(std::size_t size, const Triplets& beside, const Eigen::VectorXd& diagonal) {
  Triplets entries = beside;
  for (Eigen::Index i = 0; i < diagonal.size(); ++i) {
    entries.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(i), diagonal[i]);
  }
  SparseMatrix result(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

double cotangent(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const double along = u.dot(v);
  // 0/0 where the corner is at the same place as another one: no angle, and no weight.
  return along == 0.0 ? 0.0 : along / u.cross(v).norm();
}

double FiniteElements::mean_squared_edge() const {
  return 4.0 / std::numbers::sqrt3 * area / static_cast<double>(triangles);
}

double FiniteElements::squared_radius() const { return area / (4.0 * std::numbers::pi); }

FiniteElements finite_elements(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides) {
  FiniteElements result;
  const std::vector<std::int32_t> unknown = number_unknowns(mesh, result.vertex);
  const std::size_t size = result.vertex.size();
  std::vector<double> cotangents(sides.size());
  tbb::parallel_for(std::size_t{0}, sides.size(),
                    [&](std::size_t s) { cotangents[s] = opposite_cotangent(mesh, sides[s]); });
  std::vector<double> areas(mesh.triangles.size(), 0.0);
  result.lumped_mass = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (is_collapsed(mesh.triangles[t])) continue;
    areas[t] = area_of(mesh, mesh.triangles[t]);
    result.area += areas[t];
    ++result.triangles;
    for (const std::uint32_t v : mesh.triangles[t]) result.lumped_mass[unknown[v]] += areas[t] / 3.0;
  }
  result.on_border.assign(size, 0);
  Triplets stiffness;
  Triplets mass;
  Eigen::VectorXd row_sums = Eigen::VectorXd::Zero(result.size());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    end = edge_end(sides, begin);
    double weight = 0.0;
    double around = 0.0;
    for (std::size_t s = begin; s < end; ++s) {
      weight += 0.5 * cotangents[s];
      around += areas[sides[s].triangle];
    }
    const std::int32_t a = unknown[sides[begin].low];
    const std::int32_t b = unknown[sides[begin].high];
    add_edge(stiffness, a, b, -weight);
    add_edge(mass, a, b, around / 12.0);
    row_sums[a] += weight;
    row_sums[b] += weight;
    if (end - begin != 2)
      result.on_border[static_cast<std::size_t>(a)] = result.on_border[static_cast<std::size_t>(b)] = 1;
  }
  result.stiffness = matrix(size, stiffness, row_sums);
  result.mass = matrix(size, mass, 0.5 * result.lumped_mass);
  result.regular = size > 0 && row_sums.allFinite() && result.lumped_mass.minCoeff() > 0.0 && row_sums.minCoeff() > 0.0;
  return result;
}

Eigen::VectorXd asked_lengths(const FiniteElements& elements, const TriangleMesh& mesh, const SizingField* sizing) {
  Eigen::VectorXd h = Eigen::VectorXd::Ones(elements.size());
  if (sizing != nullptr && !sizing->uniform()) {
    tbb::parallel_for(Eigen::Index{0}, h.size(), [&](Eigen::Index i) {
      h[i] = sizing->h(mesh.vertices[elements.vertex[static_cast<std::size_t>(i)]]);
    });
  }
  return std::sqrt(elements.area / (0.5 * std::numbers::sqrt3 * h.squaredNorm())) * h;
}

}  // namespace isobench
