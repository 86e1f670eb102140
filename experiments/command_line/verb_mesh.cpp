#include <fmt/format.h>

#include <cmath>

#include "isobench/datasets/topology/component_volumes.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_notes.h"
#include "isobench/methods/method.h"
#include "isobench/methods/sizing/coarse_request.h"
#include "isobench/metrics/topology/topology.h"
#include "isobench/reports/tables/summary.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

RunRequest request_of(const MeshArguments& arguments) {
  const Method& chosen = method(arguments.method);
  Parameters parameters(chosen.parameters);
  for (const std::string& setting : arguments.set) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw UsageError("--set " + setting + ": expected key=value");
    parameters.set_text(chosen.parameters, setting.substr(0, equals), setting.substr(equals + 1));
  }
  for (const ParameterSpec& spec : chosen.parameters) {
    if (!spec.required || parameters.all().at(spec.name) != spec.default_value) continue;
    throw UsageError(fmt::format("{} needs --set {}=…, {}", chosen.name, spec.name, spec.description));
  }
  RunRequest request;
  request.dataset = arguments.surface.dataset;
  request.method = chosen.name;
  request.label = chosen.name;
  request.method_revision = chosen.revision;
  request.parameters = parameters.all();
  request.seed = arguments.seed;
  return request;
}

// The sizing of the arguments, or a default if they state none and the method needs one.
SizingRequest sizing_of(const MeshArguments& arguments, const Method& chosen, Console& console) {
  SizingRequest sizing = arguments.sizing;
  if (!is_empty(sizing)) {
    check(sizing);
  } else if (!chosen.ignores_sizing) {
    sizing.epsilon = 0.5;
    sizing.delta = 0.3;
    console.line("no sizing was given: taking --epsilon 0.5 --delta 0.3");
  }
  return sizing;
}

/// Whoever meshes a scan may not want its noise, and should know how to leave it out.
void note_specks(const Dataset& dataset, Monitor& monitor) {
  const CertifiedTopology& topology = *dataset.topology;
  if (topology.components.size() < 2) return;
  constexpr double speck_voxels = 10.0;
  const double speck = speck_voxels * dataset.surface->lattice().spacing.prod();
  const std::vector<double> volumes = component_volumes(*dataset.surface, topology);
  std::size_t specks = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    specks += !topology.components[c].is_left_out && std::abs(volumes[c]) < speck ? 1 : 0;
  if (specks == 0) return;
  const std::size_t all = topology.kept_components();
  const std::string remedy = 2 * specks > all ? fmt::format("; --min-component {:.3g} leaves them out", speck) : "";
  monitor.note(fmt::format("{}: {} of {} components of F = c enclose fewer than {} voxels ({:.3g} mm³){}",
                           dataset.title, specks, all, speck_voxels, speck, remedy));
}

}  // namespace

int mesh_verb(const MeshArguments& arguments, const CommonArguments& common) {
  check(arguments.surface);
  // Before meshing, so that no time is spent on a mesh that cannot be written.
  if (!arguments.output.empty()) check_mesh_path(arguments.output);
  if (!arguments.artefacts.empty() && !fs::is_directory(arguments.artefacts)) {
    throw UsageError("--artefacts " + arguments.artefacts.string() + ": there is no such folder; make it first");
  }
  RunRequest request = request_of(arguments);
  Console console(common.verbosity);
  request.sizing = sizing_of(arguments, method(request.method), console);
  ConsoleSink sink(console);
  Monitor monitor(&sink);
  monitor.keep_artefacts(!arguments.artefacts.empty());
  monitor.keep_files_in(arguments.artefacts);
  RunRecord record;
  record.request = request;
  const Dataset dataset = load(arguments.surface, monitor);
  const Frame frame = frame_of(arguments.surface);
  const Lattice placed = in_frame(dataset.surface->lattice(), frame);
  for (const std::string& step : dataset.preparation) console.detail("prepared: " + step);
  note_specks(dataset, monitor);
  try {
    const Bounds bounds{.most_vertices = arguments.max_vertices,
                        .announce = [&](const std::string& expected) { console.line("expected: " + expected); }};
    const TriangleMesh mesh = to_world(mesh_and_measure(dataset, request, monitor, record, bounds), placed);
    console.clear();
    const std::string coarse =
        method(request.method).ignores_sizing ? std::string() : coarse_request(request.sizing, mesh);
    if (!coarse.empty()) monitor.note(coarse);
    if (!arguments.output.empty()) {
      write_mesh(mesh, arguments.output);
      if (const std::string loss = loss_in_file(mesh, arguments.output); !loss.empty()) monitor.note(loss);
    }
    write_artefacts(monitor.artefacts(), placed, arguments.artefacts);
  } catch (const Skipped& skipped) {
    console.clear();
    fmt::print(stderr, "isobench: {} cannot do this: {}\n", request.method, skipped.what());
    return 1;
  }
  const std::string sizing = is_empty(request.sizing) ? "" : ", " + sizing_text(request.sizing);
  fmt::print("{} by {}{}\n{}", dataset.name, request.method, sizing, summary_text(*record.measurement));
  fmt::print("frame         {}\n", frame_text(placed, frame));
  fmt::print("time          sizing and method {:.2f} s, peak memory {:.0f} MB\n", monitor.seconds("mesh"),
             record.peak_memory_mb);
  for (const std::string& note : monitor.notes()) fmt::print("note          {}\n", note);
  if (!arguments.output.empty()) fmt::print("written       {}\n", arguments.output.string());
  if (!method(request.method).promises_manifold || is_closed_manifold(*record.measurement)) return 0;
  fmt::print(stderr, "isobench: {} did not end as a closed manifold, which is its fault; please report it\n",
             request.method);
  return 1;
}

}  // namespace isobench
