#include <fmt/format.h>

#include <algorithm>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/method.h"
#include "isobench/reports/tables/summary.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

void check_source(const MeshArguments& arguments) {
  const bool dataset = !arguments.dataset.empty();
  const bool volume = !arguments.volume.empty();
  if (dataset == volume) throw UsageError("give either --dataset or --volume");
  if (volume && !arguments.isovalue) throw UsageError("--volume needs --isovalue, the value of its surface");
  if (dataset && arguments.isovalue) throw UsageError("--isovalue goes with --volume; a dataset has its own");
}

// Known before minutes are spent on the mesh that could not be written.
void check_output(const fs::path& output) {
  if (output.empty()) return;
  const std::vector<std::string> endings = {".vtp", ".ply", ".off", ".obj", ".stl"};
  const std::string ending = output.extension().string();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
    throw UsageError(
        fmt::format("{}: unknown ending '{}'; known are: {}", output.string(), ending, fmt::join(endings, ", ")));
  }
  const fs::path folder = output.parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {
    throw UsageError(output.string() + ": the folder " + folder.string() + " does not exist");
  }
}

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
  request.dataset = arguments.dataset;
  request.method = chosen.name;
  request.label = chosen.name;
  request.method_revision = chosen.revision;
  request.parameters = parameters.all();
  request.sizing = arguments.sizing;
  request.seed = arguments.seed;
  return request;
}

Dataset load(const MeshArguments& arguments, Monitor& monitor) {
  const Monitor::Stage stage = monitor.stage("prepare");
  if (!arguments.dataset.empty()) return load_dataset(arguments.dataset, monitor);
  const Inside inside = arguments.inside == "above" ? Inside::above : Inside::below;
  return dataset_from_file(arguments.volume, *arguments.isovalue, inside, arguments.smooth, Kernel::bspline, monitor);
}

void write_whole(const TriangleMesh& mesh, const fs::path& output) {
  PartialFile partial(output);
  write_mesh(mesh, partial.path());
  partial.complete();
}

}  // namespace

int mesh_verb(const MeshArguments& arguments, const CommonArguments& common) {
  check_source(arguments);
  check_output(arguments.output);
  if (!arguments.artefacts.empty() && !fs::is_directory(arguments.artefacts)) {
    throw UsageError("--artefacts " + arguments.artefacts.string() + ": there is no such folder");
  }
  check(arguments.sizing);
  const RunRequest request = request_of(arguments);
  Console console(common.verbosity);
  ConsoleSink sink(console);
  Monitor monitor(&sink);
  monitor.keep_artefacts(!arguments.artefacts.empty());
  monitor.keep_files_in(arguments.artefacts);
  RunRecord record;
  record.request = request;
  const Dataset dataset = load(arguments, monitor);
  for (const std::string& step : dataset.preparation) console.detail("prepared: " + step);
  try {
    const TriangleMesh mesh = to_world(mesh_and_measure(dataset, request, monitor, record), dataset.surface->lattice());
    console.clear();
    if (!arguments.output.empty()) write_whole(mesh, arguments.output);
    write_artefacts(monitor.artefacts(), dataset.surface->lattice(), arguments.artefacts);
  } catch (const Skipped& skipped) {
    console.clear();
    fmt::print(stderr, "isobench: {} cannot do this: {}\n", request.method, skipped.what());
    return 1;
  }
  fmt::print("{} by {}, {}\n{}", dataset.name, request.method, sizing_text(request.sizing),
             summary_text(*record.measurement));
  fmt::print("time          sizing and method {:.2f} s, peak memory {:.0f} MB\n", monitor.seconds("mesh"),
             record.peak_memory_mb);
  for (const std::string& note : monitor.notes()) fmt::print("note          {}\n", note);
  if (!arguments.output.empty()) fmt::print("written       {}\n", arguments.output.string());
  return 0;
}

}  // namespace isobench
