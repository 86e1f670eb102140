#include "isobench/reports/plots/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/reports/record/record.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// The colours of Okabe and Ito, which colour-blind readers can tell apart, too. Yellow is left out: it cannot be seen
// on white.
constexpr std::array<const char*, 7> colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"};
constexpr std::array<int, 4> dashes = {1, 2, 4, 5};
constexpr std::array<int, 4> shapes = {6, 4, 8, 12};

// In single quotes gnuplot changes nothing; only single quotes and line ends need care.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

std::string double_quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '"' || c == '\\' || c == '\n'; }, '\'');
  return '"' + text + '"';
}

std::string plot_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "NaN"; }

bool has_rows(const Plot& plot) { return plot.marks == Marks::boxes || plot.marks == Marks::ranges; }

// The first series is in the highest row.
std::size_t row_number(const Plot& plot, std::size_t series) { return plot.series.size() - series; }

bool has_categories(const Plot& plot) { return plot.marks == Marks::bars || plot.marks == Marks::stack; }

// The numbers, as one named data block for each series.
std::string data_blocks(const Plot& plot) {
  std::string text;
  for (std::size_t n = 0; n < plot.series.size(); ++n) {
    const Series& series = plot.series[n];
    text += fmt::format("$series{} << END\n", n + 1);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      text += plot_number(series.x[i]) + " " + plot_number(series.y[i]);
      if (has_categories(plot)) text += fmt::format(" {}", double_quoted(plot.categories[i]));
      text += "\n";
    }
    text += "END\n";
  }
  return text;
}

const char* colour_of(const Series& series) { return colours[series.colour % colours.size()]; }

std::string style_of(const Plot& plot, const Series& series) {
  const char* colour = colour_of(series);
  const std::size_t round = series.colour / colours.size();
  const int dash = dashes[round % dashes.size()];
  const int shape = shapes[(series.colour + round) % shapes.size()];
  switch (series.marks.value_or(plot.marks)) {
    case Marks::steps:
      return fmt::format("with histeps linewidth 1.8 dashtype {} linecolor rgb '{}'", dash, colour);
    case Marks::lines:
      return fmt::format("with lines linewidth 1.8 dashtype {} linecolor rgb '{}'", dash, colour);
    case Marks::points:
      return fmt::format("with points pointtype {} pointsize 0.9 linewidth 1.8 linecolor rgb '{}'", shape, colour);
    case Marks::joined:
      return fmt::format("with linespoints linewidth 1.8 dashtype {} pointtype {} linecolor rgb '{}'", dash, shape,
                         colour);
    case Marks::bars:
    case Marks::stack:
    case Marks::boxes:
    case Marks::ranges:
      break;
  }
  return fmt::format("with histograms fillstyle solid {} linecolor rgb '{}'", round % 2 == 0 ? "1.0" : "0.5", colour);
}

// The numbers of a plot with rows: for each series its row, the range, and the points.
std::string row_blocks(const Plot& plot) {
  std::string text;
  for (std::size_t n = 0; n < plot.series.size(); ++n) {
    const Series& series = plot.series[n];
    text += fmt::format("$range{} << END\n{}", n + 1, row_number(plot, n));
    for (const double value : series.range) text += " " + plot_number(value);
    text += "\nEND\n";
    if (series.x.empty()) continue;
    text += fmt::format("$points{} << END\n", n + 1);
    for (const double x : series.x) text += fmt::format("{} {}\n", plot_number(x), row_number(plot, n));
    text += "END\n";
  }
  return text;
}

// The parts of a plot's command that draw the row of a series.
std::vector<std::string> row_parts(const Plot& plot, std::size_t n) {
  const char* colour = colour_of(plot.series[n]);
  const std::string range = fmt::format("$range{}", n + 1);
  const std::string line = fmt::format("with vectors nohead linewidth 1.8 linecolor rgb '{}' notitle", colour);
  std::vector<std::string> parts;
  if (plot.marks == Marks::boxes) {
    parts = {fmt::format("{} using 3:1:3:5:($1-0.3):($1+0.3) with boxxyerror fillstyle solid 0.25 border linewidth 1.8 "
                         "linecolor rgb '{}' notitle",
                         range, colour),
             range + " using 2:1:($3-$2):(0) " + line, range + " using 5:1:($6-$5):(0) " + line,
             fmt::format("{} using 4:($1-0.3):(0):(0.6) with vectors nohead linewidth 3 linecolor rgb '{}' notitle",
                         range, colour)};
  } else {
    parts = {range + " using 2:1:($3-$2):(0) " + line};
  }
  if (!plot.series[n].x.empty()) {
    parts.push_back(fmt::format("$points{} using 1:2 with points pointtype {} pointsize {} linecolor rgb '{}' notitle",
                                n + 1, plot.marks == Marks::boxes ? 6 : 7, plot.marks == Marks::boxes ? 0.4 : 0.9,
                                colour));
  }
  return parts;
}

