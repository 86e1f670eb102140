// The tables of the paper and those beyond it: our figures, and the published ones beside them.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// The tables of a results folder, without those that have no row. If there are many data sets, those that sum up over
/// them come first (survey_tables.h). The others follow as Table::detail, and one row for each data set replaces the
/// paper's Table 2, which has a column for each.
std::vector<Table> all_tables(const Results& results);

// The single tables. Laid out as in Meyer, Kirby, Whitaker 2007.
Table sizes_table(const Results& results, const RunGrid& runs);         ///< Table 1
Table radius_ratio_table(const Results& results, const RunGrid& runs);  ///< Table 2
Table valence_table(const Results& results, const RunGrid& runs);       ///< Table 3
Table edge_length_table(const Results& results, const RunGrid& runs);   ///< Figure 4 as a table
Table topology_table(const RunGrid& runs);
Table distance_table(const RunGrid& runs);
Table cost_table(const RunGrid& runs);
/// One table for each method with two or more stages: its seconds, one row for each variant and data set, one column
/// for each stage.
std::vector<Table> stage_tables(const RunGrid& runs);
/// One table for each method with two or more variants that differ from a base in a single parameter: how the change
/// affects quality, edges above h0, topology and seconds. One row for each data set and change, after the base's row.
std::vector<Table> ablation_tables(const RunGrid& runs);
/// What a simulation pays for the meshes and gets from them, with orders of convergence: one table for each data set
/// whose runs have figures_of_use(); with many data sets, one of medians over all of them.
std::vector<Table> use_tables(const Results& results, const RunGrid& runs);
/// Figures of the metrics that only an experiment with `metrics_of_use` has.
const std::vector<std::string>& figures_of_use();
Table seed_table(const RunGrid& runs);      ///< spread over seeds and repeats, and whether repeats agree
Table match_table(const Results& results);  ///< which run was matched to which, and how closely

}  // namespace isobench
