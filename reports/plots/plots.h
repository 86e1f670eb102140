// The plots of a results folder, from what its records hold.
#pragma once

#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/plots/plot.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// Everything that there is something to draw of, in the order in which a reader wants it; `over_h` is what the runs
/// that kept their sizing field have. A label has one colour in all of them. Histograms sum the runs of several seeds
/// or repeats; as in the tables only meshes that are closed manifolds count while there are any (gated()). Curves are
/// of one run.
std::vector<Plot> all_plots(const Results& results, const std::vector<EdgesOverH>& over_h = {});

// The single kinds, a plot a dataset unless it says otherwise; without those that would be empty.
std::vector<Plot> radius_ratio_plots(const RunGrid& runs);  ///< the paper's Figure 5
std::vector<Plot> edge_length_plots(const RunGrid& runs);   ///< the paper's Figures 3 and 4
std::vector<Plot> angle_plots(const RunGrid& runs);
std::vector<Plot> valence_plots(const RunGrid& runs);
/// One for each dataset and trace ("energy", …) that a run of it recorded.
std::vector<Plot> trace_plots(const RunGrid& runs);
/// Wall seconds of the stages of making the mesh.
std::vector<Plot> stage_plots(const RunGrid& runs);
/// Of all datasets: radius ratios over numbers of vertices and seconds over numbers of vertices.
std::vector<Plot> size_plots(const RunGrid& runs);
/// Over δ, a curve each ε; of the grids that sizing_grids() finds.
std::vector<Plot> sizing_plots(const Results& results);
/// The paper's Figure 3: how much nearer two particles with one between them are on a circle than on a line, and edge
/// lengths over the sizing field that they were asked for.
std::vector<Plot> contraction_plots(const std::vector<EdgesOverH>& over_h);

}  // namespace isobench
