// tables.tex as a whole, and its macros.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "isobench/reports/claims/claims.h"
#include "isobench/reports/latex/latex.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

// Spells out characters that may distinguish two names but that TeX does not allow in names.
std::string spelled(const std::string& text) {
  static const std::array<const char*, 10> digits = {"Zero", "One", "Two",   "Three", "Four",
                                                     "Five", "Six", "Seven", "Eight", "Nine"};
  std::string words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= '0' && c <= '9')
      words += std::string(" ") + digits[static_cast<std::size_t>(c - '0')] + " ";
    else if (c == '.')
      words += " Point ";
    else if (text.compare(i, 2, "ε") == 0)
      words += " Epsilon ";
    else if (text.compare(i, 2, "δ") == 0)
      words += " Delta ";
    else
      words += std::isalpha(static_cast<unsigned char>(c)) != 0 ? c : ' ';
  }
  return words;
}

std::string value_text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "{--}"; }

class Macros {
 public:
  void add(const std::string& name, double value) {
    std::string unused = name;
    // Two labels may differ only in characters that a macro name cannot have.
    while (!names_.insert(unused).second) unused += "Again";
    text_ += fmt::format("\\newcommand{{\\{}}}{{{}}}\n", unused, value_text(value));
  }
  const std::string& text() const { return text_; }

 private:
  std::set<std::string> names_;
  std::string text_;
};

void add_figures(const Runs& all, const std::string& dataset, const std::string& variant, Macros& macros) {
  const Runs runs = counted_runs(all);
  if (runs.empty()) return;
  if (runs.size() < all.size()) {
    macros.add("isobench" + macro_name({dataset, variant, "runs left out"}),
               static_cast<double>(all.size() - runs.size()));
  }
  for (const std::string& figure : figure_names()) {
    std::vector<double> values;
    for (const RunRecord* run : runs) values.push_back(figure_value(*run, figure));
    const Spread spread = spread_of(std::move(values));
    const std::string name = "isobench" + macro_name({dataset, variant, figure});
    macros.add(name, spread.median);
    if (runs.size() < 2) continue;
    macros.add(name + "Smallest", spread.min);
    macros.add(name + "Largest", spread.max);
  }
}

Runs runs_over(const RunGrid& runs, const Variant& variant) {
  Runs all;
  for (const std::string& dataset : runs.datasets) {
    const Runs& here = find_runs(variant, dataset);
    all.insert(all.end(), here.begin(), here.end());
  }
  return all;
}

}  // namespace

std::string macro_name(const std::vector<std::string>& parts) {
  std::string name;
  for (const std::string& part : parts) {
    bool capital = true;
    for (const char c : spelled(part)) {
      if (c == ' ') {
        capital = true;
        continue;
      }
      name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      capital = false;
    }
  }
  return name;
}

std::string latex_macros(const Results& results) {
  const RunGrid runs = arrange_runs(results);
  Macros macros;
  if (has_many_datasets(runs)) {
    for (const Variant& variant : runs.variants)
      add_figures(finished(runs_over(runs, variant)), "all", variant.name, macros);
    return macros.text();
  }
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      add_figures(finished(find_runs(variant, dataset)), dataset, variant.name, macros);
    }
  }
  return macros.text();
}

std::string latex_tables(const Results& results) {
  std::string title = results.title;
  std::replace(title.begin(), title.end(), '\n', ' ');
  std::string text =
      "% " + title +
      "\n"
      "% Read this with \\input in a document that loads booktabs and siunitx. No value is rounded: siunitx rounds in\n"
      "% the tables, and \\num[round-mode=figures,round-precision=3]{\\isobench...} in the text.\n\n";
  text +=
      has_many_datasets(arrange_runs(results))
          ? "% There are too many data sets for a macro of each figure of each. The macros are medians over all of "
            "them,\n"
            "% with ...Smallest and ...Largest, e.g. \\isobenchAllParticlesRadiusRatioMin. Tables with rows of single\n"
            "% data sets are left out: see tables.md, and results.csv for all figures.\n"
          : "% A macro for each figure, named by data set, method and figure, e.g. "
            "\\isobenchSkullParticlesRadiusRatioMin.\n";
  text += latex_macros(results);
  if (results.published) {
    text += "\n% Where the published figures come from.\n\\newcommand{\\isobenchPublishedSource}{" +
            latex_escaped(results.published->source) + "}\n";
  }
  std::vector<Table> tables = all_tables(results);
  tables.push_back(claims_table(results));
  for (const Table& table : tables) {
    if (!table.empty() && !table.detail) text += fmt::format("\n{}", latex(table));
  }
  return text;
}

}  // namespace isobench
