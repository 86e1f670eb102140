#include <fmt/format.h>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/reports/comparison/comparison.h"

namespace isobench {

int compare_verb(const CompareArguments& arguments, const CommonArguments& common) {
  Results a = load_results(arguments.a);
  Results b = load_results(arguments.b);
  // Both are often of one experiment and have the same name; their folders distinguish them.
  a.name = arguments.a.string();
  b.name = arguments.b.string();
  const Comparison comparison = compare(a, b, arguments.tolerance);
  const Detail detail = common.verbosity == Verbosity::verbose ? Detail::full : Detail::brief;
  if (common.verbosity != Verbosity::quiet) fmt::print("{}", comparison_text(comparison, detail));
  return comparison.same() ? 0 : 1;
}

}  // namespace isobench
