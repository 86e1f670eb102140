#include "isobench/methods/mesh_files/mesh_notes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "isobench/foundation/text.h"
#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench {

namespace {

std::vector<char> used(const TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = 1;
  }
  return used;
}

template <typename Number>
std::size_t distinct_places(const TriangleMesh& mesh, const std::vector<char>& counted) {
  std::vector<std::array<Number, 3>> places;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Eigen::Vector3d& x = mesh.vertices[v];
    if (counted[v] != 0)
      places.push_back({static_cast<Number>(x.x()), static_cast<Number>(x.y()), static_cast<Number>(x.z())});
  }
  std::sort(places.begin(), places.end());
  return static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
}

/// Whether two corners of a triangle are at the same place in this precision.
template <typename Number>
bool collapses(const TriangleMesh& mesh, const Triangle& t) {
  const auto corner = [&](std::size_t c) { return mesh.vertices[t[c]].cast<Number>().eval(); };
  return corner(0) == corner(1) || corner(1) == corner(2) || corner(2) == corner(0);
}

/// The largest move of a vertex to single precision, by the mean edge.
double largest_move(const TriangleMesh& mesh) {
  double move = 0.0, edges = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d& x = mesh.vertices[t[c]];
      move = std::max(move, (x.cast<float>().cast<double>() - x).norm());
      edges += (mesh.vertices[t[(c + 1) % 3]] - x).norm();
    }
  }
  const double mean = edges / (3.0 * static_cast<double>(mesh.triangles.size()));
  return mean > 0.0 ? move / mean : 0.0;
}

std::string sharing_note(const TriangleMesh& mesh, const MeshFacts& facts) {
  const auto edges = static_cast<long>(mesh.vertices.size() + mesh.triangles.size()) - facts.euler;
  // Each side is an edge of its own. A single triangle is no soup.
  if (mesh.triangles.size() < 2 || edges != 3 * static_cast<long>(mesh.triangles.size())) return "";
  const std::vector<char> in_use = used(mesh);
  const auto vertices = static_cast<std::size_t>(std::count(in_use.begin(), in_use.end(), 1));
  const std::size_t places = distinct_places<double>(mesh, in_use);
  return fmt::format(
      "no two of its {} triangles share an edge: its {} vertices are at {} different places; merge those "
      "that belong together (in MeshLab: Merge Close Vertices), or topology and volume mean nothing",
      mesh.triangles.size(), vertices, places);
}

}  // namespace

std::vector<std::string> notes_on(const TriangleMesh& mesh) {
  std::vector<std::string> notes;
  if (mesh.triangles.empty()) return notes;
  const MeshFacts facts = mesh_facts(mesh);
  if (facts.open_edges == 0 && facts.volume < 0.0) {
    notes.push_back(
        fmt::format("the mesh is inside out: it is closed, and its triangles are clockwise seen from outside "
                    "(volume {:.6g} mm³); turn its triangles",
                    facts.volume));
  }
  if (std::string note = sharing_note(mesh, facts); !note.empty()) notes.push_back(std::move(note));
  const auto twice = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                   [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  if (twice > 0) notes.push_back(fmt::format("{} of its triangles name a vertex twice and have no area", twice));
  const std::vector<char> in_use = used(mesh);
  const auto unused = std::count(in_use.begin(), in_use.end(), 0);
  if (unused > 0) notes.push_back(fmt::format("{} of its vertices have no triangle", unused));
  return notes;
}

std::string loss_in_file(const TriangleMesh& mesh, const std::filesystem::path& path) {
  if (lower_case(path.extension().string()) != ".stl" || mesh.triangles.empty()) return "";
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const auto& x) { return x.allFinite(); })) return "";
  constexpr const char* remedy = "write .ply, .vtp or .off, which keep every vertex in double precision";
  const std::vector<char> in_use = used(mesh);
  const auto vertices = static_cast<std::size_t>(std::count(in_use.begin(), in_use.end(), 1));
  const std::size_t survive = distinct_places<float>(mesh, in_use);
  const auto collapsed = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return !collapses<double>(mesh, t) && collapses<float>(mesh, t);
  });
  if (survive < distinct_places<double>(mesh, in_use) || collapsed > 0) {
    return fmt::format(
        "{}: STL holds single precision, in which {} of the {} vertices survive and {} of the {} triangles "
        "collapse; {}",
        path.string(), survive, vertices, collapsed, mesh.triangles.size(), remedy);
  }
  if (survive < vertices) {
    return fmt::format(
        "{}: STL has no vertex numbers, so vertices at the same place become one, and {} of the {} survive; {}",
        path.string(), survive, vertices, remedy);
  }
  const double move = largest_move(mesh);
  if (!(move > 0.01)) return "";
  return fmt::format(
      "{}: STL holds single precision, which moves vertices by up to {:.2g} of the mean edge; all {} "
      "vertices survive, but {}",
      path.string(), move, vertices, remedy);
}

}  // namespace isobench
