// Writes the reports of a results folder from what the folder stores.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isobench {

/// Which files of a report are made.
enum class ReportParts {
  tables,  ///< tables.md, tables.tex, results.csv and results.columns.md, which explains the columns
  all,     ///< the same and plots/, pictures/ and report.html
};

struct Report {
  std::string tables;                ///< the text of tables.md; with many data sets without the tables of single ones
  std::vector<std::string> written;  ///< names of the main files in the folder; the most useful one last
  std::vector<std::string> missing;  ///< one sentence for each thing that could not be made, with the remedy
};

/// Writes the report of a results folder, which may be half-finished. The same results give the same bytes. Throws
/// DataError if `folder` is not a results folder.
Report write_report(const std::filesystem::path& folder, ReportParts parts = ReportParts::all);

}  // namespace isobench
