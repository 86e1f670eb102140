// Histograms of radius ratios, edge lengths, angles and valences.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/reports/plots/plots.h"

namespace isobench {

namespace {

// What one plot shows: a data set or, if there are many, all of them together.
struct PlottedData {
  std::string name;
  std::vector<std::string> datasets;
};

std::vector<PlottedData> plotted_data(const RunGrid& runs) {
  if (has_many_datasets(runs)) return {{"all data sets", runs.datasets}};
  std::vector<PlottedData> all;
  for (const std::string& dataset : runs.datasets) all.push_back({dataset, {dataset}});
  return all;
}

Runs counted_on(const Variant& variant, const PlottedData& data) {
  Runs all;
  for (const std::string& dataset : data.datasets) {
    const Runs counted = counted_runs(find_runs(variant, dataset));
    all.insert(all.end(), counted.begin(), counted.end());
  }
  return all;
}

// The sum of the runs' histograms, bin by bin. It has no bins if their numbers of bins differ.
Histogram sum(const Runs& runs, const std::string& histogram) {
  Histogram all;
  for (const RunRecord* run : runs) {
    const Histogram& next = run->measurement->histogram(histogram);
    if (next.counts.empty()) continue;  // not measured
    if (all.counts.empty()) {
      all = next;
      continue;
    }
    if (next.counts.size() != all.counts.size()) return {};
    std::transform(next.counts.begin(), next.counts.end(), all.counts.begin(), all.counts.begin(), std::plus<>());
  }
  return all;
}

double percent(std::size_t count, std::size_t total) {
  return 100.0 * static_cast<double>(count) / static_cast<double>(total);
}

Series series_of(const Histogram& histogram, const std::string& name, std::size_t colour) {
  Series series{name, colour, {}, {}};
  const std::size_t total = std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t{0});
  if (total == 0) return series;
  const double width = (histogram.high - histogram.low) / static_cast<double>(histogram.counts.size());
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    series.x.push_back(histogram.low + (static_cast<double>(bin) + 0.5) * width);
    series.y.push_back(percent(histogram.counts[bin], total));
  }
  return series;
}

