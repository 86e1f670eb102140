#include "isobench/reports/report.h"

#include <fmt/format.h>

#include <iterator>

#include "isobench/reports/csv/results_csv.h"
#include "isobench/reports/latex/latex.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/pictures/pictures.h"
#include "isobench/reports/plots/gnuplot.h"
#include "isobench/reports/plots/plots.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/tables.h"
#include "isobench/reports/tables_document.h"

namespace isobench {

namespace {

// Nobody looks at more plots, and each takes a tenth of a second.
constexpr std::size_t most_plots = 120;

// Makes the plots and pictures that are not there yet.
Exhibits exhibits_of(const Results& results, const std::filesystem::path& folder) {
  Exhibits exhibits;
  Pictures pictures = make_pictures(results, folder);
  exhibits.pictures = std::move(pictures.pictures);
  exhibits.turnable = std::move(pictures.turnable);
  exhibits.across = pictures.across;
  exhibits.plots = all_plots(results, pictures.edges_over_h);
  if (exhibits.plots.size() > most_plots) {
    exhibits.missing.push_back(
        fmt::format("Only the first {1} of {0} plots are drawn.", exhibits.plots.size(), most_plots));
    exhibits.plots.resize(most_plots);
  }
  Drawn drawn = draw(exhibits.plots, folder / "plots");
  exhibits.drawn = std::move(drawn.names);
  if (!drawn.missing.empty()) exhibits.missing.push_back(std::move(drawn.missing));
  std::move(pictures.missing.begin(), pictures.missing.end(), std::back_inserter(exhibits.missing));
  return exhibits;
}

}  // namespace

Report write_report(const std::filesystem::path& folder, ReportParts parts) {
  const Results results = load_results(folder);
  Report report;
  const std::string tables = markdown_tables(results);
  report.tables = has_many_datasets(arrange_runs(results)) ? markdown_tables(results, DatasetTables::left_out) : tables;
  write_text(folder / "results.csv", [&results](std::ostream& file) { write_results_csv(file, results.records); });
  write_text(folder / "results.columns.md", columns_text());
  write_text(folder / "tables.md", tables);
  write_text(folder / "tables.tex", latex_tables(results));
  report.written = {"tables.md", "tables.tex", "results.csv"};
  if (parts == ReportParts::tables) return report;
  const Exhibits exhibits = exhibits_of(results, folder);
  write_text(folder / "report.html", page(results, exhibits, folder));
  report.written.emplace_back("report.html");
  report.missing = exhibits.missing;
  return report;
}

}  // namespace isobench
