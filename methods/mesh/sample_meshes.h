// Meshes with known properties, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

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

/// Both meshes in one; vertices are not merged.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

/// A torus round the z axis with radii 2 and 1: n × 2n quads, each divided into two triangles.
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

/// The unit sphere: an icosahedron whose triangles are divided into four, `quartered` times, with vertices moved to the
/// sphere.
inline TriangleMesh icosphere(int quartered) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleMesh result = mesh({{-1, g, 0},
                              {1, g, 0},
                              {-1, -g, 0},
                              {1, -g, 0},
                              {0, -1, g},
                              {0, 1, g},
                              {0, -1, -g},
                              {0, 1, -g},
                              {g, 0, -1},
                              {g, 0, 1},
                              {-g, 0, -1},
                              {-g, 0, 1}},
                             {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
  for (int round = 0; round < quartered; ++round) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(result.vertices.size());
      const auto [place, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, next);
      if (is_new) result.vertices.emplace_back(0.5 * (result.vertices[a] + result.vertices[b]));
      return place->second;
    };
    std::vector<Triangle> quarters;
    for (const auto& [a, b, c] : result.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      quarters.insert(quarters.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    result.triangles = quarters;
    for (Eigen::Vector3d& v : result.vertices) v.normalize();
  }
  for (Eigen::Vector3d& v : result.vertices) v.normalize();
  return result;
}

}  // namespace isobench::sample_meshes
