// A run's figures by name, for what asks for them by name: claims and macros.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// Every figure of a measurement, then seconds_… and peak_memory_mb, as results.csv and run.json call them.
const std::vector<std::string>& figure_names();

/// The value of a figure in a run that is ok; NaN where the run has no figures. `name` is one of figure_names().
double figure_value(const RunRecord& record, const std::string& name);

}  // namespace isobench
