#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "isobench/datasets/formats/write_volume.h"
#include "isobench/methods/external/exchange.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_notes.h"

namespace isobench::external {

namespace {

namespace fs = std::filesystem;

double triangle_area(const TriangleMesh& mesh, const Triangle& t) {
  const Eigen::Vector3d& a = mesh.vertices[t[0]];
  return 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
}

// Computes what placeholders stand for, once and only when one of them needs it.
class Offer {
 public:
  Offer(const MeshingTask& task, Monitor& monitor) : task_(task), monitor_(monitor) {}

  const SizingField& sizing() {
    if (field_ == nullptr) field_ = task_.sizing_field(monitor_);
    return *field_;
  }

  const TriangleMesh& lattice_mesh() {
    if (mesh_ == nullptr) {
      const auto stage = monitor_.stage("marching cubes");
      mesh_ = std::make_unique<TriangleMesh>(marching_cubes(task_.surface, monitor_));
    }
    return *mesh_;
  }

  double area() {
    double sum = 0.0;
    for (const Triangle& t : lattice_mesh().triangles) sum += triangle_area(lattice_mesh(), t);
    return sum;
  }

  // The number of vertices of a mesh of nearly equilateral triangles with edges of length h; inverts edge_length_for().
  double vertices() {
    if (task_.sizing.vertices) return *task_.sizing.vertices;
    const TriangleMesh& mesh = lattice_mesh();
    double count = 0.0;
    for (const Triangle& t : mesh.triangles) {
      const double h = sizing().h((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0);
      count += 2.0 * triangle_area(mesh, t) / (std::sqrt(3.0) * h * h);
    }
    return count;
  }

  double edge_length() { return sizing().uniform() ? sizing().smallest() : edge_length_for(area(), vertices()); }

 private:
  const MeshingTask& task_;
  Monitor& monitor_;
  std::shared_ptr<const SizingField> field_;
  std::unique_ptr<TriangleMesh> mesh_;
};

bool in_world(const MeshingTask& task) { return task.parameters.text("frame") == "world"; }

// The lattice in the frame that the program gets.
Lattice lattice_for(const MeshingTask& task) {
  const Lattice& lattice = task.surface.lattice();
  if (in_world(task)) return lattice;
  Lattice local;
  local.size = lattice.size;
  local.spacing = lattice.spacing;
  return local;
}

void fill_slab(const MeshingTask& task, int k, std::vector<float>& slab) {
  const Isosurface& surface = task.surface;
  const std::string& values = task.parameters.text("values");
  if (values == "nodes") return surface.node_values(k, slab);
  if (values == "samples") return surface.sample_values(k, slab);
  const auto& size = surface.lattice().size;
  slab.clear();
  for (int j = 0; j < size[1]; ++j) {
    for (int i = 0; i < size[0]; ++i) slab.push_back(surface.coefficient(i, j, k));
  }
}

// In the units of the data: f is ±(F − c).
FloatVolume volume_for(const MeshingTask& task) {
  FloatVolume volume{lattice_for(task), {}};
  volume.samples.reserve(volume.lattice.nodes());
  const double sign = task.surface.inside() == Inside::above ? 1.0 : -1.0;
  std::vector<float> slab;
  for (int k = 0; k < volume.lattice.size[2]; ++k) {
    fill_slab(task, k, slab);
    for (const float f : slab) {
      volume.samples.push_back(static_cast<float>(task.surface.isovalue() + sign * static_cast<double>(f)));
    }
  }
  return volume;
}

FloatVolume sizing_for(const MeshingTask& task, const SizingField& sizing) {
  FloatVolume volume{lattice_for(task), {}};
  const Lattice& lattice = task.surface.lattice();
  volume.samples.reserve(lattice.nodes());
  for (int k = 0; k < lattice.size[2]; ++k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i) {
        volume.samples.push_back(static_cast<float>(sizing.h(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)))));
      }
    }
  }
  return volume;
}

// Writes the file and returns its name.
std::string write_file(const MeshingTask& task, const std::string& kind, Offer& offer, const fs::path& folder,
                       Monitor& monitor) {
  const std::string& name = task.parameters.text(kind);
  if (kind == "volume") write_volume(volume_for(task), folder / name);
  if (kind == "sizing") write_volume(sizing_for(task, offer.sizing()), folder / name);
  if (kind == "mesh") {
    const TriangleMesh& mesh = offer.lattice_mesh();
    const TriangleMesh placed = in_world(task) ? to_world(mesh, task.surface.lattice()) : mesh;
    write_mesh(placed, folder / name);
    if (const std::string loss = loss_in_file(placed, name); !loss.empty()) monitor.note("external: " + loss);
  }
  return name;
}

struct Figure {
  const char* name;
  Value (*value)(const MeshingTask&, Offer&);
};

constexpr Figure figures[] = {
    {"isovalue", [](const MeshingTask& task, Offer&) -> Value { return task.surface.isovalue(); }},
    {"inside", [](const MeshingTask& task, Offer&) -> Value { return to_string(task.surface.inside()); }},
    {"vertices", [](const MeshingTask&, Offer& offer) -> Value { return std::llround(offer.vertices()); }},
    {"edge_length", [](const MeshingTask&, Offer& offer) -> Value { return offer.edge_length(); }},
    {"edge_length_min", [](const MeshingTask&, Offer& offer) -> Value { return offer.sizing().smallest(); }},
    {"edge_length_max", [](const MeshingTask&, Offer& offer) -> Value { return offer.sizing().largest(); }},
    {"area", [](const MeshingTask&, Offer& offer) -> Value { return offer.area(); }},
    {"voxel", [](const MeshingTask& task, Offer&) -> Value { return task.surface.voxel(); }},
    {"seed", [](const MeshingTask& task, Offer&) -> Value { return static_cast<long long>(task.seed); }},
    {"threads", [](const MeshingTask&, Offer&) -> Value { return static_cast<long long>(threads_in_use()); }},
    {"start", [](const MeshingTask&, Offer&) -> Value { return fs::current_path().string(); }},
};

}  // namespace

std::vector<std::string> known_placeholders() {
  std::vector<std::string> names(std::begin(file_parameters), std::end(file_parameters));
  for (const Figure& figure : figures) names.emplace_back(figure.name);
  return names;
}

std::map<std::string, Value> hand_over(const MeshingTask& task, const std::vector<std::string>& wanted,
                                       const fs::path& folder, Monitor& monitor) {
  const auto stage = monitor.stage("hand over");
  Offer offer(task, monitor);
  std::map<std::string, Value> values;
  for (const std::string& name : wanted) {
    if (std::find(std::begin(file_parameters), std::end(file_parameters), name) != std::end(file_parameters)) {
      values[name] = write_file(task, name, offer, folder, monitor);
      continue;
    }
    for (const Figure& figure : figures) {
      if (name == figure.name) values[name] = figure.value(task, offer);
    }
  }
  return values;
}

}  // namespace isobench::external
