// Which method is best at what, on which data, at what cost: the first thing that a reader wants to know.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// A question that figures answer.
struct Question {
  std::string name;    ///< "Worst triangle"
  std::string figure;  ///< as figure_value() knows it
  bool larger = true;  ///< a larger value is better
  std::string unit;
  int digits = 3;      ///< significant digits; values that print alike count as equal
  bool timed = false;  ///< only runs that were timed alike count
};
const std::vector<Question>& questions();

/// The methods that answer a question best on a dataset, by the medians of the runs that count (counted_runs());
/// several where they print alike, none where nothing was measured.
struct Best {
  std::vector<std::string> names;
  double value = 0.0;
  std::string text;  ///< "particles 0.153", with "†" for a mesh that is not closed and manifold
};
Best best(const Question& question, const RunGrid& runs, const std::string& dataset);

/// A row a question, a column a dataset.
Table best_table(const RunGrid& runs);

/// A row a method, over all data sets: sound meshes, right topology, quality and cost.
Table methods_table(const RunGrid& runs);

/// The same as sentences: "Worst triangle: particles on 3, advancing-front on 1 of 4 data sets."
std::vector<std::string> best_sentences(const RunGrid& runs);

}  // namespace isobench
