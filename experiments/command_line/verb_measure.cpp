#include <fmt/format.h>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/runner/remeasure.h"
#include "isobench/experiments/runner/store.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_notes.h"
#include "isobench/reports/record/record.h"
#include "isobench/reports/tables/summary.h"

namespace isobench {

namespace {

int measure_results(const MeasureArguments& arguments, const CommonArguments& common) {
  if (arguments.surface.given() || arguments.epsilon || arguments.delta || arguments.json) {
    throw UsageError(arguments.mesh.string() +
                     " is a folder: each run in it is measured against its own dataset and sizing. Leave out "
                     "--dataset, --volume, --epsilon, --delta and --json, or name a mesh file");
  }
  Console console(common.verbosity);
  const MetricChoice choice = arguments.metrics_of_use ? MetricChoice::all : MetricChoice::usual;
  const RemeasureSummary summary = remeasure(arguments.mesh, choice, console);
  write_report_locked(arguments.mesh, common.tables_only ? ReportParts::tables : ReportParts::all);
  std::string text = fmt::format("{} measured", summary.measured);
  if (summary.without_mesh > 0) text += fmt::format(", {} without a mesh", summary.without_mesh);
  if (summary.failed > 0) text += fmt::format(", {} kept as they were", summary.failed);
  if (summary.elsewhere > 0) text += fmt::format(", {} left to another process", summary.elsewhere);
  console.line(fmt::format("{}: {}", arguments.mesh.string(), text));
  return summary.failed > 0 ? 1 : 0;
}

int measure_file(const MeasureArguments& arguments, const CommonArguments& common) {
  if (arguments.surface.given()) check(arguments.surface);
  SizingRequest request;
  if (arguments.delta && !arguments.epsilon) throw UsageError("--delta goes with --epsilon; give both");
  if (arguments.epsilon) {
    if (!arguments.surface.given())
      throw UsageError("--epsilon needs the surface, for its curvature and feature size: give --dataset or --volume");
    request.epsilon = arguments.epsilon;
    request.delta = arguments.delta.value_or(0.3);
    request.floor = arguments.floor;
    check(request);
  }
  Console console(common.verbosity);
  ConsoleSink sink(console);
  Monitor monitor(&sink);
  TriangleMesh mesh = read_mesh(arguments.mesh, monitor);
  for (const std::string& note : notes_on(mesh)) monitor.note(note);
  Dataset dataset;
  std::optional<SizingField> sizing;
  if (arguments.surface.given()) {
    dataset = load(arguments.surface, monitor);
    mesh = to_local(std::move(mesh), in_frame(dataset.surface->lattice(), frame_of(arguments.surface)));
    if (arguments.epsilon) sizing.emplace(make_sizing_field(*dataset.surface, request, monitor));
  }
  const Measurement measurement = measure(mesh, {dataset.surface.get(), sizing ? &*sizing : nullptr}, monitor);
  console.clear();
  fmt::print("{}", arguments.json ? to_json(measurement) : summary_text(measurement));
  // Standard output is one JSON document, if that was asked for.
  for (const std::string& note : monitor.notes()) {
    if (arguments.json)
      fmt::print(stderr, "isobench: {}\n", note);
    else
      fmt::print("note          {}\n", note);
  }
  return 0;
}

}  // namespace

int measure_verb(const MeasureArguments& arguments, const CommonArguments& common) {
  if (std::filesystem::is_directory(arguments.mesh)) return measure_results(arguments, common);
  return measure_file(arguments, common);
}

}  // namespace isobench
