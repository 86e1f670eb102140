// The runs behind one cell of a table, and the median and range of a figure over several seeds or repeats.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// Runs that differ only in seed and repeat.
using Runs = std::vector<const RunRecord*>;

/// The runs that ended well and were measured.
Runs finished(const Runs& runs);
/// Whether the run's mesh is closed and manifold; false if there is no mesh.
bool is_closed_manifold(const RunRecord& run);
/// Whether the run should have another run's number of vertices but could not be given it.
bool is_unmatched(const RunRecord& run);
/// The runs that medians and averages are taken over: the finished runs with closed, manifold meshes or, if there is
/// none, all finished runs. A mean over both kinds would describe neither.
Runs counted_runs(const Runs& runs);

struct Spread {
  double median = 0.0;  ///< for an even number of values, the mean of the two middle ones
  double min = 0.0;
  double max = 0.0;
};
/// Over the finite values; all NaN if there is none.
Spread spread_of(std::vector<double> values);

using Figure = std::function<double(const RunRecord&)>;

/// How a figure is printed.
struct Print {
  enum class Digits { significant, places, shortest } digits = Digits::shortest;
  int count = 0;
  std::string operator()(double value) const;
  bool operator==(const Print&) const = default;
};

/// Prints with this many significant digits; with this many digits after the point; as short as possible.
Print to_significant(int digits);
Print to_places(int places);
Print as_number();

/// " (3 seeds)", " (5 repeats, 1 timeout)", " (9 seeds, 2 † left out)"; "" for a single run. With `counted_only` false,
/// for figures over all finished runs, the last one reads " (9 seeds, 2 †)".
std::string spread_label(const Runs& runs, bool counted_only = true);

/// The number of different meshes among the finished runs of one seed; of several seeds, the largest number. It is 1 if
/// repeats agree bit for bit, 0 if no seed was repeated.
std::size_t different_meshes(const Runs& runs);

}  // namespace isobench
