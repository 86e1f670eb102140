// tables.md: all tables of a results folder in one Markdown document.
#pragma once

#include <string>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// Whether the tables of single data sets are shown although there are many (Table::detail).
enum class DatasetTables { shown, left_out };

/// The text of tables.md. A run that failed shows its status and reason in its cell. † marks a mesh that is not closed
/// and manifold; such meshes do not count in medians and averages (counted_runs()). ‡ marks a number of vertices that
/// could not be matched. Under each table are the definitions of its figures and the source of the published ones.
std::string markdown_tables(const Results& results, DatasetTables details = DatasetTables::shown);

}  // namespace isobench
