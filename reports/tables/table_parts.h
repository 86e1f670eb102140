// What the tables have in common.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/table.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

/// " †" for a mesh that is not closed and manifold, else "".
std::string dagger(const RunRecord& record);
/// What has to be known of a mesh before its figures are believed: " †" as above, " ‡" for a number of vertices that
/// could not be matched, " †‡"; else "".
std::string marks(const RunRecord& record);
/// Of the runs whose figures are shown (counted_runs()), all marks that one of them has.
std::string marks(const Runs& runs);
/// What stands in the place of figures: "not run", "timeout: not finished after 20 minutes"; empty where the run is ok.
TableCell instead_of_figures(const RunRecord* record);

/// One figure over runs of which at least one is finished, ready for a cell; of those that counted_runs() lets pass.
TableCell over(const Runs& runs, const Figure& figure, const Print& print);
/// The same of what was timed as most of the runs were (RunGrid::timing): seconds of others do not compare, and
/// where a cell has no others it says " §".
TableCell over_timed(const RunGrid& arrangement, const Runs& runs, const Figure& figure, const Print& print);
/// The same over all finished runs: for what tells whether they may pass.
TableCell over_all(const Runs& runs, const Figure& figure, const Print& print);
/// timing_remark() under a table that has seconds, where there is one.
void say_how_timed(const RunGrid& arrangement, Table& table);
/// "a / b" in one cell.
TableCell beside(TableCell cell, const TableCell& next);

/// The cell with what was published beside it; as it is where the first of the quantities was not.
TableCell with_published(TableCell cell, const Results& results, const std::vector<std::string>& quantities,
                         const std::string& dataset, const std::string& method);
TableCell with_unit(TableCell cell, const std::string& unit);
TableCell with_mark(TableCell cell, const std::string& mark);

/// Lines for under a table: what each of these figures is, in the metrics' own words.
std::string definitions(const std::vector<std::string>& figures);
/// A sentence on where the published figures of a table come from; "" where there are none.
std::string source_line(const Results& results, const std::string& table);

/// Published methods that have figures in this table but no run of ours beside them.
std::vector<const PublishedMethod*> published_alone(const Results& results, const RunGrid& runs,
                                                    const std::string& table);

/// "1 run", "3 runs".
std::string plural(std::size_t count, const std::string& thing);
/// Of a finished run.
double vertices(const RunRecord& run);

/// "## title" and a blank line.
std::string heading(const std::string& title);

}  // namespace isobench
