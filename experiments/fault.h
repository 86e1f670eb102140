// Fault injection for the tests of the runner: the only way to see what a crash, a hang or a memory hog does without
// keeping a broken method in the product.
#pragma once

#include "reports/record.h"

namespace isobench {

/// Does what the environment variable ISOBENCH_TEST_FAULT says to the runs that its glob names: "crash:<glob>" ends the
/// process by SIGSEGV, "hang:<glob>" never returns, "memory:<glob>" takes memory until somebody stops it. Nothing where
/// the variable is not set. Called by the verb `cell` alone.
void inject_fault(const RunRequest& request);

}  // namespace isobench
