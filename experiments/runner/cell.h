// One run: a dataset meshed by a method and measured.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// Peak memory of this process so far, MB (10⁶ bytes).
double peak_memory_mb();

/// How many vertices a mesh shall and may have.
struct Bounds {
  /// Scales the sizing of the method until the mesh has about this number of vertices (VertexMatch) and keeps the mesh
  /// that comes nearest. That mesh is measured against the sizing of the request, not the scaled one.
  std::optional<double> match_vertices = std::nullopt;
  std::optional<double> most_vertices = std::nullopt;              ///< more are refused before the work
  std::function<void(const std::string& expected)> announce = {};  ///< called with what the mesh is expected to cost
};

/// Meshes and measures a loaded dataset as requested (stages "mesh" and "measure"). Writes sizing, measurement and peak
/// memory into the record. Returns the mesh in the lattice frame, with its data arrays. Throws what the method and the
/// metrics throw, and UsageError for a mesh that would be too large (estimate.h).
TriangleMesh mesh_and_measure(const Dataset& dataset, const RunRequest& request, Monitor& monitor, RunRecord& record,
                              const Bounds& bounds = {});

/// The part of a record that describes a loaded dataset.
DatasetRecord describe(const Dataset& dataset);

/// A record with everything that is known before a run: request, environment, time and threads.
RunRecord begin_record(const RunRequest& request, int threads);

/// The note in a record that this program has just measured its mesh again.
MeasuredAgain measured_now();

/// How a run ended.
struct CellResult {
  RunRecord record;
  int exit_code = 0;  ///< 0: ok or skipped, 1: failed, 3: failed because the data are unusable
};

/// Does the whole run of a planned cell. Writes run.json into `folder`, and mesh.vtp (world coordinates) and the
/// requested artefacts if there is a mesh. Errors become status and reason of the record. `match_vertices` must be
/// given if and only if the request has match_to.
CellResult run_cell(const RunRequest& request, std::optional<double> match_vertices,
                    const std::filesystem::path& folder, int threads, Monitor& monitor);

}  // namespace isobench
