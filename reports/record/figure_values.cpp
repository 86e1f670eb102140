#include "isobench/reports/record/figure_values.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

FigureDeclaration cost(const std::string& name, const std::string& unit, const std::string& definition) {
  return {.name = name, .unit = unit, .definition = definition, .better = Better::smaller, .column = cost_columns};
}

const CostDeclaration* find_cost(const std::string& name) {
  const auto& all = cost_declarations();
  const auto found =
      std::find_if(all.begin(), all.end(), [&name](const CostDeclaration& each) { return each.figure.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Throws with the nearest of all names, costs included.
std::size_t metric_figure(const std::string& name) {
  const std::vector<std::string>& names = figure_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw std::logic_error("no figure is called '" + name + "'" + suggestion(name, names));
  return figure_index(name);
}

}  // namespace

const std::vector<CostDeclaration>& cost_declarations() {
  static const std::vector<CostDeclaration> all = {
      {cost("seconds_prepare", "s", "Wall time of reading and preparing the volume."), &RunRecord::seconds_prepare},
      {cost("seconds_sizing", "s", "Wall time of the sizing field that the method asked for. 0 if it asked for none."),
       &RunRecord::seconds_sizing},
      {cost("seconds_method", "s", "Wall time of the method without its sizing field."), &RunRecord::seconds_method},
      {cost("seconds_total", "s",
            "Wall time of sizing and method together, from the prepared volume in memory to the finished mesh. Metrics "
            "and files do not count."),
       &RunRecord::seconds_total},
      {cost("peak_memory_mb", "MB",
            "Largest resident memory of the run's process, or of a program that it ran, up to the finished mesh. 1 MB "
            "is 1,000,000 bytes."),
       &RunRecord::peak_memory_mb}};
  return all;
}

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const FigureDeclaration& figure : declared_figures()) all.push_back(figure.name);
    for (const CostDeclaration& each : cost_declarations()) all.push_back(each.figure.name);
    return all;
  }();
  return names;
}

const FigureDeclaration& figure_declaration(const std::string& name) {
  const CostDeclaration* cost = find_cost(name);
  return cost == nullptr ? declared_figures()[metric_figure(name)] : cost->figure;
}

FigureOfRun figure_of(const std::string& name) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (const CostDeclaration* cost = find_cost(name)) {
    return [value = cost->value](const RunRecord& run) { return run.measurement ? run.*value : none; };
  }
  return [index = metric_figure(name)](const RunRecord& run) {
    return run.measurement ? run.measurement->number_at(index) : none;
  };
}

double figure_value(const RunRecord& record, const std::string& name) { return figure_of(name)(record); }

}  // namespace isobench
