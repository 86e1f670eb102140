// Compares `delaunay-refinement` with a program as CGAL's manual shows it: both run in turn on the same F = c with the
// same criteria. The counter "ratio" is our CPU time over that of the plain program; it must not exceed 1.3.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <benchmark/benchmark.h>

#include <ctime>
#include <string>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

/// Meshes as CGAL's manual shows it and returns the number of vertices.
std::size_t plain_mesh_3(const Isosurface& surface, double radius) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
  namespace p = CGAL::parameters;
  const auto f = [&surface](const Kernel::Point_3& x) { return -surface.value({x.x(), x.y(), x.z()}); };
  const Eigen::Vector3d centre = 0.5 * surface.extent();
  const Kernel::Sphere_3 around({centre[0], centre[1], centre[2]}, centre.squaredNorm());
  const Domain domain = Domain::create_implicit_mesh_domain(f, around);
  const Criteria criteria(p::facet_angle = 30.0, p::facet_size = radius);
  const auto complex = CGAL::make_mesh_3<Complex>(domain, criteria, p::no_exude(), p::no_perturb(), p::manifold());
  return complex.triangulation().number_of_vertices();
}

TriangleMesh refined(const Isosurface& surface, const SizingRequest& sizing, Monitor& monitor) {
  const Method& method = isobench::method("delaunay-refinement");
  return method.mesh(MeshingTask(surface, sizing, Parameters(method.parameters), 1), monitor);
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void against_plain_mesh_3(benchmark::State& state, const std::string& name) {
  Monitor monitor;
  Dataset dataset;
  try {
    dataset = load_dataset(name, monitor);
  } catch (const Error& error) {
    state.SkipWithError(error.what());
    return;
  }
  const Isosurface& surface = *dataset.surface;
  SizingRequest sizing;
  sizing.vertices = static_cast<double>(state.range(0));
  refined(surface, sizing, monitor);  // finds the radius bound that gives this number of vertices
  const double length = make_sizing_field(surface, sizing, monitor).largest();
  const double radius = length * monitor.counters().at("delaunay-refinement/radius over h");
  double ours = 0.0;
  double plain = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const double start = cpu_seconds();
    state.counters["vertices"] = static_cast<double>(refined(surface, sizing, monitor).vertices.size());
    const double between = cpu_seconds();
    state.counters["plain_vertices"] = static_cast<double>(plain_mesh_3(surface, radius));
    ours += between - start;
    plain += cpu_seconds() - between;
    state.SetIterationTime(between - start);
  }
  state.counters["ratio"] = ours / plain;
}
BENCHMARK_CAPTURE(against_plain_mesh_3, skull_small, "skull-small")
    ->Arg(50000)
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace isobench
