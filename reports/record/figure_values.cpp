#include "isobench/reports/record/figure_values.h"

#include <limits>
#include <map>

#include "isobench/reports/record/figures.h"

namespace isobench {

namespace {

using Cost = double RunRecord::*;

const std::vector<std::pair<std::string, Cost>>& costs() {
  static const std::vector<std::pair<std::string, Cost>> all = {{"seconds_prepare", &RunRecord::seconds_prepare},
                                                                {"seconds_sizing", &RunRecord::seconds_sizing},
                                                                {"seconds_method", &RunRecord::seconds_method},
                                                                {"seconds_total", &RunRecord::seconds_total},
                                                                {"peak_memory_mb", &RunRecord::peak_memory_mb}};
  return all;
}

}  // namespace

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    const Measurement measurement;
    visit_figures(measurement, [&all](const char* name, const auto&) { all.emplace_back(name); });
    for (const auto& [name, cost] : costs()) all.push_back(name);
    return all;
  }();
  return names;
}

double figure_value(const RunRecord& record, const std::string& name) {
  double found = std::numeric_limits<double>::quiet_NaN();
  if (!record.measurement) return found;
  visit_figures(*record.measurement, [&](const char* figure, const auto& value) {
    if (name == figure) found = static_cast<double>(value);
  });
  for (const auto& [cost_name, cost] : costs()) {
    if (name == cost_name) found = record.*cost;
  }
  return found;
}

}  // namespace isobench
