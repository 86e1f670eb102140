// The contents of a table. Markdown, LaTeX and the page are made from it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "isobench/reports/runs/spread.h"

namespace isobench {

/// One number of a cell, unrounded: the median and range over several runs, and how to print them.
struct CellFigure {
  Spread spread;
  Print print;
  /// "0.31" if smallest and largest print alike, else "0.31 (0.28–0.33)".
  std::string text() const;
};

/// Figures or words, with marks and published values. Converts from words.
struct TableCell {
  TableCell() = default;
  TableCell(std::string text) : words(std::move(text)) {}  // NOLINT: rows mix words and cells
  TableCell(const char* text) : words(text) {}             // NOLINT

  std::string words;                   ///< if there are no figures
  std::string note{};                  ///< in brackets after the words; on the page, in a line under them
  std::string reason;                  ///< why the run has this status, if the words are a status
  std::vector<CellFigure> figures;     ///< "a / b"
  std::string unit;                    ///< of the figures
  std::string mark;                    ///< " †", " (3 seeds)"
  std::vector<std::string> published;  ///< as printed in the paper, figure by figure
  std::string published_unit;

  /// The words and the note: "998 of 1000 (99.3–99.9 %)".
  std::string words_and_note() const { return note.empty() ? words : words + " (" + note + ")"; }
  /// "0.300 / 0.945 † (published 0.40 / 0.92)".
  std::string text() const;
};

using TableRow = std::vector<TableCell>;

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::size_t label_columns = 2;  ///< number of columns, from the first one on, that name the row
  std::vector<TableRow> rows;
  std::vector<std::string> remarks;      ///< sentences under the table
  std::vector<std::string> definitions;  ///< names of the figures that are defined under it
  std::string source;                    ///< of the published figures
  bool detail = false;                   ///< rows of single data sets, although there are many: shown last
  bool empty() const { return rows.empty(); }
};

/// "## title", the table, and the text under it; "" for a table without rows.
std::string markdown(const Table& table);

}  // namespace isobench
