// The paper's Figure 2 as a table: ε down, δ across.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// Runs of one dataset and label over several values of both ε and δ.
struct SizingGrid {
  std::string dataset;
  std::string label;
  std::vector<double> epsilons;  ///< in the order of the plan
  std::vector<double> deltas;
  std::map<std::pair<double, double>, Runs> cells;  ///< by ε and δ; of every seed and repeat
};

/// Points into `results`. Two one-at-a-time variations that cross in their base are no grid. If there are several
/// floors or refinements of the reference, only the first counts.
std::vector<SizingGrid> sizing_grids(const Results& results);

/// How often the median of a figure rises and falls in steps from one ε to the next smaller one at equal δ, or from one
/// δ to the next smaller one at equal ε. Steps with an unfinished end do not count.
struct Trend {
  int steps = 0;
  int rises = 0;
  int falls = 0;
};
enum class Along { epsilon, delta };
Trend trend(const SizingGrid& grid, Along along, const Figure& figure);

/// One table for each grid: triangles, smallest and average radius ratio and mean distance in each cell, and under the
/// table how they change with ε and δ.
std::vector<Table> sizing_grid_tables(const Results& results);

}  // namespace isobench
