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

std::string style_of(const Plot& plot, const Series& series) {
  const char* colour = colours[series.colour % colours.size()];
  const std::size_t round = series.colour / colours.size();
  const int dash = dashes[round % dashes.size()];
  const int shape = shapes[(series.colour + round) % shapes.size()];
  switch (plot.marks) {
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
      break;
  }
  return fmt::format("with histograms fillstyle solid {} linecolor rgb '{}'", round % 2 == 0 ? "1.0" : "0.5", colour);
}

std::string ranges(const Plot& plot) {
  std::string text;
  if (plot.x_low < plot.x_high) text += fmt::format("set xrange [{}:{}]\n", plot.x_low, plot.x_high);
  if (!plot.log_y) text += has_categories(plot) || plot.marks == Marks::steps ? "set yrange [0:*]\n" : "";
  if (plot.log_x) text += "set logscale x\n";
  if (plot.log_y) text += "set logscale y\n";
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
  std::string text = fmt::format(
      "# gnuplot 5.4: draws {0}.svg, in this folder\n"
      "set encoding utf8\n"
      "set terminal svg size 720,{1} noenhanced font 'sans-serif,14' background '#ffffff'\n"
      "set output '{0}.svg'\n",
      plot.name, 420 + 20 * rows);
  text += "set title " + quoted(plot.title) + "\n";
  text += "set xlabel " + quoted(plot.x_label) + "\nset ylabel " + quoted(plot.y_label) + "\n";
  text +=
      "set border 3 linecolor rgb '#555555'\nset tics nomirror out\nset grid linecolor rgb '#dddddd' dashtype 1\n"
      "set key outside below center horizontal Left reverse samplen 2 height 1\n";
  text += ranges(plot) + data_blocks(plot) + "plot ";
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
