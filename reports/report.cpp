#include "reports/report.h"

#include "reports/gnuplot.h"
#include "reports/latex.h"
#include "reports/plots.h"
#include "reports/results.h"
#include "reports/results_csv.h"
#include "reports/tables.h"

namespace isobench {

std::string write_report(const std::filesystem::path& folder) {
  const Results results = load_results(folder);
  std::string tables = markdown_tables(results);
  write_text(folder / "results.csv", results_csv(results.records));
  write_text(folder / "results.columns.md", columns_text());
  write_text(folder / "tables.md", tables);
  write_text(folder / "tables.tex", latex_tables(results));
  draw(all_plots(results), folder / "plots");
  return tables;
}

}  // namespace isobench
