#include "isobench/reports/latex/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "isobench/metrics/metric.h"

namespace isobench {

namespace {

// Whether siunitx reads the text as a number, as it does "63.275" and "< 0.004".
bool is_number(const std::string& text) {
  const std::size_t start = text.find_first_not_of("< ");
  if (start == std::string::npos) return false;
  char* end = nullptr;
  std::strtod(text.c_str() + start, &end);
  return *end == '\0' && text.find_first_not_of("0123456789.-+e", start) == std::string::npos;
}

// How a column of the table is set: words take one column of LaTeX, figures may take several.
struct Layout {
  std::vector<Print> prints;  // one for each figure of the cell; empty for words
  bool spread = false;        // some figure differs between its runs
  bool mark = false;
  bool mixed = false;  // rows print it differently, so that no S column can round it
  bool whole = true;   // all figures are whole numbers
  bool negative = false;
  std::size_t longest = 1;
  std::string unit;

  std::size_t per_figure() const { return spread ? 3 : 1; }
  std::size_t width() const { return prints.empty() ? 1 : prints.size() * per_figure() + (mark ? 1 : 0); }
};

// Finds how much room whole numbers take; without it siunitx would leave room for decimals.
void measure(double value, Layout& layout) {
  if (!std::isfinite(value)) return;
  layout.whole = layout.whole && value == std::floor(value) && std::abs(value) < 1e9;
  if (layout.whole) layout.longest = std::max(layout.longest, fmt::format("{}", std::abs(value)).size());
  layout.negative = layout.negative || value < 0.0;
}

Layout layout_of(const Table& table, std::size_t column) {
  Layout layout;
  for (const TableRow& row : table.rows) {
    const TableCell& cell = row[column];
    for (std::size_t i = 0; i < cell.figures.size(); ++i) {
      const CellFigure& figure = cell.figures[i];
      if (i == layout.prints.size()) layout.prints.push_back(figure.print);
      layout.mixed = layout.mixed || layout.prints[i] != figure.print;
      layout.spread = layout.spread || figure.spread.min < figure.spread.max;
      for (const double value : {figure.spread.median, figure.spread.min, figure.spread.max}) measure(value, layout);
    }
    if (cell.figures.empty()) continue;
    for (const std::string& printed : cell.published) {
      if (is_number(printed)) layout.longest = std::max(layout.longest, printed.size());
    }
    layout.mark = layout.mark || !cell.mark.empty();
    layout.unit = cell.unit;
  }
  return layout;
}

std::string rounding(const Print& print) {
  switch (print.digits) {
    case Print::Digits::significant:
      return fmt::format("[round-mode=figures,round-precision={}]", print.count);
    case Print::Digits::places:
      return fmt::format("[round-mode=places,round-precision={}]", print.count);
    case Print::Digits::shortest:
      return "";
  }
  return "";
}

std::string column_options(const Print& print, const Layout& layout) {
  const bool whole = print.digits == Print::Digits::shortest && layout.whole;
  return whole ? fmt::format("[table-format={}{}.0]", layout.negative ? "-" : "", layout.longest) : rounding(print);
}

std::string column_letters(const Layout& layout) {
  if (layout.prints.empty()) return "l";
  std::string letters;
  for (const Print& print : layout.prints) {
    for (std::size_t i = 0; i < layout.per_figure(); ++i) {
      letters += layout.mixed ? "r" : "S";
      if (!layout.mixed) letters += column_options(print, layout);
    }
  }
  return letters + (layout.mark ? "@{}l" : "");
}

std::string spanning(std::size_t columns, const char* letter, const std::string& text) {
  return columns == 1 ? "{" + text + "}" : fmt::format("\\multicolumn{{{}}}{{{}}}{{{}}}", columns, letter, text);
}

// The columns of a cell, to be joined by "&".
using Columns = std::vector<std::string>;

std::string number_cell(double value, const Print& print, const Layout& layout) {
  if (!std::isfinite(value)) return "{--}";
  return layout.mixed ? fmt::format("\\num{}{{{}}}", rounding(print), value) : fmt::format("{}", value);
}

std::string joined(const Columns& columns) { return fmt::format("{}", fmt::join(columns, " & ")); }

std::string figures_of(const TableCell& cell, const Layout& layout) {
  Columns columns;
  for (const CellFigure& figure : cell.figures) {
    const Spread& spread = figure.spread;
    columns.push_back(number_cell(spread.median, figure.print, layout));
    if (!layout.spread) continue;
    const bool several = spread.min < spread.max;
    columns.push_back(several ? number_cell(spread.min, figure.print, layout) : "");
    columns.push_back(several ? number_cell(spread.max, figure.print, layout) : "");
  }
  if (layout.mark) {
    columns.resize(layout.width() - 1);
    columns.push_back(latex_escaped(cell.mark));
  }
  columns.resize(layout.width());
  return joined(columns);
}

// A cell of words in a column of figures spans all its columns.
std::string words_of(const std::string& words, const Layout& layout) {
  if (layout.prints.empty()) return latex_escaped(words);
  return spanning(layout.width(), words == "–" ? "c" : "l", latex_escaped(words));
}

// Braces keep siunitx from rounding a published figure or adding digits to it; whole numbers need none.
std::string as_printed(const std::string& figure, const Print& print, const Layout& layout) {
  const bool rounds = layout.mixed || print.digits != Print::Digits::shortest;
  return rounds ? "{" + latex_escaped(figure) + "}" : figure;
}

std::string published_of(const TableCell& cell, const Layout& layout) {
  const bool other_unit = !cell.published_unit.empty() && cell.published_unit != cell.unit;
  const bool numbers = std::all_of(cell.published.begin(), cell.published.end(), is_number);
  if (layout.prints.empty() || other_unit || !numbers || cell.published.size() > layout.prints.size()) {
    const std::string text = fmt::format("{}{}{}", fmt::join(cell.published, " / "), other_unit ? " " : "",
                                         other_unit ? cell.published_unit : "");
    return words_of(text, layout);
  }
  Columns columns(layout.width());
  for (std::size_t i = 0; i < cell.published.size(); ++i) {
    columns[i * layout.per_figure()] = as_printed(cell.published[i], layout.prints[i], layout);
  }
  return joined(columns);
}

std::string ours_of(const TableCell& cell, const Layout& layout) {
  if (!cell.figures.empty()) return figures_of(cell, layout);
  const bool only_published = cell.words.empty() && !cell.published.empty();
  return only_published ? published_of(cell, layout) : words_of(cell.words_and_note() + cell.mark, layout);
}

std::string empty_columns(const Layout& layout) { return joined(Columns(layout.width())); }

// The line of our figures and, if there are published ones, their line under it.
std::string lines_of(const TableRow& row, const std::vector<Layout>& layouts, std::size_t label_columns) {
  Columns ours;
  Columns theirs;
  bool published = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    ours.push_back(ours_of(row[i], layouts[i]));
    const bool beside = !row[i].published.empty() && !(row[i].words.empty() && row[i].figures.empty());
    published = published || beside;
    if (i + 1 == label_columns)
      theirs.emplace_back("\\quad published");
    else
      theirs.push_back(beside ? published_of(row[i], layouts[i]) : empty_columns(layouts[i]));
  }
  return joined(ours) + " \\\\\n" + (published ? joined(theirs) + " \\\\\n" : "");
}

std::string header_of(const Table& table, const std::vector<Layout>& layouts) {
  Columns names;
  Columns parts;
  bool any_spread = false;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const Layout& layout = layouts[i];
    const std::string unit = layout.unit.empty() ? "" : " / " + layout.unit;
    names.push_back(spanning(layout.width(), "c", latex_escaped(table.header[i] + unit)));
    any_spread = any_spread || layout.spread;
    Columns here(layout.width());
    for (std::size_t p = 0; layout.spread && p < layout.prints.size(); ++p) {
      here[3 * p] = "{median}";
      here[3 * p + 1] = "{smallest}";
      here[3 * p + 2] = "{largest}";
    }
    parts.push_back(joined(here));
  }
  return joined(names) + " \\\\\n" + (any_spread ? joined(parts) + " \\\\\n" : "");
}

