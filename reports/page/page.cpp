#include "isobench/reports/page/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page_files.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

// Folds all of a section but its heading.
std::string folded(std::string section, const std::string& summary) {
  static const std::string heading_end = "</h2>\n";
  const std::size_t start = section.find(heading_end);
  if (start == std::string::npos) return section;
  section.insert(section.rfind("</section>"), "</details>\n");
  section.insert(start + heading_end.size(), "<details><summary>" + html_escaped(summary) + "</summary>\n");
  return section;
}

// Leaves out the plots that the page already shows among the figures of the publication.
std::string plots_html(const Exhibits& exhibits, bool many, const std::filesystem::path& folder) {
  std::string text;
  for (const Plot& plot : exhibits.plots) {
    const bool shown = std::find(exhibits.shown.begin(), exhibits.shown.end(), plot.name) != exhibits.shown.end();
    if (!shown && drawn(exhibits, plot)) text += plot_html(plot, folder);
  }
  if (text.empty()) return "";
  const char* see_above = exhibits.shown.empty() ? ""
                                                 : "<p class=\"remark\">More plots are above, among the figures "
                                                   "of the publication.</p>\n";
  const char* over_all = many
                             ? "<p class=\"remark\">There are too many data sets for plots of single ones. These plots "
                               "are over all of them.</p>\n"
                             : "";
  return std::string("<section id=\"plots\"><h2>Plots</h2>\n") + see_above + over_all + "<div class=\"figures\">\n" +
         text + "</div></section>\n";
}

std::string pictures_html(const std::vector<Picture>& pictures, const std::filesystem::path& folder) {
  std::string text;
  std::string group;
  for (const Picture& picture : pictures) {
    if (!picture.explanation.empty()) continue;  // shown by fields_html()
    if (picture.group != group) {
      text += (group.empty() ? "" : "</div>\n") + ("<h3>" + html_escaped(picture.group)) +
              "</h3>\n<div class=\"figures pictures\">\n";
      group = picture.group;
    }
    text += picture_html(picture, folder);
  }
  return text.empty() ? "" : "<section id=\"pictures\"><h2>Pictures</h2>\n" + text + "</div></section>\n";
}

std::string tables_html(const Results& results) {
  std::string text;
  for (const Table& table : all_tables(results)) {
    if (!table.detail) text += html(table);
  }
  if (text.empty()) return "";
  return "<section id=\"tables\"><h2>Tables</h2>\n" + text +
         "<p class=\"remark\">† The mesh is not a closed manifold. It counts in medians only if no mesh of the same "
         "cell is a closed manifold. ‡ The mesh does not have the number of vertices that it should be matched to."
         "</p>\n"
         "<p class=\"remark\">All figures without rounding: <a href=\"results.csv\">results.csv</a> "
         "(<a href=\"results.columns.md\">definitions of its columns</a>). For LaTeX: "
         "<a href=\"tables.tex\">tables.tex</a>.</p>\n</section>\n";
}

std::string banner(const Results& results, const Exhibits& exhibits) {
  std::string text;
  if (!results.missing.empty()) {
    text += fmt::format(
        "<p class=\"notice\">Half-finished: {} of {} runs are not done yet. This page shows the others. Call the same "
        "<code>isobench run</code> again to continue.</p>\n",
        results.missing.size(), results.missing.size() + results.records.size());
  }
  for (const std::string& sentence : exhibits.missing) text += "<p class=\"notice\">" + html_prose(sentence) + "</p>\n";
  return text;
}

std::string body_of_few(const Results& results, Exhibits& exhibits, const std::filesystem::path& folder) {
  std::string body = summary_html(results) + gaps_html(results) + claims_html(results);
  body += plates_html(results, exhibits, folder);
  return body + fields_html(exhibits, folder) + turnable_html(exhibits, folder) + tables_html(results) +
         plots_html(exhibits, false, folder) + pictures_html(exhibits.pictures, folder) + provenance_html(results) +
         citations_html(results);
}

