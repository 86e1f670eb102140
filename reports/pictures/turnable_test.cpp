#include "isobench/reports/pictures/turnable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "isobench/methods/mesh/sample_meshes.h"

namespace isobench {
namespace {

ValuedMesh valued(TriangleMesh mesh) {
  std::vector<double> values(mesh.triangles.size(), 0.75);
  return {std::move(mesh), std::move(values)};
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Reads a file as the page's script does.
ValuedMesh read_back(const std::string& bytes) {
  const auto vertices = number_at<std::uint32_t>(bytes, 0);
  const auto triangles = number_at<std::uint32_t>(bytes, 4);
  const Eigen::Vector3d low(number_at<float>(bytes, 8), number_at<float>(bytes, 12), number_at<float>(bytes, 16));
  const auto side = static_cast<double>(number_at<float>(bytes, 20));
  ValuedMesh mesh;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] =
          low[axis] + side * number_at<std::uint16_t>(bytes, 24 + 6 * v + 2 * static_cast<std::size_t>(axis)) / 65535.0;
    mesh.mesh.vertices.push_back(place);
  }
  std::size_t at = 24 + std::size_t{6} * vertices;
  std::uint32_t unused = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    Triangle& triangle = mesh.mesh.triangles.emplace_back();
    for (std::uint32_t& corner : triangle) {
      std::uint32_t back = 0;
      for (unsigned shift = 0;; shift += 7) {
        const auto byte = static_cast<unsigned char>(bytes[at++]);
        back |= (byte & 127U) << shift;
        if (byte < 128) break;
      }
      corner = back == 0 ? unused++ : unused - back;
    }
  }
  for (; at < bytes.size(); ++at) mesh.values.push_back(static_cast<unsigned char>(bytes[at]) / 255.0);
  return mesh;
}

using Corners = std::vector<std::array<double, 9>>;

// The triangles as sorted coordinates, because a file may have them in another order.
Corners corners_of(const TriangleMesh& mesh, double step) {
  Corners all;
  for (const Triangle& t : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> places;
    for (std::size_t i = 0; i < 3; ++i) places[i] = (mesh.vertices[t[i]] / step).array().round();
    const auto less = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::rotate(places.begin(), std::min_element(places.begin(), places.end(), less), places.end());
    std::array<double, 9>& row = all.emplace_back();
    for (std::size_t i = 0; i < 9; ++i) row[i] = places[i / 3][static_cast<Eigen::Index>(i % 3)] + 0.0;
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Turnable, KeepsEveryTriangleWithinItsSteps) {
  // Corners with whole coordinates, so that rounding gives them back exactly.
  const ValuedMesh mesh = valued(
      sample_meshes::together(sample_meshes::box({-7, -3, 0}, {5, 4, 9}), sample_meshes::box({-2, 1, 1}, {1, 2, 3})));
  const ValuedMesh back = read_back(turnable(mesh));
  EXPECT_EQ(corners_of(back.mesh, 1.0), corners_of(mesh.mesh, 1.0));
  ASSERT_EQ(back.values.size(), mesh.values.size());
  EXPECT_NEAR(back.values[0], 0.75, 0.002);
}

TEST(Turnable, TakesAboutNineBytesATriangle) {
  const ValuedMesh mesh = valued(sample_meshes::torus(70));
  EXPECT_LT(turnable(mesh).size(), 9.5 * static_cast<double>(mesh.mesh.triangles.size()));
}

TEST(Turnable, CopiesHaveNoMoreTrianglesThanAskedForAndTheSameShape) {
  ValuedMesh mesh = valued(sample_meshes::torus(100));
  const std::size_t worst = 12345;
  mesh.values[worst] = 0.1;
  const ValuedMesh copy = simplified(mesh, 5000);
  EXPECT_LE(copy.mesh.triangles.size(), 5000U);
  EXPECT_GT(copy.mesh.triangles.size(), 3500U);
  ASSERT_EQ(copy.values.size(), copy.mesh.triangles.size());
  for (const Eigen::Vector3d& vertex : copy.mesh.vertices) {
    const double from_circle = std::hypot(std::hypot(vertex.x(), vertex.y()) - 2.0, vertex.z());
    EXPECT_NEAR(from_circle, 1.0, 0.02);
  }
  // The bad triangle is seen in the copy, at the same place.
  const std::size_t dark =
      static_cast<std::size_t>(std::min_element(copy.values.begin(), copy.values.end()) - copy.values.begin());
  EXPECT_DOUBLE_EQ(copy.values[dark], 0.1);
  const Eigen::Vector3d place = mesh.mesh.vertices[mesh.mesh.triangles[worst][0]];
  EXPECT_LT((copy.mesh.vertices[copy.mesh.triangles[dark][0]] - place).norm(), 0.4);
  EXPECT_EQ(simplified(mesh, 1000000).mesh.triangles.size(), mesh.mesh.triangles.size());
}

TEST(Turnable, OfAPlaceHasTheTrianglesAroundIt) {
  const ValuedMesh mesh = valued(sample_meshes::torus(30));
  const ValuedMesh part = around(mesh, 100, 13);
  ASSERT_EQ(part.mesh.triangles.size(), 13U);  // itself and the twelve that touch it
  const Triangle& middle = part.mesh.triangles.front();
  for (const Triangle& other : part.mesh.triangles) {
    EXPECT_TRUE(std::any_of(other.begin(), other.end(), [&middle](std::uint32_t v) {
      return std::find(middle.begin(), middle.end(), v) != middle.end();
    }));
  }
  EXPECT_EQ(around(mesh, 0, 1000000).mesh.triangles.size(), mesh.mesh.triangles.size());
}

}  // namespace
}  // namespace isobench