// LaTeX numbers its tables itself.
std::string caption_of(const Table& table) {
  const std::size_t colon = table.title.find(": ");
  const bool numbered = table.title.starts_with("Table ") && colon != std::string::npos;
  return numbered ? table.title.substr(colon + 2) : table.title;
}

// Reasons are too long for a column; they stand under the table.
std::string reasons_of(const Table& table) {
  std::string text;
  for (const TableRow& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].reason.empty()) continue;
      std::string where;
      for (std::size_t label = 0; label < table.label_columns; ++label) where += row[label].words + ", ";
      if (table.label_columns == 1) where += table.header[i] + ", ";
      text += "\\par " + latex_escaped(where + row[i].words + ": " + row[i].reason) + "\n";
    }
  }
  return text;
}

std::string notes_of(const Table& table) {
  std::string text = reasons_of(table);
  for (const std::string& remark : table.remarks) text += "\\par " + latex_escaped(remark) + "\n";
  for (const std::string& name : table.definitions) {
    const FigureDeclaration& figure = declared_figure(name);
    const std::string unit = figure.unit.empty() ? "" : " [" + figure.unit + "]";
    text += "\\par \\texttt{" + latex_escaped(name) + "}" + latex_escaped(unit + ": " + full_definition(figure)) + "\n";
  }
  return table.source.empty() ? text : text + "\\par " + latex_escaped(table.source) + "\n";
}

}  // namespace

std::string latex(const Table& table) {
  if (table.empty()) return "";
  std::vector<Layout> layouts;
  std::string letters;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    layouts.push_back(layout_of(table, i));
    letters += column_letters(layouts.back());
  }
  std::string text = "\\begin{table}\n\\centering\\footnotesize\\setlength{\\tabcolsep}{4pt}\n\\caption{" +
                     latex_escaped(caption_of(table)) + "}\n\\begin{tabular}{" + letters + "}\n\\toprule\n" +
                     header_of(table, layouts) + "\\midrule\n";
  for (const TableRow& row : table.rows) text += lines_of(row, layouts, table.label_columns);
  text += "\\bottomrule\n\\end{tabular}\n";
  const std::string notes = notes_of(table);
  if (!notes.empty()) text += "\n\\begin{flushleft}\n" + notes + "\\end{flushleft}\n";
  return text + "\\end{table}\n";
}

}  // namespace isobench
