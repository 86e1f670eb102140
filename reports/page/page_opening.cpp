// What the page opens with, and the worst cases and tables of experiments with many data sets.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/runs/refinement.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/survey/survey.h"
#include "isobench/reports/tables/best_methods.h"
#include "isobench/reports/tables/survey_tables.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

constexpr std::size_t most_close_ups = 12;
constexpr std::size_t most_detail_rows = 300;  // of each table; nobody scrolls further, and tables.md has all

std::string lead(const std::string& sentence) {
  return sentence.empty() ? "" : "<p class=\"lead\">" + html_escaped(sentence) + "</p>\n";
}

// "particles: smallest radius ratio 0.861 (brain), …": there is nobody to compare a single method with.
std::string single_method_line(const RunGrid& runs) {
  if (runs.variants.size() != 1) return "";
  std::vector<std::string> parts;
  for (const char* id : {"radius-ratio-min", "angle-min", "angle-max"}) {
    const Criterion& criterion = quality_criterion(id);
    const WorstCase worst = worst_case(runs, runs.variants.front(), criterion);
    if (worst.run == nullptr) continue;
    parts.push_back(fmt::format("{} {}{} ({})", criterion.name, criterion.print(worst.value), criterion.unit,
                                worst.run->request.dataset));
  }
  if (parts.empty()) return "";
  return fmt::format("Worst of all meshes of {}: {}.", runs.variants.front().name, fmt::join(parts, ", "));
}

const Picture* find_picture(const Exhibits& exhibits, const RunRecord& run, const std::string& shot) {
  const auto found = std::find_if(exhibits.pictures.begin(), exhibits.pictures.end(), [&](const Picture& picture) {
    return !picture.grid && picture.run == run.request.run && picture.shot == shot;
  });
  return found == exhibits.pictures.end() ? nullptr : &*found;
}

// "1234 triangles, smallest radius ratio 0.861, angles 38.1–87.0°". Precondition: the run has a mesh.
std::string mesh_words(const RunRecord& run) {
  const auto printed = [&run](const char* id) {
    const Criterion& criterion = quality_criterion(id);
    return criterion.print(criterion.value(run));
  };
  return fmt::format("{} triangles, smallest radius ratio {}, angles {}–{}°{}", run.measurement->number("triangles"),
                     printed("radius-ratio-min"), printed("angle-min"), printed("angle-max"),
                     is_closed_manifold(run) ? "" : ", not a closed manifold");
}

// The data set to open with or, if there is no picture of it because others came first, the first that has one.
std::string pictured_dataset(const RunGrid& runs, const Exhibits& exhibits) {
  std::string first;
  std::string wanted = opening_dataset(runs);
  for (const Picture& picture : exhibits.pictures) {
    if (picture.grid || picture.shot != shots::closer) continue;
    if (picture.dataset == wanted) return wanted;
    if (first.empty()) first = picture.dataset;
  }
  return first;
}

std::string close_ups(const RunGrid& runs, const Exhibits& exhibits, const std::filesystem::path& folder) {
  const std::string dataset = pictured_dataset(runs, exhibits);
  std::string figures;
  std::size_t shown = 0;
  std::size_t more = 0;
  for (const Variant& variant : runs.variants) {
    const RunRecord* run = find_run(variant, dataset);
    if (run == nullptr || !run->measurement) continue;
    const Picture* picture = find_picture(exhibits, *run, shots::closer);
    if (picture == nullptr) continue;
    if (shown == most_close_ups) {
      ++more;
      continue;
    }
    ++shown;
    figures += figure_html(*picture, "Close-up of " + variant.name + " on " + dataset,
                           "<b>" + html_escaped(variant.name) + "</b> " + html_escaped(mesh_words(*run)), folder);
  }
  if (figures.empty()) return "";
  const std::string others = more == 0 ? "" : fmt::format(" {} more are among the pictures below.", more);
  return "<p class=\"remark\">The same place on " + html_escaped(dataset) +
         ", method by method. Colours show the radius ratio of the triangles: dark is bad." + others +
         "</p>\n<div class=\"figures glance\">\n" + figures + "</div>\n";
}

Table cut_short(Table table) {
  if (table.rows.size() <= most_detail_rows) return table;
  table.remarks.insert(table.remarks.begin(),
                       fmt::format("The first {} of {} rows. All are in tables.md, and unrounded in results.csv.",
                                   most_detail_rows, table.rows.size()));
  table.rows.resize(most_detail_rows);
  return table;
}

}  // namespace

std::string opening_html(const Results& results, const Exhibits& exhibits, const std::filesystem::path& folder) {
  const RunGrid runs = arrange_runs(results);
  std::string text = lead(best_line(runs)) + lead(single_method_line(runs));
  if (has_many_datasets(runs)) text += lead(sound_sentence(runs));
  text += close_ups(finest_runs(runs), exhibits, folder);
  return text.empty() ? "" : "<section id=\"opening\">\n" + text + "</section>\n";
}

std::string worst_html(const Results& results, const Exhibits& exhibits, const std::filesystem::path& folder) {
  const RunGrid runs = arrange_runs(results);
  const Criterion& criterion = quality_criterion("radius-ratio-min");
  std::string figures;
  for (const Variant* method : surveyed(runs)) {
    const WorstCase worst = worst_case(runs, *method, criterion);
    if (worst.run == nullptr) continue;
    const std::string& dataset = worst.run->request.dataset;
    const Picture* picture = find_picture(exhibits, *worst.run, shots::worst);
    if (picture == nullptr) continue;
    figures += figure_html(*picture, "Worst triangle of " + method->name,
                           fmt::format("<b>{}</b> {}: radius ratio {}", html_escaped(method->name),
                                       html_escaped(dataset), criterion.print(worst.value)),
                           folder);
  }
  if (figures.empty()) return "";
  return "<section id=\"worst\"><h2>The worst triangle of each method</h2>\n<p class=\"remark\">Over all data sets. "
         "The "
         "triangle has a red outline. The tables name the worst cases of the other figures.</p>\n"
         "<div class=\"figures pictures\">\n" +
         figures + "</div></section>\n";
}

std::string details_html(const Results& results) {
  std::string text;
  for (const Table& table : all_tables(results)) {
    if (table.detail) text += html(cut_short(table));
  }
  return text.empty() ? "" : "<section id=\"details\"><h2>Each data set</h2>\n" + text + "</section>\n";
}

}  // namespace isobench
