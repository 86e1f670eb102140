// A run's figures by name: what the metrics measured and what the run cost.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "isobench/metrics/metric.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// What a run costs, declared as the metrics declare their figures.
struct CostDeclaration {
  FigureDeclaration figure;
  double RunRecord::*value;
};
const std::vector<CostDeclaration>& cost_declarations();

/// Every figure of the metrics, then seconds_… and peak_memory_mb, as results.csv and run.json call them.
const std::vector<std::string>& figure_names();

/// The declaration of one of figure_names(). Throws std::logic_error, with the nearest name, for any other.
const FigureDeclaration& figure_declaration(const std::string& name);

/// The value of a figure in a run. NaN where the run has no figures, or this one was not measured.
using FigureOfRun = std::function<double(const RunRecord&)>;
/// `name` is one of figure_names(); throws std::logic_error for any other. The name is looked up once.
FigureOfRun figure_of(const std::string& name);
double figure_value(const RunRecord& record, const std::string& name);

}  // namespace isobench
