// A triangle mesh in plain arrays, with data per vertex and per triangle.
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
  std::map<std::string, std::vector<double>> vertex_data;    ///< one value per vertex
  std::map<std::string, std::vector<double>> triangle_data;  ///< one value per triangle
  std::string space = {};  ///< the axes of the coordinates, "LPS" or "RAS", as in Lattice; "" if they are not known
};

struct Lattice;
/// Moves a mesh from the lattice's frame to the world, and back. Triangles stay counter-clockwise seen from outside,
/// also if the frame is mirrored.
TriangleMesh to_world(TriangleMesh mesh, const Lattice& lattice);
TriangleMesh to_local(TriangleMesh mesh, const Lattice& lattice);

/// For each vertex, the smallest index in its component, which is all vertices that triangles connect it to.
std::vector<std::uint32_t> component_roots(const TriangleMesh& mesh);

/// Removes the vertices that no triangle uses, with their data, and returns their number. The others keep their order.
std::size_t drop_unused_vertices(TriangleMesh& mesh);

}  // namespace isobench
