#include "isobench/reports/pictures/drawing.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/sizing/medial_axis/point_tree.h"
#include "isobench/metrics/radius_ratio/radius_ratio.h"
#include "isobench/reports/pictures/cameras.h"
#include "isobench/reports/pictures/field_pictures.h"
#include "isobench/reports/pictures/field_scene.h"
#include "isobench/reports/pictures/pictures.h"
#include "isobench/reports/pictures/turnable.h"
#include "isobench/reports/runs/spread.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

constexpr int picture_width = 640;
constexpr int picture_height = 520;
constexpr double visible_edge = 5.0;  // pixels; shorter edges would hide the colours
constexpr std::size_t triangles_around = 3000;

// Normals at the vertices, not of unit length.
std::vector<Eigen::Vector3d> normals_of(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d normal =
        (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    for (const std::uint32_t v : t) normals[v] += normal;
  }
  return normals;
}

// The points of the medial axis inside the mesh, coloured by their distance to the surface.
Scene axis_scene(const Artefact& axis, const TriangleMesh& mesh) {
  const PointTree tree(mesh.vertices);
  const std::vector<Eigen::Vector3d> normals = normals_of(mesh);
  Scene scene;
  for (std::size_t n = 0; n < axis.points.size(); ++n) {
    const std::size_t near = tree.nearest(axis.points[n]).first;
    if ((axis.points[n] - mesh.vertices[near]).dot(normals[near]) > 0.0) continue;
    scene.points.push_back(axis.points[n]);
    scene.point_values.push_back(axis.data.at("radius")[n]);
  }
  scene.legend = "distance, mm";
  scene.point_size = 3.0;
  return scene;
}

// The values of a field at the vertices, taken from the nearest lattice node.
std::vector<double> at_vertices(const Artefact& sizing, const std::string& field, const TriangleMesh& mesh) {
  const PointTree tree(sizing.points);
  const std::vector<double>& values = sizing.data.at(field);
  std::vector<double> result;
  for (const Eigen::Vector3d& vertex : mesh.vertices) result.push_back(values[tree.nearest(vertex).first]);
  return result;
}

// The colours cover the middle 96 % of the values. Otherwise a few outliers could leave one colour for all other
// values.
void fit_range(const std::vector<double>& values, Scene& scene) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  scene.low = sorted[sorted.size() / 50];
  scene.high = sorted[sorted.size() - 1 - sorted.size() / 50];
  if (scene.high <= scene.low) scene.high = scene.low + 1e-9;
}

std::string edge_counts(const TriangleMesh& mesh, const std::vector<double>& h) {
  std::vector<std::size_t> counts(200, 0);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      if (a > b) continue;  // in a closed mesh this counts each edge once
      const double ratio = (mesh.vertices[a] - mesh.vertices[b]).norm() / (0.5 * (h[a] + h[b]));
      ++counts[static_cast<std::size_t>(std::clamp(100.0 * ratio, 0.0, 199.0))];
    }
  }
  return fmt::format("{}\n", fmt::join(counts, " "));
}

// Draws the files of one group. All meshes of a group have the same views.
class Painter {
 public:
  Painter(const PictureGroup& group, const fs::path& folder, std::unique_ptr<Renderer>& renderer)
      : group_(group), folder_(folder), renderer_(renderer) {
    for (const RunRecord* run : group.runs) meshes_.push_back({read_mesh(folder / run->request.run / "mesh.vtp"), {}});
    std::vector<const TriangleMesh*> pointers;
    std::vector<double> lengths;
    for (ValuedMesh& valued : meshes_) {
      valued.values = radius_ratios(valued.mesh);
      pointers.push_back(&valued.mesh);
      lengths.push_back(mean_edge(valued.mesh));
    }
    whole_ = view_of_all(pointers);
    mean_edge_ = spread_of(lengths).median;
    closer_ = closer_view(whole_, meshes_.front().mesh, mean_edge_);
  }

  void paint() {
    if (!group_.grid) {
      for (std::size_t n = 0; n < meshes_.size(); ++n) write_turnable(n);
    }
    if (!renderer_) renderer_ = std::make_unique<Renderer>(picture_width, picture_height);
    for (std::size_t n = 0; n < meshes_.size(); ++n) {
      paint_mesh(n);
      paint_artefacts(n);
    }
    for (const FieldPictures& of : field_pictures(group_, folder_)) paint_field(of);
  }

 private:
  void write_turnable(std::size_t n) const {
    const ValuedMesh& mesh = meshes_[n];
    const RunRecord& run = *group_.runs[n];
    const std::size_t worst = worst_of(mesh);
    write_text(folder_ / group_.file(run, PictureGroup::turn, "mesh"),
               turnable(simplified(mesh, group_.turnable_triangles)));
    if (mesh.mesh.triangles.size() > group_.turnable_triangles) {
      write_text(folder_ / group_.file(run, PictureGroup::turn_worst, "mesh"),
                 turnable(around(mesh, worst, triangles_around)));
    }
  }