// The overview first; what concerns single data sets is folded.
std::string body_of_many(const Results& results, Exhibits& exhibits, const std::filesystem::path& folder) {
  const std::string plates = plates_html(results, exhibits, folder);
  // Close-ups and worst triangles stand above; shown twice they would double the page.
  std::vector<Picture> others = exhibits.pictures;
  std::erase_if(others, [](const Picture& picture) {
    return !picture.grid && (picture.shot == shots::closer || picture.shot == shots::worst);
  });
  return summary_html(results) + plots_html(exhibits, true, folder) + tables_html(results) +
         worst_html(results, exhibits, folder) + claims_html(results) + plates +
         folded(gaps_html(results), "Runs without a mesh") +
         folded(fields_html(exhibits, folder), "Pictures of simulations") + turnable_html(exhibits, folder) +
         folded(pictures_html(others, folder), "Whole meshes") + folded(details_html(results), "Tables of data sets") +
         folded(provenance_html(results), "Runs") + folded(citations_html(results), "Program and data");
}

// Links to the sections that exist.
std::string navigation(const std::string& body) {
  static const std::vector<std::pair<const char*, const char*>> sections = {{"summary", "Summary"},
                                                                            {"worst", "Worst cases"},
                                                                            {"gaps", "Failed or not done"},
                                                                            {"claims", "Published claims"},
                                                                            {"figures", "Figures of the paper"},
                                                                            {"fields", "Simulations"},
                                                                            {"turn", "3D"},
                                                                            {"tables", "Tables"},
                                                                            {"plots", "Plots"},
                                                                            {"pictures", "Pictures"},
                                                                            {"details", "Each data set"},
                                                                            {"runs", "How runs were made"},
                                                                            {"cite", "How to cite"}};
  std::string text = "<nav>";
  for (const auto& [id, title] : sections) {
    if (body.find(fmt::format("<section id=\"{}\"", id)) == std::string::npos) continue;
    text += fmt::format("<a href=\"#{}\">{}</a> ", id, title);
  }
  return text + "</nav>\n";
}

}  // namespace

bool drawn(const Exhibits& exhibits, const Plot& plot) {
  return std::find(exhibits.drawn.begin(), exhibits.drawn.end(), plot.name) != exhibits.drawn.end();
}

std::string plot_html(const Plot& plot, const std::filesystem::path& folder) {
  const std::string svg = read_text(folder / "plots" / (plot.name + ".svg"));
  return fmt::format(
      "<figure><img loading=\"lazy\" src=\"{}\" alt=\"{}\"><figcaption>{} "
      "<a href=\"plots/{}.svg\">SVG</a></figcaption></figure>\n",
      data_uri("image/svg+xml", svg), html_escaped(plot.title), html_escaped(plot.caption), plot.name);
}

std::string figure_html(const Picture& picture, const std::string& description, const std::string& caption,
                        const std::filesystem::path& folder) {
  return fmt::format(
      "<figure><img loading=\"lazy\" src=\"{}\" alt=\"{}\"><figcaption>{} <a "
      "href=\"{}\">PNG</a></figcaption></figure>\n",
      data_uri("image/jpeg", read_text(folder / picture.preview)), html_escaped(description), caption,
      html_escaped(picture.file));
}

std::string picture_html(const Picture& picture, const std::filesystem::path& folder) {
  return figure_html(picture, picture.group + ": " + picture.title,
                     "<b>" + html_escaped(picture.title) + "</b> " + html_escaped(picture.caption), folder);
}

std::string page(const Results& results, Exhibits exhibits, const std::filesystem::path& folder) {
  const std::string body = has_many_datasets(arrange_runs(results)) ? body_of_many(results, exhibits, folder)
                                                                    : body_of_few(results, exhibits, folder);
  const std::string title = html_escaped(results.title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         title + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n" + page_style +
         "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n" + opening_html(results, exhibits, folder) +
         banner(results, exhibits) + navigation(body) + body + "<script>\n" + page_script + view_3d_script +
         "</script>\n</body>\n</html>\n";
}

}  // namespace isobench
