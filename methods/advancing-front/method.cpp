#include "isobench/methods/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "isobench/methods/advancing-front/advance.h"
#include "isobench/methods/advancing-front/failsafe.h"
#include "isobench/methods/advancing-front/guidance.h"
#include "isobench/methods/advancing-front/seeds.h"
#include "isobench/methods/lattice/marching_cubes.h"

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
    lattice_mesh_ = marching_cubes(task_.surface, monitor_);
    if (leaves_lattice()) {
      throw Skipped(
          "advancing-front: the surface reaches the border of the volume; this method needs a closed surface");
    }
    components_ = components_of(lattice_mesh_);
    most_triangles_ = triangles_without_end();
    start_and_advance();
    close();
    take_over(front_);
    mesh_what_was_missed();
    book(counts_, monitor_);
    drop_unused_vertices(result_);
    if (result_.triangles.empty()) throw Skipped("advancing-front: no front could be started anywhere on the surface");
    return std::move(result_);
  }

 private:
  void start_and_advance() {
    const auto stage = monitor_.stage("fronts");
    std::size_t reached = 0;
    for (const Component& component : components_) {
      // Even a small component must be at least a few edges round.
      start_on(component, step_on(component, 0.4));
      reached += component.vertices.size();
      monitor_.progress(static_cast<double>(reached) / static_cast<double>(lattice_mesh_.vertices.size()));
    }
  }

  bool leaves_lattice() const {
    return std::any_of(lattice_mesh_.vertices.begin(), lattice_mesh_.vertices.end(), [&](const Eigen::Vector3d& x) {
      return (x.array() <= 0.0).any() || (x.array() >= task_.surface.extent().array()).any();
    });
  }

  /// Several times the number of triangles that the surface can have room for.
  std::size_t triangles_without_end() const {
    double expected = 0.0;
    for (const auto& [a, b, c] : lattice_mesh_.triangles) {
      const auto& x = lattice_mesh_.vertices;
      const double area = 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
      const double step = step_((x[a] + x[b] + x[c]) / 3.0);
      expected += area / (0.25 * std::sqrt(3.0) * step * step);
    }
    constexpr double too_many = 20.0;
    constexpr std::size_t for_a_component = 2000;  // however small it is
    return static_cast<std::size_t>(too_many * expected) + for_a_component * components_.size();
  }

  /// The step, limited to this share of the component's diagonal.
  Step step_on(const Component& component, double share) const {
    return [this, most = share * component.diagonal()](const Eigen::Vector3d& x) { return std::min(step_(x), most); };
  }

  /// Starts a front at a promising point, then others wherever the component is still bare: the lattice may have joined
  /// several components of F = c into one.
  void start_on(const Component& component, const Step& step) {
    for (const Eigen::Vector3d& point : starting_points(lattice_mesh_, component, step, task_.seed)) {
      if (is_bare(point, step) && start_at(point, step)) break;
    }
    for (const std::uint32_t n : component.vertices) {
      const Eigen::Vector3d& point = lattice_mesh_.vertices[n];
      if (!is_bare(point, step)) continue;
      const std::size_t triangles = front_.triangles().size(), vertices = front_.vertices().size();
      const Counts before = counts_;
      if (!start_at(point, step)) {
        ++bare_places_;
        continue;
      }
      // A front on a bump that an earlier front has cut across neither closes nor merges: undo it.
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
    Advance advance(task_.surface, step, front_, counts_, {Eigen::Vector3d::Zero(), task_.surface.extent()},
                    most_triangles_);
    advance.add_loop(front_.seed(*corners));
    advance.run(monitor_);
    if (advance.is_endless()) monitor_.note(fmt::format("advancing-front: no end of the front at {}", place(point)));
    return true;
  }

  void close() {
    if (bare_places_ > 0) {
      monitor_.note(fmt::format(
          "advancing-front: at {} vertices of the lattice's mesh the surface is not meshed and no triangle fits",
          bare_places_));
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

  void take_over(const Front& front) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    vertices_.insert(vertices_.end(), front.vertices().begin(), front.vertices().end());
    for (const Vertex& v : front.vertices()) result_.vertices.push_back(v.x);
    for (const auto& [a, b, c] : front.triangles()) result_.triangles.push_back({first + a, first + b, first + c});
  }

  /// Meshes the components that no front has reached. A small component close to a larger one was taken for meshed.
  void mesh_what_was_missed() {
    const auto stage = monitor_.stage("missed");
    std::vector<char> used(vertices_.size(), 0);
    for (const Triangle& t : result_.triangles) {
      for (const std::uint32_t corner : t) used[corner] = 1;
    }
    std::vector<Vertex> standing;
    for (std::size_t n = 0; n < vertices_.size(); ++n) {
      if (used[n] != 0) standing.push_back(vertices_[n]);
    }
    std::size_t lost = 0, alone = 0;
    for (const Component& component : components_without(task_.surface, lattice_mesh_, components_, standing)) {
      if (mesh_alone(component)) {
        ++alone;
        continue;
      }
      ++lost;
      monitor_.note(fmt::format("advancing-front: a component {:.3f} mm across is not meshed at {}",
                                component.diagonal(), place(component.box.center())));
    }
    monitor_.set("advancing-front/components alone", static_cast<double>(alone));
    monitor_.set("advancing-front/lost components", static_cast<double>(lost));
  }

  /// Meshes a component by a front that ignores all others. The result is kept if the front closes within the
  /// component's box.
  bool mesh_alone(const Component& component) {
    Eigen::AlignedBox3d bounds = component.box;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(task_.surface.voxel());
    bounds.extend(component.box.min() - margin).extend(component.box.max() + margin);
    for (const double share : {0.4, 0.25, 0.15}) {
      const Step step = step_on(component, share);
      for (const Eigen::Vector3d& point : starting_points(lattice_mesh_, component, step, task_.seed)) {
        const auto corners = seed_triangle(task_.surface, step, point, task_.seed);
        if (!corners) continue;
        Front front((*corners)[0].step);
        Counts counts = counts_;
        ++counts.seed;
        Advance advance(task_.surface, step, front, counts, bounds, most_triangles_);
        advance.add_loop(front.seed(*corners));
        advance.run(monitor_);
        if (advance.strayed() || front.alive() > 0) continue;
        counts_ = counts;
        take_over(front);
        return true;
      }
    }
    return false;
  }

  const MeshingTask& task_;
  Step step_;
  TriangleMesh lattice_mesh_;
  std::vector<Component> components_;
  Front front_;
  std::vector<Vertex> vertices_;
  TriangleMesh result_;
  Counts counts_;
  std::size_t most_triangles_ = 0;
  std::size_t bare_places_ = 0;
  Monitor& monitor_;
};

std::shared_ptr<const SizingField> own_guidance(const MeshingTask& task, Monitor& monitor) {
  if (task.sizing.uniform()) {
    monitor.note("advancing-front: its own guidance follows curvature alone; the requested edge length has no effect");
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
      "Triangles grown one by one from a moving front, their new vertices rotated to F = c (after Schreiner, "
      "Scheidegger, "
      "Silva 2006; unlike there, fronts are connected only where the remaining angles allow it)";
  method.revision = 2;
  method.parameters = {
      {"guidance",
       std::string("shared"),
       "",
       "sizing: 'shared' is the requested field h, 'own' the method's guidance field, from curvature alone",
       -infinity,
       infinity,
       {"shared", "own"},
       false},
      {"contraction",
       1.5,
       "",
       "g: adaptive sizing aims at an edge length of h/g, as particles does, so that methods compare at equal sizing",
       1.0,
       4.0,
       {},
       false},
      {"rho",
       0.19634954084936207,
       "radians",
       "own guidance: angle that an edge subtends at the centre of the surface's tightest circle",
       0.01,
       1.5,
       {},
       false},
      {"eta",
       0.8,
       "",
       "own guidance: steps start at eta times the ideal length and grow with slope 1 - eta",
       0.1,
       0.99,
       {},
       false},
  };
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
