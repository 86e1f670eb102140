#include "methods/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "methods/advancing-front/advance.h"
#include "methods/advancing-front/failsafe.h"
#include "methods/advancing-front/guidance.h"
#include "methods/advancing-front/seeds.h"
#include "methods/marching-cubes/marching_cubes.h"

namespace isobench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using namespace advancing_front;

std::string place(const Eigen::Vector3d& x) { return fmt::format("({:.3f}, {:.3f}, {:.3f}) mm", x[0], x[1], x[2]); }

void book(const Counts& counts, Monitor& monitor) {
  monitor.set("advancing-front/seed", static_cast<double>(counts.seed));
  monitor.set("advancing-front/grown", static_cast<double>(counts.grown));
  monitor.set("advancing-front/connected", static_cast<double>(counts.connected));
  monitor.set("advancing-front/split", static_cast<double>(counts.split));
  monitor.set("advancing-front/merged", static_cast<double>(counts.merged));
  monitor.set("advancing-front/failsafe", static_cast<double>(counts.failsafe));
}

class Mesher {
 public:
  Mesher(const MeshingTask& task, Step step, double finest, Monitor& monitor)
      : task_(task), step_(std::move(step)), front_(finest), monitor_(monitor) {}

  TriangleMesh mesh() {
    start_and_advance();
    close();
    book(counts_, monitor_);
    TriangleMesh result;
    result.triangles = front_.triangles();
    for (const Vertex& v : front_.vertices()) result.vertices.push_back(v.x);
    drop_unused_vertices(result);
    if (result.triangles.empty()) throw Skipped("advancing-front: no front could be started anywhere on the surface");
    return result;
  }

 private:
  void start_and_advance() {
    const auto stage = monitor_.stage("fronts");
    const TriangleMesh lattice_mesh = marching_cubes(task_.surface, monitor_);
    if (leaves_lattice(lattice_mesh)) {
      throw Skipped(
          "advancing-front: the object leaves the volume, where a front has no rim to stop at; close it there");
    }
    std::size_t reached = 0;
    for (const Component& component : components_of(lattice_mesh)) {
      // A component must be a few edges round, whatever the sizing says.
      const Step step = [this, most = 0.4 * component.diagonal](const Eigen::Vector3d& x) {
        return std::min(step_(x), most);
      };
      start_on(lattice_mesh, component, step);
      reached += component.vertices.size();
      monitor_.progress(static_cast<double>(reached) / static_cast<double>(lattice_mesh.vertices.size()));
    }
  }

  bool leaves_lattice(const TriangleMesh& lattice_mesh) const {
    return std::any_of(lattice_mesh.vertices.begin(), lattice_mesh.vertices.end(), [&](const Eigen::Vector3d& x) {
      return (x.array() <= 0.0).any() || (x.array() >= task_.surface.extent().array()).any();
    });
  }

  /// One front from a point that is likely to be good, then one wherever the component, which the lattice may have
  /// joined from several, is still bare.
  void start_on(const TriangleMesh& lattice_mesh, const Component& component, const Step& step) {
    for (const Eigen::Vector3d& point : starting_points(lattice_mesh, component, step, task_.seed)) {
      if (is_bare(point, step) && start_at(point, step)) break;
    }
    for (const std::uint32_t n : component.vertices) {
      const Eigen::Vector3d& point = lattice_mesh.vertices[n];
      if (!is_bare(point, step)) continue;
      const std::size_t triangles = front_.triangles().size(), vertices = front_.vertices().size();
      const Counts before = counts_;
      if (!start_at(point, step)) {
        ++bare_places_;
        continue;
      }
      // On a bump that a front cut across this leads nowhere.
      if (counts_.merged == before.merged && front_.is_open_from(vertices)) {
        front_.take_back(triangles, vertices);
        counts_ = before;
        monitor_.note(fmt::format("advancing-front: the mesh misses part of the surface at {}", place(point)));
      }
    }
  }

