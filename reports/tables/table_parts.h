// Parts that several tables use.
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
/// Warnings about a mesh: " †" as above, " ‡" if its number of vertices could not be matched, " †‡" for both; else "".
std::string marks(const RunRecord& record);
/// The marks of all runs whose figures are shown (counted_runs()) together.
std::string marks(const Runs& runs);
/// The words of a cell without figures: "not run", "timeout: not finished after 20 minutes"; empty if the run is ok.
TableCell instead_of_figures(const RunRecord* record);

/// A cell with one number.
TableCell number_cell(double value, const Print& print);
/// A cell with one figure over counted_runs(). Precondition: one of the runs is finished.
TableCell over(const Runs& runs, const Figure& figure, const Print& print);
/// The same for seconds. Only runs with the most frequent timing (RunGrid::timing) count, because seconds of other runs
/// must not be compared with theirs. The cell is "§" if there are none.
TableCell over_timed(const RunGrid& arrangement, const Runs& runs, const Figure& figure, const Print& print);
/// The same over all finished runs, for the figures by which counted_runs() chooses.
TableCell over_all(const Runs& runs, const Figure& figure, const Print& print);
/// Puts timing_remark() under a table that has seconds.
void say_how_timed(const RunGrid& arrangement, Table& table);
/// "a / b" in one cell.
TableCell beside(TableCell cell, const TableCell& next);

/// The cell with the published values of these quantities, up to the first that was not published.
TableCell with_published(TableCell cell, const Results& results, const std::vector<std::string>& quantities,
                         const std::string& dataset, const std::string& method);
TableCell with_unit(TableCell cell, const std::string& unit);
TableCell with_mark(TableCell cell, const std::string& mark);

/// The definitions of these figures, one on each line, to put under a table.
std::string definitions(const std::vector<std::string>& figures);
/// A sentence that names the source of a table's published figures; "" if it has none.
std::string source_line(const Results& results, const std::string& table);

/// Published methods that have figures in this table but no run of ours beside them.
std::vector<const PublishedMethod*> published_alone(const Results& results, const RunGrid& runs,
                                                    const std::string& table);

/// "1 run", "3 runs".
std::string plural(std::size_t count, const std::string& thing);
/// Number of vertices of a finished run.
double vertices(const RunRecord& run);

/// "## title" and a blank line.
std::string heading(const std::string& title);

}  // namespace isobench
