#include <oneapi/tbb/global_control.h>

#include <csignal>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/experiments/runner/fault_injection.h"

namespace isobench {

namespace {

RunRequest planned(const CellArguments& arguments) {
  for (const RunRequest& request : plan_from_json(read_text(arguments.plan), arguments.plan.string())) {
    if (request.run == arguments.run) return request;
  }
  throw UsageError(arguments.plan.string() + " has no run '" + arguments.run + "'");
}

}  // namespace

int cell_verb(const CellArguments& arguments, const CommonArguments&) {
  std::signal(SIGPIPE, SIG_IGN);  // the run goes on if nobody reads its progress any more
  const RunRequest request = planned(arguments);
  if (request.match_to.empty() == arguments.match_vertices.has_value()) {
    throw UsageError("give --match-vertices if and only if the run has a match_to");
  }
  inject_fault(request, arguments.folder);
  PipeSink sink(arguments.progress_fd);
  Monitor monitor(&sink);
  const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return run_cell(request, arguments.match_vertices, arguments.folder, static_cast<int>(threads), monitor).exit_code;
}

}  // namespace isobench
