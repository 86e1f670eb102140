#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/external/exchange.h"
#include "isobench/methods/external/points_file.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench::external {

namespace {

using Points = std::vector<Eigen::Vector3d>;

enum class Frame { lattice, world, index };

Frame frame_of_output(const Parameters& parameters) {
  const std::string& output = parameters.text("output_frame");
  const std::string& name = output == "same" ? parameters.text("frame") : output;
  return name == "world" ? Frame::world : name == "index" ? Frame::index : Frame::lattice;
}

void bring_home(TriangleMesh& mesh, Frame frame, const Lattice& lattice) {
  if (frame == Frame::world) mesh = to_local(std::move(mesh), lattice);
  if (frame == Frame::index) {
    for (Eigen::Vector3d& x : mesh.vertices) x = x.cwiseProduct(lattice.spacing);
  }
}

// Projects each point to F = c; a point whose projection fails stays where it is.
void project(Points& points, const Isosurface& surface, Monitor& monitor) {
  std::vector<double> moved(points.size(), -1.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size()), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto foot = surface.project(points[n]);
      if (!foot) continue;
      moved[n] = (*foot - points[n]).norm();
      points[n] = *foot;
    }
  });
  const auto lost = static_cast<std::size_t>(std::count(moved.begin(), moved.end(), -1.0));
  double sum = 0.0, most = 0.0;
  for (const double distance : moved) {
    sum += std::max(distance, 0.0);
    most = std::max(most, distance);
  }
  const auto projected = static_cast<double>(std::max<std::size_t>(points.size() - lost, 1));
  monitor.set("external/projected mean mm", sum / projected);
  monitor.set("external/projected max mm", most);
  monitor.set("external/not projected", static_cast<double>(lost));
  monitor.note(fmt::format("external: vertices were projected to F = c, by {:.2g} mm on average and {:.2g} mm at most",
                           sum / projected, most));
}

// Drops every point that has the coordinates of an earlier one.
void drop_repeated(Points& points, Monitor& monitor) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  const auto place = [&points](std::size_t n) {
    return std::array{points[n].x(), points[n].y(), points[n].z(), double(n)};
  };
  std::sort(order.begin(), order.end(), [&place](std::size_t a, std::size_t b) { return place(a) < place(b); });
  std::vector<char> repeated(points.size(), 0);
  for (std::size_t n = 1; n < order.size(); ++n) repeated[order[n]] = points[order[n]] == points[order[n - 1]] ? 1 : 0;
  std::size_t kept = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (repeated[n] == 0) points[kept++] = points[n];
  }
  monitor.set("external/repeated points", static_cast<double>(points.size() - kept));
  points.resize(kept);
}

TriangleMesh closed(Points points, const Isosurface& surface, Monitor& monitor) {
  const auto stage = monitor.stage("close");
  drop_repeated(points, monitor);
  TriangleMesh mesh;
  mesh.triangles = LabelledDelaunay(points, surface, monitor).triangles();
  mesh.vertices = std::move(points);
  const std::size_t dropped = drop_unused_vertices(mesh);
  monitor.set("external/points without triangle", static_cast<double>(dropped));
  monitor.note("external: its points were closed by the labelled Delaunay triangulation");
  if (mesh.triangles.empty()) throw Error("the program's points enclose nothing: none of their cells is inside F = c");
  return mesh;
}

// Programs differ in the orientation of triangles and in which side they call inside. So turn each component if the
// larger part of its area faces inwards.
void face_outwards(TriangleMesh& mesh, const Isosurface& surface, Monitor& monitor) {
  const std::vector<std::uint32_t> roots = component_roots(mesh);
  std::map<std::uint32_t, double> outward;  // area that faces outwards less area that faces inwards, by component
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Eigen::Vector3d gradient = surface.value_gradient((a + b + c) / 3.0).gradient;
    const double length = gradient.norm();
    if (length > 0.0) outward[roots[t[0]]] -= (b - a).cross(c - a).dot(gradient) / length;
  }
  std::size_t turned = 0;
  for (Triangle& t : mesh.triangles) {
    if (outward[roots[t[0]]] < 0.0) std::swap(t[1], t[2]);
  }
  for (const auto& [root, sum] : outward) turned += sum < 0.0 ? 1U : 0U;
  monitor.set("external/components turned", static_cast<double>(turned));
  if (turned > 0) monitor.note(fmt::format("external: {} components faced inwards and were turned", turned));
}

}  // namespace

TriangleMesh take_back(const MeshingTask& task, const std::filesystem::path& path, Monitor& monitor) {
  const bool points = returns_points(task.parameters);
  TriangleMesh mesh;
  {
    const auto stage = monitor.stage("read");
    if (points)
      mesh.vertices = read_points(path);
    else
      mesh = read_mesh(path, monitor);
    bring_home(mesh, frame_of_output(task.parameters), task.surface.lattice());
    if (task.parameters.flag("project")) project(mesh.vertices, task.surface, monitor);
  }
  monitor.set("external/vertices read", static_cast<double>(mesh.vertices.size()));
  if (points) return closed(std::move(mesh.vertices), task.surface, monitor);
  const std::size_t unused = drop_unused_vertices(mesh);
  monitor.set("external/vertices without triangle", static_cast<double>(unused));
  face_outwards(mesh, task.surface, monitor);
  return mesh;
}

}  // namespace isobench::external
