// The overview that a reader wants first: the best method for each criterion and data set, and totals of each method.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// A criterion by which methods are compared: which method has the best value of a figure?
struct Question {
  std::string name;    ///< "Worst triangle (radius ratio)"
  std::string brief;   ///< the same in a word or two, within a sentence: "worst triangle"
  std::string figure;  ///< one of figure_names()
  bool larger = true;  ///< a larger value is better
  std::string unit;
  int digits = 3;      ///< significant digits; values that print alike count as equal
  bool timed = false;  ///< only runs that were timed alike count
};
const std::vector<Question>& questions();

/// The best methods on a dataset, by the medians over counted_runs(): several if their values print alike, none if
/// nothing was measured.
struct Best {
  std::vector<std::string> names;
  double value = 0.0;
  std::string text;  ///< "particles: 0.153", with "†" after the name if the mesh is not closed and manifold
};
Best best(const Question& question, const RunGrid& runs, const std::string& dataset);

/// The best methods: one row for each criterion, one column for each dataset. Here and below, finest_runs() compete:
/// otherwise a method would win at a sizing that is not that of the others.
Table best_table(const RunGrid& runs);

/// One row for each method, over all data sets: sound meshes, right topology, quality and cost.
Table methods_table(const RunGrid& runs);

/// best_table() as sentences: "Largest angle: particles on 3, advancing-front on 1 of 4 data sets."
/// With many data sets, only those count on which every method has a run. Empty for a single method.
std::vector<std::string> best_sentences(const RunGrid& runs);

/// The same in one line, method by method: "Best on the most data sets – particles: smallest angle (3 of 4), …; …". The
/// number stands there unless it is all data sets. Criteria in which more than two methods are equal are left out.
std::string best_line(const RunGrid& runs);

}  // namespace isobench
