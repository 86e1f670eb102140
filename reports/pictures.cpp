#include "reports/pictures.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>

#include "datasets/error.h"
#include "datasets/sha256.h"
#include "methods/mesh_files.h"
#include "metrics/radius_ratio.h"
#include "reports/markdown.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

constexpr int width = 640;
constexpr int height = 520;
constexpr std::size_t most_meshes = 24;  // of a dataset: beyond that nobody looks
constexpr double visible_edge = 5.0;     // pixels: shorter ones would hide the colours
const Eigen::Vector3d from_a_corner(0.6, -0.7, 0.4);

double mean_edge(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm();
  }
  return sum / static_cast<double>(3 * mesh.triangles.size());
}

Eigen::Vector3d scaled_normal(const TriangleMesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

Scene scene_of(const TriangleMesh& mesh, const View& view) {
  Scene scene;
  scene.mesh = &mesh;
  scene.values = radius_ratios(mesh);
  scene.legend = "radius ratio";
  scene.edges = mean_edge(mesh) * height / (2.0 * view.half_height) >= visible_edge;
  return scene;
}

// The meshes of one dataset that are drawn together.
struct Group {
  std::string dataset;
  std::vector<const RunRecord*> runs;
  std::vector<std::string> names;
  std::string key;  // of all that the shared cameras depend on
};

Group group_of(const Arrangement& runs, const std::string& dataset) {
  Group group{dataset, {}, {}, fmt::format("{} {} {}", render_revision, width, height)};
  for (const Variant& variant : runs.variants) {
    const RunRecord* run = find_run(variant, dataset);
    if (run == nullptr || run->status != Status::ok || group.runs.size() == most_meshes) continue;
    group.runs.push_back(run);
    group.names.push_back(variant.name);
    group.key += " " + run->mesh_checksum;
  }
  return group;
}

std::string file_name(const Group& group, const RunRecord& run, const std::string& kind, const char* ending = "png") {
  const std::string hash = sha256_of_text(group.key + " " + run.mesh_checksum + " " + kind).substr(0, 8);
  return fmt::format("pictures/{}-{}-{}.{}", run.request.run, kind, hash, ending);
}

std::size_t worst_triangle(const std::vector<double>& ratios) {
  return static_cast<std::size_t>(std::min_element(ratios.begin(), ratios.end()) - ratios.begin());
}

struct Kind {
  const char* name;
  const char* group;
};
constexpr Kind kinds[] = {
    {"whole", "the whole mesh"}, {"closer", "the same place of each, closer"}, {"worst", "the worst triangle of each"}};

// Reads the meshes of a group and draws all their pictures.
void draw_group(const Group& group, const fs::path& folder, Renderer& renderer) {
  std::vector<TriangleMesh> meshes;
  std::vector<const TriangleMesh*> pointers;
  std::vector<double> lengths;
  for (const RunRecord* run : group.runs) meshes.push_back(read_mesh(folder / run->request.run / "mesh.vtp"));
  for (const TriangleMesh& mesh : meshes) {
    pointers.push_back(&mesh);
    lengths.push_back(mean_edge(mesh));
  }
  const View whole = view_of_all(pointers);
  const View closer = closer_view(whole, meshes.front(), spread_of(lengths).median);
  for (std::size_t n = 0; n < meshes.size(); ++n) {
    const auto write = [&](const char* kind, const Scene& scene, const View& view) {
      const Drawing drawing = renderer.draw(scene, view);
      write_text(folder / file_name(group, *group.runs[n], kind, "jpg"), drawing.jpeg);
      write_text(folder / file_name(group, *group.runs[n], kind), drawing.png);
    };
    Scene scene = scene_of(meshes[n], whole);
    write("whole", scene, whole);
    scene.edges = true;
    write("closer", scene, closer);
    scene.outlined = worst_triangle(scene.values);
    write("worst", scene, view_of_triangle(meshes[n], *scene.outlined));
  }
}

bool all_there(const Group& group, const fs::path& folder) {
  for (const RunRecord* run : group.runs) {
    for (const Kind& kind : kinds) {
      for (const char* ending : {"png", "jpg"}) {
        if (!fs::exists(folder / file_name(group, *run, kind.name, ending))) return false;
      }
    }
  }
  return true;
}

void list_group(const Group& group, const fs::path& folder, Pictures& pictures) {
  for (const Kind& kind : kinds) {
    for (std::size_t n = 0; n < group.runs.size(); ++n) {
      const std::string file = file_name(group, *group.runs[n], kind.name);
      if (!fs::exists(folder / file) || !fs::exists(folder / file_name(group, *group.runs[n], kind.name, "jpg")))
        continue;
      const Measurement& m = *group.runs[n]->measurement;
      std::string caption = fmt::format("{} triangles", m.triangles);
      if (std::string(kind.name) == "worst") caption = "radius ratio " + significant(m.radius_ratio.min, 3);
      pictures.pictures.push_back({file, file_name(group, *group.runs[n], kind.name, "jpg"),
                                   group.dataset + ": " + kind.group, group.names[n], caption});
    }
  }
}

void remove_others(const fs::path& folder, const Pictures& pictures) {
  std::set<std::string> names;
  for (const Picture& picture : pictures.pictures) {
    names.insert(fs::path(picture.file).filename().string());
    names.insert(fs::path(picture.preview).filename().string());
  }
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "pictures")) {
    if (!names.contains(entry.path().filename().string())) others.push_back(entry.path());
  }
  for (const fs::path& other : others) fs::remove_all(other);
}

}  // namespace

