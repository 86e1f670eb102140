// Measures the stored meshes of a results folder again, without meshing.
#pragma once

#include <filesystem>

#include "isobench/experiments/runner/progress.h"
#include "isobench/metrics/measurement.h"

namespace isobench {

struct RemeasureSummary {
  int measured = 0;
  int without_mesh = 0;  ///< there is nothing to measure because the run failed, timed out or was skipped
  int failed = 0;        ///< could not be measured and were kept; a line on the console says why
  int elsewhere = 0;     ///< another process is working on them
};

/// Measures every stored mesh of a results folder with the metrics of this program, against its dataset and with the
/// sizing of its run. The metrics of use, which take seconds, are measured where the run has them already or `choice`
/// is `all`; from then on the run has them. Replaces the figures, the histograms, the arrays in mesh.vtp and the note
/// on who measured; keeps the cost of making the mesh and where it was made. Runs of an older revision of the metrics
/// are renamed as the present revision names them, and the stored plan is changed in the same way.
///
/// Keeps a run as it is if its mesh is missing or does not match its record, or if its dataset has changed. Throws
/// DataError if `folder` is not a results folder.
RemeasureSummary remeasure(const std::filesystem::path& folder, MetricChoice choice, Console& console);

}  // namespace isobench
