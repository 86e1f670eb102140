// The page: everything of a results folder in one file that needs no network, no server and no scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/plots/plot.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

/// What there is to be shown beside the tables.
struct Exhibits {
  std::vector<Plot> plots;
  std::vector<std::string> drawn;  ///< names of the plots that are in plots/ as SVG
  std::vector<Picture> pictures;
  std::vector<TurnableFile> turnable;
  std::size_t across = 1;            ///< pictures in a row of a grid
  std::vector<std::string> shown;    ///< names of the plots that a part of the page has shown
  std::vector<std::string> missing;  ///< a sentence for each thing that could not be made, with the remedy
};

/// report.html. Reads the plots' and pictures' files from `folder`. The same results give the same bytes.
std::string page(const Results& results, Exhibits exhibits, const std::filesystem::path& folder);

// Its parts.
std::string summary_html(const Results& results);  ///< in words: what was compared, matched how, what held
std::string gaps_html(const Results& results);     ///< what is not done, failed, was skipped or is damaged
std::string claims_html(const Results& results);   ///< published beside measured
std::string plates_html(const Results& results, Exhibits& exhibits,
                        const std::filesystem::path& folder);  ///< the publication's figures, under their numbers
std::string turnable_html(const Exhibits& exhibits, const std::filesystem::path& folder);
std::string provenance_html(const Results& results);  ///< a fold a run
std::string citations_html(const Results& results);

/// A figure element each; `drawn` tells whether a plot has a file.
bool drawn(const Exhibits& exhibits, const Plot& plot);
std::string plot_html(const Plot& plot, const std::filesystem::path& folder);
std::string picture_html(const Picture& picture, const std::filesystem::path& folder);

}  // namespace isobench
