// The plots of a results folder, made from its records.
#pragma once

#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/plots/plot.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// All plots that have data, the most important first. With many data sets these are the plots over all of them, and no
/// plots of single ones. `over_h` comes from the runs that kept their sizing field. A
/// method has the same colour in all plots. Histograms add up the runs of several seeds or repeats that count
/// (counted_runs()). Traces and stages show one run.
std::vector<Plot> all_plots(const Results& results, const std::vector<EdgesOverH>& over_h = {});

// The kinds of plots, one plot for each data set unless the comment says otherwise. Empty plots are left out. With many
// data sets the histograms (the first four) are those of all data sets together.
std::vector<Plot> radius_ratio_plots(const RunGrid& runs);  ///< the paper's Figure 5
std::vector<Plot> edge_length_plots(const RunGrid& runs);   ///< the paper's Figures 3 and 4
std::vector<Plot> angle_plots(const RunGrid& runs);
std::vector<Plot> valence_plots(const RunGrid& runs);
/// One for each data set and each trace ("energy", …) that a run of it recorded.
std::vector<Plot> trace_plots(const RunGrid& runs);
/// Wall seconds of each stage of meshing.
std::vector<Plot> stage_plots(const RunGrid& runs);
/// For many data sets together (many_datasets): distributions, cumulative shares, performance profiles, the Pareto
/// front and average ranks of the methods.
std::vector<Plot> survey_plots(const RunGrid& runs);
/// For all data sets together: radius ratios and seconds over the number of vertices.
std::vector<Plot> size_plots(const RunGrid& runs);
/// Errors of finite elements (poisson_l2, poisson_max, gradient_max) over the number of vertices, with the slopes of
/// theory, where methods have several sizings; and over the seconds of meshing and solving. One plot for each of them
/// and each data set whose runs have the figure; none with many data sets.
std::vector<Plot> use_plots(const Results& results, const RunGrid& runs);
/// Figures over δ, one curve for each ε; one plot for each grid that sizing_grids() finds.
std::vector<Plot> sizing_plots(const Results& results);
/// The paper's Figure 3. The first plot shows how much nearer the second neighbour of a particle is on a circle than on
/// a line. The others show, for each run in `over_h`, edge lengths divided by the sizing field h.
std::vector<Plot> contraction_plots(const std::vector<EdgesOverH>& over_h);

}  // namespace isobench
