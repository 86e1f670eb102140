// Measuring the meshes of a results folder again, without meshing again.
#pragma once

#include <filesystem>

#include "isobench/experiments/runner/progress.h"

namespace isobench {

struct RemeasureSummary {
  int measured = 0;
  int without_mesh = 0;  ///< failed, timed out or skipped: nothing to measure
  int failed = 0;        ///< kept as they were, each with a line that says why
  int elsewhere = 0;     ///< another process is at them
};

/// Reads every stored mesh of a results folder again and measures it against its dataset, at its own sizing and
/// reference k, by the metrics of this program. Each run's folder is replaced as a whole: figures, histograms, the
/// arrays in mesh.vtp, and who measured; what making the mesh took and where it was made stays. Runs of an earlier
/// metrics revision move to the name that this revision's plan has for them, and so does the stored plan.
///
/// A run is left as it was where its mesh is missing or is not the one that its record is of, or where its dataset is
/// no longer the same. Throws DataError where `folder` is no results folder.
RemeasureSummary remeasure(const std::filesystem::path& folder, Console& console);

}  // namespace isobench