  bool is_bare(const Eigen::Vector3d& point, const Step& step) const {
    const Vertex vertex = make_vertex(task_.surface, step, point);
    return !front_.covers(vertex, 2.0 * vertex.step, 0.1 * vertex.step);
  }

  bool start_at(const Eigen::Vector3d& point, const Step& step) {
    const auto corners = seed_triangle(task_.surface, step, point, task_.seed);
    if (!corners) return false;
    ++counts_.seed;
    Advance advance(task_.surface, step, front_, counts_);
    advance.add_loop(front_.seed(*corners));
    advance.run(monitor_);
    return true;
  }

  void close() {
    if (bare_places_ > 0) {
      monitor_.note(fmt::format(
          "advancing-front: at {} of the lattice's vertices nothing is meshed and no triangle fits", bare_places_));
    }
    monitor_.set("advancing-front/bare places", static_cast<double>(bare_places_));
    const auto stage = monitor_.stage("failsafe");
    const std::vector<Hole> holes = close_holes(task_.surface, front_);
    for (const Hole& hole : holes) {
      counts_.failsafe += hole.triangles;
      monitor_.note(fmt::format("advancing-front: the failsafe {} a hole of {} edges at {}",
                                hole.closed ? "closed" : "could not close", hole.edges, place(hole.centre)));
    }
    monitor_.set("advancing-front/holes", static_cast<double>(holes.size()));
    monitor_.set("advancing-front/open holes",
                 static_cast<double>(std::count_if(holes.begin(), holes.end(), [](auto& h) { return !h.closed; })));
  }

  const MeshingTask& task_;
  Step step_;
  Front front_;
  Counts counts_;
  std::size_t bare_places_ = 0;
  Monitor& monitor_;
};

std::shared_ptr<const SizingField> own_guidance(const MeshingTask& task, Monitor& monitor) {
  if (task.sizing.uniform()) {
    monitor.note(
        "advancing-front: its own guidance follows curvature alone; the edge length that was asked for has no "
        "effect");
  }
  GuidanceOptions options;
  options.rho = task.parameters.number("rho");
  options.eta = task.parameters.number("eta");
  options.floor = task.sizing.floor * task.surface.voxel() / task.parameters.number("contraction");
  options.seed = task.seed;
  return std::make_shared<const SizingField>(guidance_field(task.surface, options, monitor));
}

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  const bool own = task.parameters.text("guidance") == "own";
  const auto field = own ? own_guidance(task, monitor) : task.sizing_field(monitor);
  const double g = own || task.sizing.uniform() ? 1.0 : task.parameters.number("contraction");
  const Step step = [&field, g](const Eigen::Vector3d& x) { return field->h(x) / g; };
  return Mesher(task, step, field->smallest() / g, monitor).mesh();
}

}  // namespace

Method method_advancing_front() {
  Method method;
  method.name = "advancing-front";
  method.summary =
      "Triangles grown one by one from the rim of what is meshed, their new vertices turned onto F = c "
      "(after Schreiner, Scheidegger, Silva 2006; fronts are joined with more care for the angles that remain)";
  method.revision = 1;
  method.parameters = {
      {"guidance",
       std::string("shared"),
       "",
       "where the sizing comes from: 'shared' is the field h that was asked for, 'own' the method's guidance field, "
       "from "
       "curvature alone",
       -infinity,
       infinity,
       {"shared", "own"},
       false},
      {"contraction",
       1.5,
       "",
       "g: adaptive spacing is h/g, as the particles have it, so that methods compare at equal sizing",
       1.0,
       4.0,
       {},
       false},
      {"rho",
       0.19634954084936207,
       "radians",
       "own guidance: how far an edge turns along the tightest circle",
       0.01,
       1.5,
       {},
       false},
      {"eta",
       0.8,
       "",
       "own guidance: steps grow with slope 1 - eta from eta times the ideal length",
       0.1,
       0.99,
       {},
       false},
  };
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