View view_of_all(const std::vector<const TriangleMesh*>& meshes) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh* mesh : meshes) {
    for (const Eigen::Vector3d& vertex : mesh->vertices) box.extend(vertex);
  }
  View view;
  view.focus = box.center();
  view.towards = from_a_corner;
  // The box's corners, seen from there, decide how much is shown; the bar takes a part of the width.
  const Eigen::Vector3d direction = from_a_corner.normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(direction).normalized();
  const Eigen::Vector3d up = direction.cross(right);
  double across = 0.0;
  double along = 0.0;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)) - view.focus;
    across = std::max(across, std::abs(corner.dot(right)));
    along = std::max(along, std::abs(corner.dot(up)));
  }
  view.half_height = 1.05 * std::max(along, across * height / (0.83 * width));
  view.eye_distance = 2.0 * box.diagonal().norm();
  return view;
}

View closer_view(const View& whole, const TriangleMesh& mesh, double edge_length) {
  const Eigen::Vector3d direction = whole.towards.normalized();
  View view = whole;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const double depth = (vertex - whole.focus).dot(direction);
    if (depth <= nearest) continue;
    nearest = depth;
    view.focus = vertex;
  }
  view.half_height = std::min(whole.half_height, 12.0 * edge_length);
  return view;
}

View view_of_triangle(const TriangleMesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  View view;
  double longest = 0.0;
  view.focus = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm());
  }
  // A triangle without area has no normal of its own: its neighbours' is as good.
  view.towards = Eigen::Vector3d::Zero();
  for (const Triangle& other : mesh.triangles) {
    const bool touches =
        std::any_of(other.begin(), other.end(), [&t](std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; });
    if (touches) view.towards += scaled_normal(mesh, other);
  }
  if (view.towards.norm() == 0.0) view.towards = from_a_corner;
  view.half_height = 2.0 * std::max(longest, 1e-9);
  view.eye_distance = 0.5 * view.half_height;  // what folds over it stays behind the eye
  return view;
}

Pictures draw_pictures(const Arrangement& runs, const fs::path& folder) {
  Pictures pictures;
  fs::create_directories(folder / "pictures");
  std::unique_ptr<Renderer> renderer;
  for (const std::string& dataset : runs.datasets) {
    const Group group = group_of(runs, dataset);
    if (group.runs.size() == most_meshes) {
      pictures.missing.push_back(fmt::format("Of {} only the first {} methods have pictures.", dataset, most_meshes));
    }
    try {
      if (!group.runs.empty() && !all_there(group, folder)) {
        if (!renderer) renderer = std::make_unique<Renderer>(width, height);
        draw_group(group, folder, *renderer);
      }
    } catch (const Error& error) {
      const std::string sentence = fmt::format("Of {} there are not all pictures: {}.", dataset, error.what());
      pictures.missing.push_back(sentence);
    }
    list_group(group, folder, pictures);
  }
  remove_others(folder, pictures);
  return pictures;
}

}  // namespace isobench
