// The reports of a results folder, made from what is stored.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isobench {

/// How much of a report is made.
enum class ReportParts {
  tables,  ///< tables.md, tables.tex, results.csv and results.columns.md, which says what its columns are
  all,     ///< and plots/, pictures/ and report.html, which has it all
};

struct Report {
  std::string tables;                ///< the text of tables.md
  std::vector<std::string> written;  ///< names of the files to look at, in the folder; the best one last
  std::vector<std::string> missing;  ///< a sentence for each thing that could not be made, with the remedy
};

/// Writes the report of a folder from what it stores, finished or not. What has not changed keeps its bytes. Throws
/// DataError where `folder` is no results folder.
Report write_report(const std::filesystem::path& folder, ReportParts parts = ReportParts::all);

}  // namespace isobench
