// The paper's Figure 2 as a table: one row for each ε, one column for each δ.
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
  std::map<std::pair<double, double>, Runs> cells;  ///< by ε and δ; all seeds and repeats
};

/// Points into `results`. Runs that vary ε and δ only one at a time, from a common base, are no grid. If a cell has
/// runs with several floors, only those like its first run count.
std::vector<SizingGrid> sizing_grids(const Results& results);

/// How often the median of a figure rises and falls from one ε to the next smaller one at equal δ, or from one δ to the
/// next smaller one at equal ε. A step counts only if both of its cells have finished runs.
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
