// Signs of cotangent weights, by hand and against the stiffness matrix.
#include "isobench/metrics/cotangent_weights/cotangent_weights.h"

#include <gtest/gtest.h>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/finite_elements/finite_elements.h"
#include "isobench/metrics/measurement.h"

namespace isobench {
namespace {

CotangentWeights weights_of(const TriangleMesh& mesh) {
  return measure_cotangent_weights(mesh, sorted_half_edges(mesh));
}

/// Two triangles on both sides of an edge of length 2; `a` and `b` are the heights above and below it.
TriangleMesh kite(double a, double b) {
  return sample_meshes::mesh({{-1, 0, 0}, {1, 0, 0}, {0, a, 0}, {0, -b, 0}, {9, 9, 9}}, {{0, 1, 2}, {1, 0, 3}});
}

TEST(CotangentWeights, OfAKite) {
  // Half the angle at the apex has the tangent 1/a, so its cotangent is (a² − 1)/(2a): 0.75 for 2, −0.75 for 1/2.
  const CotangentWeights square = weights_of(kite(1.0, 1.0));
  EXPECT_EQ(square.negative, 0U) << "right angles";
  EXPECT_EQ(square.obtuse_percent, 0.0);
  const CotangentWeights mended = weights_of(kite(0.5, 2.1));
  EXPECT_EQ(mended.negative, 0U) << "the other triangle outweighs it";
  EXPECT_EQ(mended.obtuse_percent, 50.0);
  const CotangentWeights negative = weights_of(kite(0.5, 1.9));
  EXPECT_EQ(negative.negative, 1U);
  EXPECT_EQ(negative.negative_row_percent, 50.0) << "the vertex without a triangle does not count";
  EXPECT_EQ(weights_of(kite(0.1, 0.1)).obtuse_percent, 100.0);
}

TEST(CotangentWeights, ATriangleWithoutAreaCounts) {
  const CotangentWeights flat = weights_of(kite(0.0, 1.0));
  EXPECT_EQ(flat.negative, 1U);
  EXPECT_EQ(flat.obtuse_percent, 50.0);
  EXPECT_EQ(weights_of(kite(0.0, 0.0)).obtuse_percent, 100.0);
}

TEST(CotangentWeights, AreTheNegativeEntriesOfTheStiffness) {
  TriangleMesh mesh = sample_meshes::torus(12);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertices[v].x() *= 1.0 + 0.1 * static_cast<double>(v % 5);
  const FiniteElements e = finite_elements(mesh, sorted_half_edges(mesh));
  std::size_t negative = 0;
  for (Eigen::Index row = 0; row < e.size(); ++row) {
    for (SparseMatrix::InnerIterator it(e.stiffness, row); it; ++it) {
      if (it.col() > row && it.value() > 0.5e-9) ++negative;
    }
  }
  EXPECT_GT(negative, 10U);
  EXPECT_EQ(weights_of(mesh).negative, negative);
}

TEST(CotangentWeights, ACollapsedMeshHasNone) {
  TriangleMesh mesh = sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}});
  Monitor monitor;
  EXPECT_EQ(measure(mesh, MeasuredAgainst{}, monitor).figure("negative_weights"), std::nullopt);
}

}  // namespace
}  // namespace isobench