  static std::size_t worst_of(const ValuedMesh& mesh) {
    return static_cast<std::size_t>(std::min_element(mesh.values.begin(), mesh.values.end()) - mesh.values.begin());
  }

  void write(std::size_t n, const char* shot, const Scene& scene, const View& view) {
    const Drawing drawing = renderer_->draw(scene, view);
    write_text(folder_ / group_.file(*group_.runs[n], shot, "jpg"), drawing.jpeg);
    write_text(folder_ / group_.file(*group_.runs[n], shot), drawing.png);
  }

  void paint_mesh(std::size_t n) {
    Scene scene;
    scene.mesh = &meshes_[n].mesh;
    scene.values = meshes_[n].values;
    scene.legend = "radius ratio";
    scene.edges = mean_edge(*scene.mesh) * picture_height / (2.0 * whole_.half_height) >= visible_edge;
    write(n, shots::whole, scene, whole_);
    if (group_.grid) return;
    scene.edges = true;
    write(n, shots::closer, scene, closer_);
    scene.outlined = worst_of(meshes_[n]);
    write(n, shots::worst, scene, view_of_triangle(*scene.mesh, *scene.outlined));
  }

  void paint_artefacts(std::size_t n) {
    const std::vector<std::string> shots = shots_of(group_, *group_.runs[n], folder_);
    const auto wanted = [&shots](const char* shot) {
      return std::find(shots.begin(), shots.end(), shot) != shots.end();
    };
    if (wanted(shots::medial_axis)) {
      Scene scene = axis_scene(artefact(n, "medial-axis.vtp"), meshes_[n].mesh);
      if (!scene.points.empty()) fit_range(scene.point_values, scene);
      write(n, shots::medial_axis, scene, whole_);
    }
    if (wanted(shots::initial_sizing)) paint_sizing(n);
    if (wanted(shots::particles)) paint_particles(n);
  }

  void paint_field(const FieldPictures& of) {
    double brightest = 0.0;
    for (const std::size_t n : of.runs) brightest = std::max(brightest, high_value(*of.field, meshes_[n].mesh));
    for (const std::size_t n : of.runs) {
      Scene scene = field_scene(*of.field, meshes_[n].mesh, *group_.runs[n], brightest);
      View view = whole_;
      if (of.field->view == FieldView::mark && scene.marked) {
        view = view_of_place(meshes_[n].mesh, *scene.marked, mean_edge_);
        scene.marked.reset();  // it is the middle of the picture
      }
      write(n, of.shot.c_str(), scene, view);
    }
  }

  Artefact artefact(std::size_t n, const char* name) const {
    return read_artefact(folder_ / group_.runs[n]->request.run / name);
  }

  void paint_sizing(std::size_t n) {
    const Artefact sizing = artefact(n, "sizing.vtp");
    const std::vector<double> h = at_vertices(sizing, "h", meshes_[n].mesh);
    Scene scene;
    scene.mesh = &meshes_[n].mesh;
    scene.edges = false;
    scene.legend = "sizing, mm";
    scene.vertex_values = at_vertices(sizing, "h0", meshes_[n].mesh);
    fit_range(scene.vertex_values, scene);
    write(n, shots::initial_sizing, scene, whole_);
    scene.vertex_values = h;
    write(n, shots::limited_sizing, scene, whole_);
    write_text(folder_ / group_.file(*group_.runs[n], PictureGroup::over_h, "txt"), edge_counts(*scene.mesh, h));
  }

  void paint_particles(std::size_t n) {
    Artefact particles = artefact(n, "particles.vtp");
    Scene scene;
    scene.mesh = &meshes_[n].mesh;
    scene.edges = false;
    scene.points = std::move(particles.points);
    const double spacing = mean_edge(*scene.mesh) * picture_height / (2.0 * whole_.half_height);
    scene.point_size = std::clamp(0.5 * spacing, 1.5, 8.0);
    write(n, shots::particles, scene, whole_);
    scene.point_size = 9.0;
    write(n, shots::particles_closer, scene, closer_);
  }

  const PictureGroup& group_;
  const fs::path& folder_;
  std::unique_ptr<Renderer>& renderer_;
  std::vector<ValuedMesh> meshes_;
  double mean_edge_ = 0.0;  // the median of the meshes
  View whole_;
  View closer_;
};

bool all_there(const PictureGroup& group, const fs::path& folder) {
  for (const RunRecord* run : group.runs) {
    for (const std::string& file : files_of(group, *run, folder)) {
      if (!fs::exists(folder / file)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::string> draw_pictures(const Results& results, const fs::path& folder) {
  std::vector<std::string> sentences;
  std::vector<std::string> left_out;
  std::unique_ptr<Renderer> renderer;
  for (const PictureGroup& group : picture_groups(results, left_out)) {
    if (all_there(group, folder)) continue;
    try {
      Painter(group, folder, renderer).paint();
    } catch (const Error& error) {
      sentences.push_back(fmt::format("Some pictures of {} are missing: {}.", group.title, error.what()));
    }
  }
  return sentences;
}

}  // namespace isobench
