#include "isobench/methods/mesh_files/polygon_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "isobench/methods/mesh_files/polygon_cutter.h"

namespace isobench {

namespace {

/// Cuts polygon after polygon and counts what a note should say.
class Triangulation {
 public:
  explicit Triangulation(PolygonMesh& polygons) : polygons_(polygons) {}

  TriangleMesh run() {
    mesh_.triangles.reserve(polygons_.size());
    for (std::size_t n = 0; n < polygons_.size(); ++n) {
      const std::size_t before = mesh_.triangles.size();
      add(polygons_.polygon(n));
      for (auto& [name, values] : polygons_.polygon_data) {
        std::vector<double>& of_triangles = mesh_.triangle_data[name];
        of_triangles.insert(of_triangles.end(), mesh_.triangles.size() - before, values[n]);
      }
    }
    mesh_.vertices = std::move(polygons_.vertices);
    mesh_.vertex_data = std::move(polygons_.vertex_data);
    return std::move(mesh_);
  }

  void add_notes(std::vector<std::string>& notes) const {
    if (cut_ > 0) {
      notes.push_back(
          fmt::format("{} of its {} faces have more than three corners (up to {}); they were cut into {} "
                      "triangles",
                      cut_, polygons_.size(), most_, triangles_));
    }
    if (crossed_ > 0) {
      notes.push_back(
          fmt::format("{} of its faces with more than three corners cross themselves or have no area; "
                      "their triangles may overlap",
                      crossed_));
    }
    if (dropped_ > 0) notes.push_back(fmt::format("{} of its faces have fewer than three corners; left out", dropped_));
  }

 private:
  void add(std::span<const std::uint32_t> polygon) {
    if (polygon.size() == 3) {
      mesh_.triangles.push_back({polygon[0], polygon[1], polygon[2]});
      return;
    }
    corners_.clear();
    for (const std::uint32_t v : polygon) {
      if (corners_.empty() || v != corners_.back()) corners_.push_back(v);
    }
    while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
    if (corners_.size() < 3) {
      ++dropped_;
      return;
    }
    if (corners_.size() == 3) {
      mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
      return;
    }
    points_.clear();
    for (const std::uint32_t v : corners_) points_.push_back(polygons_.vertices[v]);
    crossed_ += cutter_.cut(points_) ? 0 : 1;
    ++cut_;
    most_ = std::max(most_, polygon.size());
    triangles_ += cutter_.triangles().size();
    for (const Triangle& t : cutter_.triangles()) {
      mesh_.triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
    }
  }

  PolygonMesh& polygons_;
  TriangleMesh mesh_;
  PolygonCutter cutter_;
  std::vector<std::uint32_t> corners_;
  std::vector<Eigen::Vector3d> points_;
  std::size_t cut_ = 0, crossed_ = 0, dropped_ = 0, triangles_ = 0;
  std::size_t most_ = 0;  // corners
};

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::size_t PolygonMesh::add_strip(std::span<const std::uint32_t> strip) {
  const std::size_t before = size();
  for (std::size_t n = 2; n < strip.size(); ++n) {
    const std::uint32_t a = strip[n - 2], b = strip[n - 1], c = strip[n];
    if (a == b || b == c || c == a) continue;
    add_polygon(n % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
  }
  return size() - before;
}

void PolygonMesh::note_left_out(std::size_t points, std::size_t lines) {
  if (points + lines == 0) return;
  std::string what;
  if (points > 0) what = counted(points, "point");
  if (lines > 0) what += (what.empty() ? "" : " and ") + counted(lines, "line");
  notes.push_back(fmt::format("its {} {} no part of a surface; left out", what, points + lines == 1 ? "is" : "are"));
}

TriangleMesh to_triangles(PolygonMesh polygons, std::vector<std::string>& notes) {
  Triangulation triangulation(polygons);
  TriangleMesh mesh = triangulation.run();
  notes = std::move(polygons.notes);
  triangulation.add_notes(notes);
  return mesh;
}

}  // namespace isobench
