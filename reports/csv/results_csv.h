// results.csv: tidy, one row for each run, unrounded (percent 0..100, seconds wall, lengths mm).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// A column of results.csv. Name, unit and definition of a figure are those that its metric declares.
struct CsvColumn {
  std::string name;
  std::string unit;
  std::string definition;
};

/// The columns, in order, for the header, the documentation and `isobench list columns`. Throws std::logic_error if
/// two have the same name.
const std::vector<CsvColumn>& csv_columns();

/// A page of Markdown that defines the columns; it is stored beside results.csv.
std::string columns_text();

/// Header and one row for each record. A figure that was not measured is an empty cell. Numbers read back to the same
/// bits.
void write_results_csv(std::ostream& file, const std::vector<RunRecord>& records);
std::string results_csv(const std::vector<RunRecord>& records);

}  // namespace isobench
