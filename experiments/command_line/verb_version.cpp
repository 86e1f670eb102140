#include <fmt/format.h>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/reports/record/environment.h"

namespace isobench {

int version_verb() {
  const Environment here = environment();
  fmt::print("isobench {} (commit {}{})\n{}, {}\n", here.version, here.commit, here.dirty ? ", changed" : "",
             here.compiler, here.build_type);
  for (const auto& [name, version] : *here.libraries) fmt::print("{} {}\n", name, version);
  return 0;
}

}  // namespace isobench