// One plot for each dataset, or one for many, with all methods in it. `shared` holds what the plots have in common.
std::vector<Plot> histogram_plots(const RunGrid& runs, const Plot& shared, const std::string& histogram) {
  std::vector<Plot> plots;
  for (const PlottedData& data : plotted_data(runs)) {
    Plot plot = shared;
    plot.kind = shared.name;
    plot.name += "-" + data.name;
    plot.title += ", " + data.name;
    plot.marks = Marks::steps;
    for (std::size_t n = 0; n < runs.variants.size(); ++n) {
      const Variant& variant = runs.variants[n];
      Series series = series_of(sum(counted_on(variant, data), histogram), variant.name, n);
      if (!series.x.empty()) plot.series.push_back(std::move(series));
    }
    if (!plot.empty()) plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace

std::vector<Plot> radius_ratio_plots(const RunGrid& runs) {
  Plot plot;
  plot.name = "radius-ratio";
  plot.title = "Radius ratios of the triangles";
  plot.caption =
      "Radius ratio = 2 × radius of the inscribed circle / radius of the circumscribed circle: 1 for an equilateral "
      "triangle, 0 for one without area. Same axes as in Figure 5 of the paper.";
  plot.x_label = "radius ratio";
  plot.y_label = "% of the triangles in each bin of 0.01";
  plot.x_high = 1.0;
  return histogram_plots(runs, plot, "radius_ratio");
}

std::vector<Plot> edge_length_plots(const RunGrid& runs) {
  Plot plot;
  plot.name = "edge-over-h0";
  plot.title = "Edge lengths divided by h0";
  plot.caption =
      "h0 is the longest edge that the sampling theory allows at a place. Edges with a ratio above 1 are too long. The "
      "last bin has all values above 2. Same axes as in Figures 3 and 4 of the paper.";
  plot.x_label = "edge length / h0";
  plot.y_label = "% of the edges in each bin of 0.01";
  plot.x_high = 2.0;
  return histogram_plots(runs, plot, "edge_over_h0");
}

std::vector<Plot> contraction_plots(const std::vector<EdgesOverH>& over_h) {
  std::vector<Plot> plots;
  for (const EdgesOverH& edges : over_h) {
    Plot plot;
    plot.kind = "edge-over-h";
    plot.name = fmt::format("edge-over-h-{}-{}", edges.dataset, edges.method);
    plot.title = fmt::format("Edge lengths divided by h, {}, {}", edges.dataset, edges.method);
    plot.caption =
        "h is the sizing field that the particles should follow, here the mean of its values at both ends of the edge. "
        "The last bin has all values above 2.";
    plot.x_label = "edge length / h";
    plot.y_label = "% of the edges in each bin of 0.01";
    plot.marks = Marks::steps;
    plot.x_high = 2.0;
    Histogram histogram(0.0, 2.0, edges.counts.size());
    std::copy(edges.counts.begin(), edges.counts.end(), histogram.counts.begin());
    Series series = series_of(histogram, edges.method, 0);
    if (!series.x.empty()) plot.series.push_back(std::move(series));
    if (!plot.empty()) plots.push_back(std::move(plot));
  }
  if (plots.empty()) return plots;
  Plot circle;
  circle.kind = circle.name = "contraction";
  circle.title = "Equally spaced particles on a circle";
  circle.caption =
      "The distance between a particle and its second neighbour, divided by twice the distance between neighbours "
      "(from equation 6 of the paper). Neighbours are at most ε radii apart.";
  circle.x_label = "distance between neighbours / radius of the circle";
  circle.y_label = "distance to 2nd neighbour / (2 × distance to 1st)";
  circle.series.push_back({"on a circle", 0, {}, {}});
  circle.series.push_back({"on a line", 6, {0.0, 1.0}, {1.0, 1.0}});
  for (int n = 0; n <= 100; ++n) {
    const double d = 0.01 * n;
    circle.series[0].x.push_back(d);
    circle.series[0].y.push_back(std::sqrt(1.0 - 0.25 * d * d));
  }
  plots.insert(plots.begin(), std::move(circle));
  return plots;
}

std::vector<Plot> angle_plots(const RunGrid& runs) {
  Plot plot;
  plot.name = "angle";
  plot.title = "Angles of the triangles";
  plot.caption = "All three angles of each triangle. An equilateral triangle has three of 60°.";
  plot.x_label = "angle, degrees";
  plot.y_label = "% of the angles in each degree";
  plot.x_high = 180.0;
  return histogram_plots(runs, plot, "angle");
}

std::vector<Plot> valence_plots(const RunGrid& runs) {
  constexpr std::size_t lowest = 3;
  constexpr std::size_t highest = 10;
  std::vector<Plot> plots;
  for (const PlottedData& data : plotted_data(runs)) {
    Plot plot;
    plot.name = "valence-" + data.name;
    plot.title = "Valences of the vertices, " + data.name;
    plot.caption = "The valence is the number of edges at a vertex. 6 is regular.";
    plot.x_label = "valence";
    plot.y_label = "% of the vertices";
    plot.marks = Marks::bars;
    for (std::size_t v = lowest; v <= highest; ++v) plot.categories.push_back(fmt::format("{}", v));
    plot.categories.front().insert(0, "≤ ");
    plot.categories.back().insert(0, "≥ ");
    for (std::size_t n = 0; n < runs.variants.size(); ++n) {
      Series series{runs.variants[n].name, n, {}, std::vector<double>(plot.categories.size(), 0.0)};
      std::size_t total = 0;
      for (const RunRecord* run : counted_on(runs.variants[n], data)) {
        const std::vector<std::uint32_t>& counts = run->measurement->histogram("valence").counts;
        for (std::size_t v = 0; v < counts.size(); ++v) {
          series.y[std::clamp(v, lowest, highest) - lowest] += static_cast<double>(counts[v]);
          total += counts[v];
        }
      }
      if (total == 0) continue;
      for (double& y : series.y) y *= 100.0 / static_cast<double>(total);
      for (std::size_t c = 0; c < series.y.size(); ++c) series.x.push_back(static_cast<double>(c));
      plot.series.push_back(std::move(series));
    }
    if (!plot.empty()) plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace isobench
