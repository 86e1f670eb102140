#include "isobench/experiments/command_line/report_output.h"
#include "isobench/experiments/command_line/verbs.h"

namespace isobench {

int report_verb(const std::filesystem::path& folder, const CommonArguments& common) {
  Console console(common.verbosity);
  const Report report = make_report(folder, common, console);
  if (common.verbosity != Verbosity::quiet) print_tables(report);
  print_written_files(folder, report, console);
  return 0;
}

}  // namespace isobench
