// One run: a dataset meshed by a method and measured.
#pragma once

#include <filesystem>
#include <optional>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// Peak memory of this process so far, MB (10⁶ bytes).
double peak_memory_mb();

/// Meshes a loaded dataset as the request says (stages "mesh" and "measure" of the monitor), fills in the record's
/// sizing, measurement, seconds and peak memory, and gives the mesh, in the lattice frame and with its data arrays.
/// The record's seconds_prepare and stages are set from the monitor. Throws what the method and the metrics throw.
///
/// With `match_vertices` the method's sizing is scaled until its mesh has about so many (VertexMatch), and the nearest
/// mesh is kept; it is measured against the sizing as it was asked for.
TriangleMesh mesh_and_measure(const Dataset& dataset, const RunRequest& request, Monitor& monitor, RunRecord& record,
                              std::optional<double> match_vertices = std::nullopt);

/// What a record says of a loaded dataset.
DatasetRecord describe(const Dataset& dataset);

/// A record with everything in it that is known before a run: request, environment, time, threads.
RunRecord begin_record(const RunRequest& request, int threads);

/// Who measures a stored mesh again: this program, now.
MeasuredAgain measured_now();

/// How a run ended.
struct CellResult {
  RunRecord record;
  int exit_code = 0;  ///< 0 recorded as ok or skipped, 1 failed, 3 failed for want of usable data
};

/// The whole run of a planned cell: writes run.json and, if it came to one, mesh.vtp (world coordinates) into `folder`,
/// beside it the artefacts that were asked for. Errors become the record's status and reason. `match_vertices` is given
/// exactly where the request has match_to.
CellResult run_cell(const RunRequest& request, std::optional<double> match_vertices,
                    const std::filesystem::path& folder, int threads, Monitor& monitor);

}  // namespace isobench
