#include "isobench/experiments/runner/cell.h"

#include <unistd.h>

#include <algorithm>
#include <new>

#include "isobench/experiments/plan/vertex_match.h"
#include "isobench/experiments/runner/estimate.h"
#include "isobench/experiments/runner/fault_injection.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/processes/process_table.h"
#include "isobench/methods/mesh/component_match.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/method.h"

namespace isobench {

namespace {

// The sizing is computed when a stage of the method first needs it, so it is a part of that stage.
double sizing_seconds(const Monitor& monitor) {
  double seconds = 0.0;
  for (const StageTime& stage : monitor.stages()) {
    if (stage.name.starts_with("mesh/") && stage.name.ends_with("/sizing")) seconds += stage.wall_seconds;
  }
  return seconds;
}

void book(const Monitor& monitor, RunRecord& record) {
  record.seconds_prepare = monitor.seconds("prepare");
  record.seconds_total = monitor.seconds("mesh");
  record.seconds_sizing = sizing_seconds(monitor);
  record.seconds_method = record.seconds_total - record.seconds_sizing;
  record.stages = monitor.stages();
  record.counters = monitor.counters();
  record.traces = monitor.traces();
  record.notes = monitor.notes();
}

Parameters parameters_of(const RunRequest& request) {
  const ParameterSchema& schema = method(request.method).parameters;
  Parameters parameters(schema);
  for (const auto& [name, value] : *request.parameters) parameters.set(schema, name, value);
  return parameters;
}

MeshingTask task_of(const Dataset& dataset, const RunRequest& request, double scale = 1.0) {
  return {*dataset.surface, scaled(request.sizing, scale), parameters_of(request), request.seed, dataset.topology};
}

TriangleMesh mesh(MeshingTask& task, const RunRequest& request, const Bounds& bounds, Monitor& monitor) {
  const Method& chosen = method(request.method);
  const auto check = [&](const SizingField& field) {
    const Estimate expected = estimate(task, chosen, field, monitor);
    if (bounds.announce) bounds.announce(to_string(expected));
    refuse_if_too_large(expected, task, bounds.most_vertices);
  };
  if (!chosen.ignores_sizing) {
    // Edges of one length are known before the work. Others are known once the method has asked for the sizing.
    if (task.sizing.uniform())
      check(SizingField(task.sizing.edge_length.value_or(1.0)));
    else
      task.when_sized = check;
  }
  const Monitor::Stage stage = monitor.stage("mesh");
  TriangleMesh made = chosen.mesh(task, monitor);
  task.when_sized = nullptr;
  drop_left_out(made, task.surface, task.topology(monitor));
  inject_fault(request, made);
  if (made.triangles.empty()) throw Error("the method returned no triangles");
  return made;
}

// Meshes until the number of vertices matches and keeps the nearest mesh. Only the seconds, counters and traces of that
// attempt are kept: the other attempts are a cost of the search, not of the method.
TriangleMesh mesh_matched(const Dataset& dataset, const RunRequest& request, double vertices, const Bounds& bounds,
                          Monitor& monitor, RunRecord& record) {
  const Monitor::Bookings before = monitor.bookings();
  VertexMatch match(vertices);
  TriangleMesh nearest;
  Monitor::Bookings of_nearest;
  while (const std::optional<double> scale = match.next()) {
    monitor.restore(before);
    MeshingTask task = task_of(dataset, request, *scale);
    TriangleMesh attempt = mesh(task, request, bounds, monitor);
    match.tried(*scale, static_cast<double>(attempt.vertices.size()));
    if (match.best() + 1 < match.tries()) continue;
    nearest = std::move(attempt);
    of_nearest = monitor.bookings();
    record.peak_memory_mb = std::max(peak_memory_mb(), monitor.program_memory_mb());
  }
  monitor.restore(std::move(of_nearest));
  record.match = MatchRecord{vertices, match.best_scale(), static_cast<int>(match.tries()), match.reason()};
  return nearest;
}

TriangleMesh load_and_mesh(const RunRequest& request, std::optional<double> match_vertices, Monitor& monitor,
                           RunRecord& record) {
  Dataset dataset;
  {
    const Monitor::Stage stage = monitor.stage("prepare");
    dataset = load_dataset(request.dataset, monitor, {}, request.min_component);
  }
  if (dataset.checksum != request.dataset_checksum) {
    throw DataError("dataset '" + request.dataset + "' changed since the run was planned; start the experiment again");
  }
  record.dataset = describe(dataset);
  TriangleMesh mesh = mesh_and_measure(dataset, request, monitor, record, {.match_vertices = match_vertices});
  return to_world(std::move(mesh), dataset.surface->lattice());
}

}  // namespace

double peak_memory_mb() {
  // getrusage() would include the memory of the parent before exec.
  return peak_resident_bytes(getpid()) / 1e6;
}

DatasetRecord describe(const Dataset& dataset) {
  const Isosurface& surface = *dataset.surface;
  return {dataset.title,      dataset.source,         dataset.preparation,         surface.lattice(),
          surface.isovalue(), dataset.asked_isovalue, to_string(surface.inside()), to_string(surface.kernel())};
}

RunRecord begin_record(const RunRequest& request, int threads) {
  RunRecord record;
  record.request = request;
  record.started = utc_now();
  record.threads = threads;
  record.deterministic = is_deterministic(method(request.method), parameters_of(request));
  record.environment = environment();
  return record;
}

MeasuredAgain measured_now() {
  const Environment here = environment();
  return {utc_now(), here.commit, here.dirty};
}

TriangleMesh mesh_and_measure(const Dataset& dataset, const RunRequest& request, Monitor& monitor, RunRecord& record,
                              const Bounds& bounds) {
  MeshingTask task = task_of(dataset, request);
  TriangleMesh result;
  if (bounds.match_vertices) {
    result = mesh_matched(dataset, request, *bounds.match_vertices, bounds, monitor, record);
  } else {
    result = mesh(task, request, bounds, monitor);
    record.peak_memory_mb = std::max(peak_memory_mb(), monitor.program_memory_mb());
  }
  monitor.keep_artefacts(false);  // the sizing below is for the measurement
  const Monitor::Stage stage = monitor.stage("measure");
  std::shared_ptr<const SizingField> sizing;
  if (!is_empty(request.sizing)) {
    sizing = task.sizing_field(monitor);
    record.sizing = SizingRecord{sizing->uniform(), sizing->floor_length(), sizing->smallest(), sizing->largest()};
  }
  const MetricChoice choice = request.metrics_of_use ? MetricChoice::all : MetricChoice::usual;
  record.measurement = measure(result, {dataset.surface.get(), sizing.get(), dataset.topology.get()}, monitor, choice);
  return result;
}

CellResult run_cell(const RunRequest& request, std::optional<double> match_vertices,
                    const std::filesystem::path& folder, int threads, Monitor& monitor) {
  CellResult result{begin_record(request, threads), 1};
  RunRecord& record = result.record;
  try {
    monitor.keep_artefacts(request.artefacts);
    monitor.keep_files_in(folder);
    const TriangleMesh mesh = load_and_mesh(request, match_vertices, monitor, record);
    write_mesh(mesh, folder / "mesh.vtp");
    write_artefacts(monitor.artefacts(), record.dataset->lattice, folder);
    record.mesh_checksum = checksum(mesh);
    record.status = Status::ok;
    result.exit_code = 0;
  } catch (const Skipped& skipped) {
    record.status = Status::skipped;
    record.reason = skipped.what();
    result.exit_code = 0;
  } catch (const DataError& error) {
    record.reason = error.what();
    // After the data were loaded, a DataError is about the mesh.
    result.exit_code = record.dataset ? 1 : 3;
  } catch (const std::bad_alloc&) {
    record.status = Status::out_of_memory;
    record.reason = "an allocation failed";
  } catch (const std::exception& error) {
    record.reason = printable(error.what());  // a library may say more than one line
  }
  if (record.status != Status::ok) {
    record.measurement.reset();
    record.match.reset();
  }
  book(monitor, record);
  write_record(record, folder / "run.json");
  return result;
}

}  // namespace isobench
