// Meshes with known answers, for the tests of this folder.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "methods/triangle_mesh.h"

namespace isobench::sample_meshes {

inline TriangleMesh mesh(std::initializer_list<Eigen::Vector3d> vertices, std::initializer_list<Triangle> triangles) {
  TriangleMesh result;
  result.vertices = vertices;
  result.triangles = triangles;
  return result;
}

inline TriangleMesh tetrahedron() {
  return mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// A box from `low` to `high`, twelve triangles seen counter-clockwise from outside.
inline TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  TriangleMesh result;
  for (int n = 0; n < 8; ++n) {
    result.vertices.emplace_back((n & 1) != 0 ? high.x() : low.x(), (n & 2) != 0 ? high.y() : low.y(),
                                 (n & 4) != 0 ? high.z() : low.z());
  }
  result.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return result;
}

/// Both meshes as one, vertices not merged.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

/// A torus of n × 2n quads around the z axis, radii 2 and 1, cut in two triangles each.
inline TriangleMesh torus(std::uint32_t n) {
  TriangleMesh result;
  for (std::uint32_t i = 0; i < 2 * n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double u = M_PI * i / n;
      const double v = 2.0 * M_PI * j / n;
      const double r = 2.0 + std::cos(v);
      result.vertices.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const std::uint32_t next_i = (i + 1) % (2 * n);
      const std::uint32_t next_j = (j + 1) % n;
      result.triangles.push_back({i * n + j, next_i * n + j, next_i * n + next_j});
      result.triangles.push_back({i * n + j, next_i * n + next_j, i * n + next_j});
    }
  }
  return result;
}

/// A band of 2n triangles with a half twist.
inline TriangleMesh moebius_strip(std::uint32_t n) {
  TriangleMesh result;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2.0 * M_PI * i / n;
    for (const double side : {-0.5, 0.5}) {
      const double r = 2.0 + side * std::cos(u / 2.0);
      result.vertices.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(u / 2.0));
    }
    const bool twist = i + 1 == n;
    const std::uint32_t a = 2 * i;
    const std::uint32_t next_a = twist ? 1 : a + 2;
    const std::uint32_t next_b = twist ? 0 : a + 3;
    result.triangles.push_back({a, next_a, next_b});
    result.triangles.push_back({a, next_b, a + 1});
  }
  return result;
}

}  // namespace isobench::sample_meshes
