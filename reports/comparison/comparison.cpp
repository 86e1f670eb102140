#include "isobench/reports/comparison/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "isobench/reports/record/json_values.h"

namespace isobench {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string leaf_text(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

double relative_difference(double a, double b) {
  const double scale = std::max(std::abs(a), std::abs(b));
  return scale == 0.0 ? 0.0 : std::abs(a - b) / scale;
}

using Leaves = std::map<std::string, Json>;

// A series of numbers (a trace, a histogram's counts) is one figure: a line for each value would not tell more.
bool is_leaf(const Json& json) {
  return !json.is_object() && !(json.is_array() && !json.empty() && json.front().is_array());
}

void flatten(const Json& json, const std::string& name, Leaves& leaves) {
  if (is_leaf(json)) {
    leaves[name] = json;
    return;
  }
  for (const auto& [key, value] : json.items())
    flatten(value, name.empty() ? key : fmt::format("{}/{}", name, key), leaves);
}

// Parts of a request that do not determine the result.
const std::vector<const char*> asked_besides = {"family",    "label",          "alone",         "aside",
                                                "artefacts", "metrics_of_use", "limit_minutes", "limit_memory_gb"};

// Figures have their bare names, as in results.csv. Most other names begin with a group: "counter particles/splits".
Leaves result_of(const Json& record) {
  Leaves leaves;
  for (const char* key : {"status", "reason", "deterministic"}) leaves[key] = record.at(key);
  if (record.contains("figures")) {
    for (const auto& [name, value] : record.at("figures").items()) leaves[name] = value;
  }
  static const std::map<std::string, std::string> groups = {{"dataset", "dataset"},  {"sizing", "sizing"},
                                                            {"counters", "counter"}, {"histograms", "histogram"},
                                                            {"traces", "trace"},     {"request", "request"}};
  for (const auto& [key, word] : groups) {
    Leaves inner;
    if (record.contains(key)) flatten(record.at(key), "", inner);
    for (const auto& [name, value] : inner) leaves[fmt::format("{} {}", word, name)] = value;
  }
  for (const char* key : asked_besides) leaves.erase("request " + std::string(key));
  leaves.erase("dataset source");  // says where the samples were found; the request has their checksum
  if (record.contains("mesh_checksum")) leaves["mesh_checksum"] = record.at("mesh_checksum");
  return leaves;
}

Leaves circumstances_of(const Json& record) {
  Leaves leaves;
  flatten(record.at("environment"), "", leaves);
  for (const char* key : asked_besides) {
    if (record.at("request").contains(key)) leaves[key] = record.at("request").at(key);
  }
  for (const char* key : {"threads", "notes", "started"}) leaves[key] = record.at(key);
  if (record.contains("dataset")) leaves["dataset source"] = record.at("dataset").at("source");
  return leaves;
}

Difference series_difference(const Json& a, const Json& b) {
  Difference difference{"", "", fmt::format("{} values", a.size()), fmt::format("{} values", b.size()), no_number};
  if (a.size() != b.size()) return difference;
  std::size_t count = 0;
  difference.relative = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (count++ == 0) {
      difference.a = fmt::format("[{}] {}", i, leaf_text(a[i]));
      difference.b = fmt::format("[{}] {}", i, leaf_text(b[i]));
    }
    const bool numbers = a[i].is_number() && b[i].is_number();
    // If not both are numbers, the difference is NaN and counts as the largest.
    const double here = numbers ? relative_difference(a[i].get<double>(), b[i].get<double>()) : no_number;
    if (std::isnan(here) || here > difference.relative) difference.relative = here;
    if (std::isnan(here)) break;
  }
  if (count > 1) difference.a += fmt::format(" and {} more of {}", count - 1, a.size());
  return difference;
}

// std::nullopt if the two are the same within the tolerance.
std::optional<Difference> difference_of(const Json& a, const Json& b, double tolerance) {
  if (a == b) return std::nullopt;
  Difference difference{"", "", leaf_text(a), leaf_text(b), no_number};
  if (a.is_array() && b.is_array()) difference = series_difference(a, b);
  if (a.is_number() && b.is_number()) difference.relative = relative_difference(a.get<double>(), b.get<double>());
  if (difference.relative <= tolerance) return std::nullopt;
  return difference;
}

// Calls visit(name, a, b) for every name of either side, with null for the side that does not have it.
template <class Visitor>
void visit_both(const Leaves& a, const Leaves& b, Visitor&& visit) {
  std::set<std::string> names;
  for (const auto& [name, value] : a) names.insert(name);
  for (const auto& [name, value] : b) names.insert(name);
  const auto value_in = [](const Leaves& leaves, const std::string& name) {
    const auto found = leaves.find(name);
    return found == leaves.end() ? Json(nullptr) : found->second;
  };
  for (const std::string& name : names) visit(name, value_in(a, name), value_in(b, name));
}

void note_circumstance(const std::string& what, const Json& a, const Json& b, Comparison& comparison) {
  if (a == b || what == "started" || what == "load") return;  // never the same twice
  const CircumstanceChange change{what, leaf_text(a), leaf_text(b), 1};
  for (CircumstanceChange& known : comparison.circumstances) {
    if (known.what == change.what && known.a == change.a && known.b == change.b) {
      ++known.runs;
      return;
    }
  }
  comparison.circumstances.push_back(change);
}

// Leaves out figures that a record does not know, because its program did not measure them yet, and the histograms of
// their metrics. If one side has no figures at all, its status differs, and nothing is left out.
void leave_out_unknown(const RunRecord& a, const RunRecord& b, Leaves& leaves_a, Leaves& leaves_b,
                       Comparison& comparison) {
  if (!a.measurement || !b.measurement) return;
  const auto leave_out = [&](const std::string& name) {
    leaves_a.erase(name);
    leaves_b.erase(name);
  };
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const bool known_in_a = a.measurement->is_known(n);
    const bool known_in_b = b.measurement->is_known(n);
    if (known_in_a && known_in_b) continue;
    leave_out(declared_figures()[n].name);
    if (!known_in_a && known_in_b) comparison.unknown_in_a.insert(declared_figures()[n].name);
    if (known_in_a && !known_in_b) comparison.unknown_in_b.insert(declared_figures()[n].name);
    for (const HistogramDeclaration& histogram : metric_of_figure(n).histograms) {
      for (const char* part : {"low", "high", "counts"})
        leave_out(fmt::format("histogram {}/{}", histogram.name, part));
    }
  }
}

