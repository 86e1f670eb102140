// A table before it is written down: what Markdown and LaTeX are both made from, so that neither has logic of its own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "isobench/reports/runs/spread.h"

namespace isobench {

/// One number of a cell: over several runs their median and range, unrounded, and how it is to be printed.
struct CellFigure {
  Spread spread;
  Print print;
  /// "0.31" where smallest and largest print alike, else "0.31 (0.28–0.33)".
  std::string text() const;
};

/// Numbers or words, and what stands with them. Converts from words.
struct TableCell {
  TableCell() = default;
  TableCell(std::string text) : words(std::move(text)) {}  // NOLINT: rows mix words and cells
  TableCell(const char* text) : words(text) {}             // NOLINT

  std::string words;                   ///< where there are no figures
  std::string reason;                  ///< of words that are a status
  std::vector<CellFigure> figures;     ///< "a / b"
  std::string unit;                    ///< of the figures
  std::string mark;                    ///< " †", " (3 seeds)"
  std::vector<std::string> published;  ///< as printed there, figure by figure
  std::string published_unit;

  /// "0.300 / 0.945 † (published 0.40 / 0.92)".
  std::string text() const;
};

using TableRow = std::vector<TableCell>;

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::size_t label_columns = 2;  ///< the first columns, which say what a row is of
  std::vector<TableRow> rows;
  std::vector<std::string> remarks;      ///< sentences for under the table
  std::vector<std::string> definitions;  ///< names of metrics to define under it
  std::string source;                    ///< where published figures come from
  bool empty() const { return rows.empty(); }
};

/// "## title", the table, and what belongs under it; "" for a table without rows.
std::string markdown(const Table& table);

}  // namespace isobench
