// The project's own claim, measured: `particles` against CGAL's Mesh_3 on one thread and on all, on the same F = c at
// the same number of vertices.
//
//   particles_against_mesh_3 [--dataset skull-small] [--vertices 50000] [--runs 5] [--threads N]
//
// All contestants run in turn, `runs` times, so that other work on the machine slows all of them down. The tool
// compares the medians of wall seconds, from the prepared volume in memory to the finished mesh, and of CPU seconds
// (user and system, of all threads), which say more if the machine has other work. Mesh_3 gets the edge length at which
// it makes that number of vertices; the search for it is not counted. The fourth contestant is one Delaunay
// triangulation of the vertices of `particles`, the least work that a method of its kind needs.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {
namespace {

struct Options {
  std::string dataset = "skull-small";
  double vertices = 50000.0;
  int runs = 5;
  int threads = 0;  ///< 0: as many as there are
};

struct Contestant {
  std::string name;
  std::function<TriangleMesh()> mesh;
  std::vector<double> wall = {};
  std::vector<double> cpu = {};
  TriangleMesh last = {};
};

double cpu_now() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void run(Contestant& contestant) {
  const double cpu = cpu_now();
  const auto start = std::chrono::steady_clock::now();
  TriangleMesh mesh = contestant.mesh();
  contestant.wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  contestant.cpu.push_back(cpu_now() - cpu);
  contestant.last = std::move(mesh);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

TriangleMesh mesh_by(const std::string& name, const std::map<std::string, ParameterValue>& values,
                     const Isosurface& surface, const SizingRequest& sizing) {
  const Method& method = isobench::method(name);
  Parameters parameters(method.parameters);
  for (const auto& [key, value] : values) parameters.set(method.parameters, key, value);
  Monitor monitor;
  return method.mesh(MeshingTask(surface, sizing, std::move(parameters), 1), monitor);
}

/// The edge length at which the number of vertices of Mesh_3 is within 1 % of `vertices`.
SizingRequest length_for_mesh_3(const Isosurface& surface, double vertices) {
  SizingRequest number;
  number.vertices = vertices;
  Monitor monitor;
  SizingRequest length;
  length.edge_length = make_sizing_field(surface, number, monitor).largest();
  constexpr int most = 8;
  for (int n = 0; n < most; ++n) {
    const TriangleMesh mesh = mesh_by("delaunay-refinement", {}, surface, length);
    const double share = static_cast<double>(mesh.vertices.size()) / vertices;
    if (std::abs(share - 1.0) < 0.01) break;
    *length.edge_length *= std::sqrt(share);
  }
  return length;
}

/// Makes the triangulation and returns an empty mesh.
TriangleMesh delaunay_of(const std::vector<Eigen::Vector3d>& vertices) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  points.reserve(vertices.size());
  for (const Eigen::Vector3d& x : vertices) points.emplace_back(x[0], x[1], x[2]);
  const CGAL::Delaunay_triangulation_3<Kernel> delaunay(points.begin(), points.end());
  if (delaunay.number_of_vertices() != vertices.size()) throw Error("two particles are at one place");
  return {};
}

void print_seconds(const std::vector<Contestant>& contestants) {
  const Contestant& ours = contestants.front();
  fmt::print("{:28} {:>24} {:>24} {:>12} {:>12}\n", "", "wall s, median (range)", "CPU s, median (range)",
             "particles /", "in CPU s");
  const auto spread = [](const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fmt::format("{:.3f} ({:.3f}–{:.3f})", median(values), *least, *most);
  };
  for (const Contestant& contestant : contestants) {
    fmt::print("{:28} {:>24} {:>24} {:>12.3f} {:>12.3f}\n", contestant.name, spread(contestant.wall),
               spread(contestant.cpu), median(ours.wall) / median(contestant.wall),
               median(ours.cpu) / median(contestant.cpu));
  }
}

void print_quality(std::vector<Contestant>& contestants, const Isosurface& surface, const SizingField& sizing) {
  fmt::print("\n{:28} {:>8} {:>14} {:>14} {:>12} {:>11} {:>12} {:>22} {:>24}\n", "", "vertices", "Q min / avg",
             "angles °", "valence 6 %", "outside 5–7", "χ / comp.", "to F = c mean / max mm",
             "from F = c mean / max mm");
  for (Contestant& contestant : contestants) {
    if (contestant.last.triangles.empty()) continue;
    Monitor monitor;
    const Measurement m = measure(contestant.last, surface, sizing, monitor);
    fmt::print(
        "{:28} {:>8} {:>14} {:>14} {:>12.2f} {:>11} {:>12} {:>22} {:>24}{}\n", contestant.name, m.number("vertices"),
        fmt::format("{:.3f} / {:.4f}", m.number("radius_ratio_min"), m.number("radius_ratio_avg")),
        fmt::format("{:.1f}–{:.1f}", m.number("angle_min"), m.number("angle_max")), m.number("valence_6_percent"),
        m.number("valence_extreme_count"), fmt::format("{} / {}", m.number("euler"), m.number("components")),
        fmt::format("{:.5f} / {:.4f}", m.number("distance_mean"), m.number("distance_max")),
        fmt::format("{:.5f} / {:.4f}", m.number("distance_from_surface_mean"), m.number("distance_from_surface_max")),
        is_closed_manifold(m) ? "" : "  not a closed manifold");
  }
}

void compete(const Options& options) {
  Monitor monitor;
  const Dataset dataset = load_dataset(options.dataset, monitor);
  const Isosurface& surface = *dataset.surface;
  SizingRequest number;
  number.vertices = options.vertices;
  const SizingRequest length = length_for_mesh_3(surface, options.vertices);
  std::vector<Contestant> contestants;
  contestants.push_back({"particles", [&] { return mesh_by("particles", {}, surface, number); }});
  contestants.push_back({"Mesh_3", [&] { return mesh_by("delaunay-refinement", {}, surface, length); }});
  contestants.push_back({"Mesh_3 with TBB", [&] {
                           return mesh_by("delaunay-refinement", {{"parallel", true}}, surface, length);
                         }});
  contestants.push_back({"Delaunay of the particles", [&] { return delaunay_of(contestants.front().last.vertices); }});
  for (int n = 0; n < options.runs; ++n) {
    for (Contestant& contestant : contestants) run(contestant);
  }
  fmt::print("{} at {:.0f} vertices, {} runs each in turn, {} threads\n\n", dataset.title, options.vertices,
             options.runs, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  print_seconds(contestants);
  print_quality(contestants, surface, make_sizing_field(surface, number, monitor));
}

}  // namespace
}  // namespace isobench

int main(int argc, char** argv) {
  isobench::Options options;
  CLI::App app("particles against CGAL's Mesh_3, in turn, on one surface at one number of vertices");
  app.add_option("--dataset", options.dataset, "a name of `isobench list datasets`, or a manifest")
      ->capture_default_str();
  app.add_option("--vertices", options.vertices)->check(CLI::Range(100.0, 1e8))->capture_default_str();
  app.add_option("--runs", options.runs, "runs of each contestant, in turn")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "maximum number of threads; 0: all")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const auto all = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    options.threads > 0 ? static_cast<std::size_t>(options.threads) : all);
    isobench::compete(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
