#include "isobench/experiments/command_line/report_output.h"

#include <fmt/format.h>

#include <cstdio>

namespace isobench {

Report make_report(const std::filesystem::path& folder, const CommonArguments& common, Console& console) {
  if (!common.tables_only) console.update("making the report", -1.0);
  Report report = write_report_locked(folder, common.tables_only ? ReportParts::tables : ReportParts::all);
  console.clear();
  return report;
}

void print_tables(const Report& report) {
  fmt::print("{}", report.tables);
  std::fflush(stdout);  // so that it stands before later lines on stderr
}

void print_written_files(const std::filesystem::path& folder, const Report& report, Console& console) {
  for (const std::string& sentence : report.missing) console.line(sentence);
  std::string text;
  for (const std::string& name : report.written) {
    text += fmt::format("{}{}/{}", text.empty() ? "" : ", ", folder.string(), name);
  }
  console.line("written: " + text);
}

}  // namespace isobench
