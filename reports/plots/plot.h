// A plot before it is drawn: what is on it, in numbers and words.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace isobench {

enum class Marks {
  steps,   ///< a histogram's outline; x is the middle of a bin
  lines,   ///< a curve
  points,  ///< a cloud
  joined,  ///< points and the line through them
  bars,    ///< beside each other, in groups by Plot::categories; x counts the categories
  stack,   ///< on top of each other, as above
};

/// y over x. `colour` picks one of few that differ for colour-blind readers, too, and a dash or a point's shape where
/// they run out: the same number looks the same in every plot.
struct Series {
  std::string name;
  std::size_t colour = 0;
  std::vector<double> x;
  std::vector<double> y;
};

struct Plot {
  std::string name;     ///< of its file, without the ending
  std::string kind;     ///< of plots that are looked at side by side, those of several datasets
  std::string title;    ///< what is shown, of what
  std::string caption;  ///< one or two sentences for beside it
  std::string x_label;  ///< with the unit
  std::string y_label;
  Marks marks = Marks::lines;
  bool log_x = false;
  bool log_y = false;
  double x_low = 0.0;  ///< shown range; that of the data where both are 0
  double x_high = 0.0;
  std::vector<std::string> categories;  ///< of bars and stacks
  std::vector<Series> series;
  bool empty() const { return series.empty(); }
};

}  // namespace isobench