// A figure that is declared Compared::exactly has no tolerance.
double tolerance_for(const std::string& name, double tolerance) {
  const auto& all = declared_figures();
  const auto found =
      std::find_if(all.begin(), all.end(), [&name](const FigureDeclaration& figure) { return figure.name == name; });
  return found != all.end() && found->compared == Compared::exactly ? 0.0 : tolerance;
}

void compare_records(const RunRecord& a, const RunRecord& b, double tolerance, Comparison& comparison) {
  const Json json_a = Json::parse(to_json(a));
  const Json json_b = Json::parse(to_json(b));
  const std::size_t before = comparison.differences.size();
  Leaves leaves_a = result_of(json_a);
  Leaves leaves_b = result_of(json_b);
  leave_out_unknown(a, b, leaves_a, leaves_b, comparison);
  visit_both(leaves_a, leaves_b, [&](const std::string& name, const Json& in_a, const Json& in_b) {
    // Old records have no checksum; where there is no mesh, the status says so.
    if (name == "mesh_checksum" && (in_a.is_null() || in_b.is_null())) return;
    std::optional<Difference> difference = difference_of(in_a, in_b, tolerance_for(name, tolerance));
    if (!difference) return;
    difference->run = a.request.run;
    difference->figure = name;
    comparison.differences.push_back(std::move(*difference));
  });
  if (comparison.differences.size() > before && !(a.deterministic && b.deterministic)) {
    comparison.not_deterministic.push_back(a.request.run);
  }
  visit_both(circumstances_of(json_a), circumstances_of(json_b),
             [&](const std::string& name, const Json& in_a, const Json& in_b) {
               note_circumstance(name, in_a, in_b, comparison);
             });
  comparison.costs.push_back({a.request.run, a.seconds_total, b.seconds_total, a.peak_memory_mb, b.peak_memory_mb});
  ++comparison.matched;
}

using ByName = std::map<std::string, const RunRecord*>;

ByName by_name(const Results& results) {
  ByName records;
  for (const RunRecord& record : results.records) records[record.request.run] = &record;
  return records;
}

bool plans(const Results& results, const std::string& run) {
  return std::any_of(results.missing.begin(), results.missing.end(),
                     [&run](const RunRequest& request) { return request.run == run; });
}

// A run's name without the hash at its end. Runs whose names differ only there are counterparts that differ in other
// parts of the request, such as the revision of the method.
std::string stem(const std::string& run) { return run.substr(0, run.rfind('-')); }

std::string request_changes(const RunRequest& a, const RunRequest& b) {
  Leaves in_a;
  Leaves in_b;
  flatten(request_to_json(a), "", in_a);
  flatten(request_to_json(b), "", in_b);
  std::string text;
  visit_both(in_a, in_b, [&text](const std::string& name, const Json& left, const Json& right) {
    if (left == right || name == "run") return;
    text += fmt::format("{}{}: {} and {}", text.empty() ? "" : "; ", name, leaf_text(left), leaf_text(right));
  });
  return text;
}

// Why a run has no counterpart in `there`. `swapped` is true if the run belongs to B, because sentences give the values
// of A first.
std::string reason_for(const RunRequest& request, const Results& there, bool swapped) {
  const auto changes = [&](const RunRequest& other) {
    return swapped ? request_changes(other, request) : request_changes(request, other);
  };
  for (const RunRecord& other : there.records) {
    if (stem(other.request.run) != stem(request.run)) continue;
    return other.request.run + " is there instead; they differ in " + changes(other.request);
  }
  for (const RunRequest& other : there.missing) {
    if (other.run == request.run) return "not done there";
    if (stem(other.run) != stem(request.run)) continue;
    return other.run + " is planned there instead, but not done; they differ in " + changes(other);
  }
  return "not planned there";
}

std::vector<Unmatched> unmatched(const Results& here, const Results& there, bool swapped) {
  const ByName theirs = by_name(there);
  std::vector<Unmatched> only;
  for (const RunRecord& record : here.records) {
    if (theirs.contains(record.request.run)) continue;
    only.push_back({record.request.run, reason_for(record.request, there, swapped)});
  }
  return only;
}

}  // namespace

Comparison compare(const Results& a, const Results& b, double tolerance) {
  Comparison comparison;
  comparison.name_a = a.name;
  comparison.name_b = b.name;
  const ByName theirs = by_name(b);
  for (const RunRecord& record : a.records) {
    const auto other = theirs.find(record.request.run);
    if (other != theirs.end()) compare_records(record, *other->second, tolerance, comparison);
  }
  comparison.only_a = unmatched(a, b, false);
  comparison.only_b = unmatched(b, a, true);
  for (const RunRequest& request : a.missing) comparison.undone += plans(b, request.run) ? 1 : 0;
  comparison.unreadable = a.unreadable;
  comparison.unreadable.insert(comparison.unreadable.end(), b.unreadable.begin(), b.unreadable.end());
  return comparison;
}

}  // namespace isobench
