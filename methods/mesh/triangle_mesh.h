// A triangle mesh as plain arrays, with data per vertex and per triangle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace isobench {

using Triangle = std::array<std::uint32_t, 3>;

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                     ///< mm
  std::vector<Triangle> triangles;                           ///< counter-clockwise seen from outside the object
  std::map<std::string, std::vector<double>> vertex_data;    ///< one value a vertex
  std::map<std::string, std::vector<double>> triangle_data;  ///< one value a triangle
};

struct Lattice;
/// The mesh of a lattice frame placed in the world (mirrored frames keep their outside outside), and back.
TriangleMesh to_world(TriangleMesh mesh, const Lattice& lattice);
TriangleMesh to_local(TriangleMesh mesh, const Lattice& lattice);

/// For each vertex the least of those that it is connected to over triangles: one that stands for its component.
std::vector<std::uint32_t> component_roots(const TriangleMesh& mesh);

/// Takes out the vertices that no triangle uses, their data too; the others keep their order. Returns how many.
std::size_t drop_unused_vertices(TriangleMesh& mesh);

}  // namespace isobench
