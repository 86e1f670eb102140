// How each run was made, behind a fold.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/runs/run_grid.h"

namespace isobench {

namespace {

std::string value_text(const ParameterValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

class Facts {
 public:
  void add(const std::string& name, const std::string& value) {
    if (value.empty()) return;
    text_ += "<tr><th scope=\"row\">" + html_escaped(name) + "</th><td>" + html_escaped(value) + "</td></tr>\n";
  }
  std::string html() const {
    return "<div class=\"wide\"><table class=\"facts\"><tbody>\n" + text_ + "</tbody></table></div>\n";
  }

 private:
  std::string text_;
};

void add_request(const RunRequest& request, Facts& facts) {
  facts.add("method", fmt::format("{}, revision {}", request.method, request.method_revision));
  std::string parameters;
  for (const auto& [name, value] : *request.parameters) {
    parameters += fmt::format("{}{} = {}", parameters.empty() ? "" : ", ", name, value_text(value));
  }
  facts.add("parameters", parameters);
  facts.add("requested sizing", sizing_name(request.sizing));
  facts.add("matched to", request.match_to);
  facts.add("seed", fmt::format("{}", request.seed));
  if (request.limit_minutes) facts.add("time limit", fmt::format("{} minutes", *request.limit_minutes));
  if (request.limit_memory_gb) facts.add("memory limit", fmt::format("{} GB", *request.limit_memory_gb));
  facts.add("data checksum", request.dataset_checksum);
}

void add_dataset(const DatasetRecord& dataset, Facts& facts) {
  const auto& size = dataset.lattice.size;
  const Eigen::Vector3d& spacing = dataset.lattice.spacing;
  facts.add("data", dataset.title);
  facts.add("source of the data", dataset.source);
  facts.add("lattice", fmt::format("{} × {} × {}, {} × {} × {} mm", size[0], size[1], size[2], spacing.x(), spacing.y(),
                                   spacing.z()));
  facts.add("preparation", fmt::format("{}", fmt::join(dataset.preparation, "; ")));
  const std::string asked =
      dataset.asked_isovalue ? fmt::format(" (asked for {}, which is no regular value)", *dataset.asked_isovalue) : "";
  facts.add("surface", fmt::format("F = {}{}, inside {}, {}", dataset.isovalue, asked, dataset.inside, dataset.kernel));
}

void add_environment(const RunRecord& record, Facts& facts) {
  const Environment& here = record.environment;
  facts.add("started", record.started);
  facts.add("program", fmt::format("isobench {}, commit {}{}", here.version, here.commit,
                                   here.dirty ? ", with local changes" : ""));
  facts.add("built by", here.compiler + ", " + here.build_type);
  std::string libraries;
  for (const auto& [name, version] : *here.libraries)
    libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, version);
  facts.add("libraries", libraries);
  facts.add("machine", fmt::format("{} ({}), {} cores, {} threads, load {:.2f}", here.host, here.cpu, here.cores,
                                   record.threads, here.load));
  if (record.measured_again) {
    facts.add("measured again", record.measured_again->when + ", commit " + record.measured_again->commit);
  }
}

void add_outcome(const RunRecord& record, Facts& facts) {
  facts.add("state", to_string(record.status) + (record.reason.empty() ? "" : ": " + record.reason));
  facts.add("same mesh for the same seed", record.deterministic ? "promised" : "not promised");
  if (record.sizing) {
    facts.add("sizing field", fmt::format("{:.4g} to {:.4g} mm, floor {:.4g} mm", record.sizing->smallest,
                                          record.sizing->largest, record.sizing->floor));
  }
  facts.add("mesh checksum", record.mesh_checksum);
  std::string stages;
  for (const StageTime& stage : record.stages) {
    stages += fmt::format("{}{} {:.3g} s ({:.3g} s CPU)", stages.empty() ? "" : ", ", stage.name, stage.wall_seconds,
                          stage.cpu_seconds);
  }
  facts.add("stages", stages);
  std::string counters;
  for (const auto& [name, value] : record.counters) {
    counters += fmt::format("{}{} {}", counters.empty() ? "" : ", ", name, value);
  }
  facts.add("counters", counters);
  for (const std::string& note : record.notes) facts.add("note", note);
}

std::string run_html(const RunRecord& record) {
  Facts facts;
  add_outcome(record, facts);
  add_request(record.request, facts);
  if (record.dataset) add_dataset(*record.dataset, facts);
  add_environment(record, facts);
  const std::string run = html_escaped(record.request.run);
  std::string files = fmt::format("<a href=\"{0}/run.json\">run.json</a>, <a href=\"{0}/log.txt\">log.txt</a>", run);
  if (record.status == Status::ok) files = fmt::format("<a href=\"{}/mesh.vtp\">mesh.vtp</a>, ", run) + files;
  return fmt::format("<details class=\"run\"><summary>{}: {}</summary>\n<p>Files beside this page: {}</p>\n", run,
                     to_string(record.status), files) +
         facts.html() + "</details>\n";
}

// Nobody reads more folds or links, and results.csv and each run.json hold the same.
constexpr std::size_t most_folds = 200;
constexpr std::size_t most_links = 2000;

std::string others_html(const Results& results) {
  const std::size_t others = results.records.size() - most_folds;
  if (others > most_links) {
    return fmt::format(
        "<p>{} further runs are too many to be listed here. <a href=\"results.csv\">results.csv</a> has a row for each "
        "run, and the run.json in its folder says how it was made.</p>\n",
        others);
  }
  std::string text;
  for (std::size_t n = most_folds; n < results.records.size(); ++n) {
    const RunRecord& record = results.records[n];
    const std::string run = html_escaped(record.request.run);
    text += fmt::format("<li><a href=\"{0}/run.json\">{0}</a> {1}</li>\n", run, to_string(record.status));
  }
  return fmt::format("<details><summary>{} further runs, each with its run.json</summary>\n<ul>\n{}</ul></details>\n",
                     others, text);
}

}  // namespace

std::string provenance_html(const Results& results) {
  if (results.records.empty()) return "";
  std::string text = "<section id=\"runs\"><h2>How each run was made</h2>\n";
  const std::size_t folds = std::min(most_folds, results.records.size());
  for (std::size_t n = 0; n < folds; ++n) text += run_html(results.records[n]);
  if (folds < results.records.size()) text += others_html(results);
  return text + "</section>\n";
}

}  // namespace isobench
