// tables.md: every table of a results folder in one Markdown document.
#pragma once

#include <string>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// All tables of a results folder. Runs that are not ok stand in their cells with status and reason; meshes that are
/// not closed and manifold carry a dagger and stay out of medians and averages while others are, and numbers of
/// vertices that could not be matched a double dagger. Under each table stand the definitions of its figures and the
/// published source.
std::string markdown_tables(const Results& results);

}  // namespace isobench
