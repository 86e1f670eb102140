// results.csv: tidy, one row a run, unrounded (percent 0..100, seconds wall, lengths mm).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// A column of results.csv; figures are defined as the metrics define them.
struct CsvColumn {
  std::string name;
  std::string unit;
  std::string definition;
};

/// The columns, in order: header, documentation and `isobench list columns` all go by this list.
const std::vector<CsvColumn>& csv_columns();

/// What stands in the columns, as a page of Markdown to lie beside results.csv.
std::string columns_text();

/// Header and one row a record; a figure that a run does not have is an empty cell. Numbers read back to the same bits.
void write_results_csv(std::ostream& file, const std::vector<RunRecord>& records);
std::string results_csv(const std::vector<RunRecord>& records);

}  // namespace isobench