// The names of the series stand at their rows, so there is no legend.
std::string row_script(const Plot& plot) {
  std::string names;
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < plot.series.size(); ++n) {
    names += fmt::format("{}{} {}", n == 0 ? "" : ", ", quoted(plot.series[n].name), row_number(plot, n));
    for (std::string& part : row_parts(plot, n)) parts.push_back(std::move(part));
  }
  return fmt::format("unset key\nset yrange [0.4:{}]\nset ytics ({})\n", static_cast<double>(plot.series.size()) + 0.6,
                     names) +
         row_blocks(plot) + fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

std::string ranges(const Plot& plot) {
  std::string text;
  if (plot.x_low < plot.x_high) text += fmt::format("set xrange [{}:{}]\n", plot.x_low, plot.x_high);
  if (plot.y_low < plot.y_high) text += fmt::format("set yrange [{}:{}]\n", plot.y_low, plot.y_high);
  if (!plot.log_y) text += has_categories(plot) || plot.marks == Marks::steps ? "set yrange [0:*]\n" : "";
  if (plot.log_x) text += "set logscale x\nset format x '%g'\n";
  if (plot.log_y) text += "set logscale y\nset format y '%g'\n";
  if (plot.marks == Marks::points || plot.marks == Marks::joined) {
    text += "set offsets graph 0.04, graph 0.04, graph 0.06, graph 0.06\n";
  }
  if (plot.marks == Marks::bars) text += "set style data histograms\nset style histogram clustered gap 1\n";
  if (plot.marks == Marks::stack)
    text += "set style data histograms\nset style histogram rowstacked\nset boxwidth 0.6\n";
  std::size_t length = 0;
  for (const std::string& category : plot.categories) length += category.size() + 2;
  if (length > 80) text += "set xtics rotate by -30\n";
  return text;
}

// A plot of an earlier report must not be mistaken for one of this report.
void remove_others(const fs::path& folder, const std::vector<Plot>& plots) {
  std::set<std::string> names;
  for (const Plot& plot : plots) names.insert(plot.name);
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!names.contains(entry.path().stem().string())) others.push_back(entry.path());
  }
  for (const fs::path& other : others) fs::remove_all(other);
}

bool is_svg(const fs::path& path) {
  const std::string text = read_text_or_empty(path);
  return text.find("<svg") != std::string::npos && text.find("</svg>") != std::string::npos;
}

}  // namespace

std::string gnuplot_script(const Plot& plot) {
  // The legend stands under the plot, so a longer one needs a higher picture.
  const std::size_t rows = (plot.series.size() + 3) / 4;
  const std::size_t height = has_rows(plot) ? 130 + 34 * plot.series.size() : 420 + 20 * rows;
  std::string text = fmt::format(
      "# gnuplot 5.4: draws {0}.svg, in this folder\n"
      "set encoding utf8\n"
      "set terminal svg size 720,{1} noenhanced font 'sans-serif,14' background '#ffffff'\n"
      "set output '{0}.svg'\n",
      plot.name, height);
  text += "set title " + quoted(plot.title) + "\n";
  text += "set xlabel " + quoted(plot.x_label) + "\nset ylabel " + quoted(plot.y_label) + "\n";
  text +=
      "set border 3 linecolor rgb '#555555'\nset tics nomirror out\nset grid linecolor rgb '#dddddd' dashtype 1\n"
      "set key outside below center horizontal Left reverse samplen 2 height 1\n";
  text += ranges(plot);
  if (has_rows(plot)) return text + row_script(plot);
  text += data_blocks(plot) + "plot ";
  for (std::size_t n = 0; n < plot.series.size(); ++n) {
    const Series& series = plot.series[n];
    text += fmt::format("{}$series{} using {} {} title {}", n == 0 ? "" : ", \\\n     ", n + 1,
                        has_categories(plot) ? "2:xtic(3)" : "1:2", style_of(plot, series), quoted(series.name));
  }
  return text + "\n";
}

Drawn draw(const std::vector<Plot>& plots, const fs::path& folder) {
  fs::create_directories(folder);
  remove_others(folder, plots);
  for (const Plot& plot : plots) {
    const fs::path script = folder / (plot.name + ".gp");
    const std::string text = gnuplot_script(plot);
    if (read_text_or_empty(script) == text && is_svg(folder / (plot.name + ".svg"))) continue;
    fs::remove(folder / (plot.name + ".svg"));
    write_text(script, text);
    // One process for each plot: if gnuplot fails on one, the others are still drawn.
    run_tool({"gnuplot", script.filename().string()}, folder);
  }
  fs::remove(folder / "log.txt");
  Drawn drawn;
  for (const Plot& plot : plots) {
    if (is_svg(folder / (plot.name + ".svg"))) drawn.names.push_back(plot.name);
  }
  if (drawn.names.size() < plots.size()) {
    drawn.missing = fmt::format(
        "{} of {} plots could not be drawn, because gnuplot is missing or failed. Install it (apt-get install "
        "gnuplot-nox), then make the report again. The numbers and scripts are in {}.",
        plots.size() - drawn.names.size(), plots.size(), folder.filename().string());
  }
  return drawn;
}

}  // namespace isobench
