// A plot before it is drawn: its numbers and words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isobench {

enum class Marks {
  steps,   ///< the outline of a histogram; x is the middle of a bin
  lines,   ///< a curve
  points,  ///< a scatter plot
  joined,  ///< points and a line through them
  bars,    ///< bars beside each other, grouped by Plot::categories; x is the number of the category
  stack,   ///< the same with bars on top of each other
  boxes,   ///< a lying box plot in a row for each series: Series::range is the box, x are the outliers
  ranges,  ///< a dot in a row for each series, at its only x, and a bar over Series::range
};

/// y over x. `colour` chooses one of seven colours that colour-blind readers can tell apart, too; higher numbers repeat
/// the colours with other dashes and point shapes. The same number looks the same in every plot.
struct Series {
  std::string name;
  std::size_t colour = 0;
  std::vector<double> x;
  std::vector<double> y;         ///< none for boxes and ranges
  std::vector<double> range{};   ///< low, lower quartile, median, upper quartile, high; of ranges: low, high
  std::optional<Marks> marks{};  ///< if this series has others than the plot
};

struct Plot {
  std::string name;     ///< of the file, without its ending
  std::string kind;     ///< the same for plots that show the same thing for several data sets
  std::string title;    ///< what is shown and for which data set
  std::string caption;  ///< one or two sentences under the plot
  std::string x_label;  ///< with the unit
  std::string y_label;
  Marks marks = Marks::lines;
  bool log_x = false;
  bool log_y = false;
  double x_low = 0.0;  ///< the range that is shown; if both are 0, the range of the data
  double x_high = 0.0;
  double y_low = 0.0;  ///< likewise
  double y_high = 0.0;
  std::vector<std::string> categories;  ///< for bars and stacks
  std::vector<Series> series;
  bool empty() const { return series.empty(); }
};

}  // namespace isobench
