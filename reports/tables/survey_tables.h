// Tables for experiments with many data sets (many_datasets): what the runs say together.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// How often the meshes of each method pass each check, with Wilson's 95 % intervals.
Table reliability_table(const RunGrid& runs);
/// The same for each family of data sets; no row if there are no families.
Table family_reliability_table(const RunGrid& runs);
/// Which data sets do not pass which check; one row for each method and check.
Table outlier_table(const RunGrid& runs);
/// The worst value of each figure, with its data set; one column for each method.
Table worst_table(const RunGrid& runs);
/// One row for each family and method, with the worst case of each figure ever seen; no row if there are no families.
Table family_table(const RunGrid& runs);
/// Quantiles over the data sets, with bootstrapped 95 % intervals of the medians.
Table distribution_table(const RunGrid& runs);
/// Average ranks with Friedman's test and Nemenyi's critical difference.
Table rank_table(const RunGrid& runs);
/// One row for each data set and method: checks not passed, and the main figures.
Table dataset_table(const RunGrid& runs);

/// All of these but dataset_table(), without those that have no row.
std::vector<Table> survey_tables(const RunGrid& runs);

/// "Sound meshes (…): particles 998 of 1000, …": one line for all methods with many data sets.
std::string sound_sentence(const RunGrid& runs);

}  // namespace isobench
