// One figure over the runs of a table's cell: several seeds or repeats give the median and the range.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// Runs that differ in nothing but seed and repeat.
using Runs = std::vector<const RunRecord*>;

/// The runs with figures.
Runs finished(const Runs& runs);
/// Whether a run's mesh is closed and manifold; false where it has none.
bool sound(const RunRecord& run);
/// The runs whose figures may stand for all: of the finished ones those whose meshes are closed and manifold or, where
/// none is, all of them. A mean over both would be of neither.
Runs gated(const Runs& runs);

struct Spread {
  double median = 0.0;  ///< mean of the two middle ones where their number is even
  double min = 0.0;
  double max = 0.0;
};
/// Of the values that are finite; all NaN where there are none.
Spread spread_of(std::vector<double> values);

using Figure = std::function<double(const RunRecord&)>;

/// How a figure is printed.
struct Print {
  enum class Digits { significant, places, shortest } digits = Digits::shortest;
  int count = 0;
  std::string operator()(double value) const;
  bool operator==(const Print&) const = default;
};

/// Print with so many significant digits, with so many places after the point, as shortly as possible.
Print to_significant(int digits);
Print to_places(int places);
Print as_number();

/// " (3 seeds)", " (5 repeats, 1 timeout)", " (9 seeds, 2 † left out)"; "" for a single run.
/// Without the gate, for figures over all finished runs, the last reads " (9 seeds, 2 †)".
std::string spread_label(const Runs& runs, bool gate = true);

/// How many different meshes the finished runs of one seed gave: 1 where repeats agree bit for bit, 0 where no seed was
/// repeated; the largest number over the seeds.
std::size_t different_meshes(const Runs& runs);

}  // namespace isobench
