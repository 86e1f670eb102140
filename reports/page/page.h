// report.html: a whole results folder in one file. Reading it needs no network, no server and no scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/plots/plot.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

/// What the page shows beside tables and words.
struct Exhibits {
  std::vector<Plot> plots;
  std::vector<std::string> drawn;  ///< names of the plots that have an SVG file in plots/
  std::vector<Picture> pictures;
  std::vector<TurnableFile> turnable;
  std::size_t across = 1;            ///< number of pictures in a row of the grid of ε and δ
  std::vector<std::string> shown;    ///< names of the plots that the page shows already
  std::vector<std::string> missing;  ///< one sentence for each thing that could not be made, with the remedy
};

/// The text of report.html. Reads the files of plots and pictures from `folder`. The same results give the same bytes.
std::string page(const Results& results, Exhibits exhibits, const std::filesystem::path& folder);

// Sections of the page; "" if a section would be empty.

/// What a reader looks at first: who is best at what, in one line, and the same close-up of each method side by side.
std::string opening_html(const Results& results, const Exhibits& exhibits, const std::filesystem::path& folder);
/// Pictures of the worst triangle of each method over many data sets; "" if there are few.
std::string worst_html(const Results& results, const Exhibits& exhibits, const std::filesystem::path& folder);
/// The tables with rows of single data sets, folded and cut short; "" if there are few data sets.
std::string details_html(const Results& results);
/// What was compared, what was matched, which claims held, and which methods are best.
std::string summary_html(const Results& results);
/// Runs that are not done, failed, were skipped or have a damaged record.
std::string gaps_html(const Results& results);
/// The claims of the publication, each with its verdict and both the measured and the published values.
std::string claims_html(const Results& results);
/// The figures of the publication, by number, made from our pictures and plots. Adds these plots to `exhibits.shown`.
std::string plates_html(const Results& results, Exhibits& exhibits, const std::filesystem::path& folder);
/// Pictures of the fields that metrics kept with the meshes, such as the result of a simulation.
std::string fields_html(const Exhibits& exhibits, const std::filesystem::path& folder);
/// Links to the meshes, and copies of them that the page's script shows in 3D.
std::string turnable_html(const Exhibits& exhibits, const std::filesystem::path& folder);
/// How each run was made, one fold for each run.
std::string provenance_html(const Results& results);
/// How to cite the program, the published figures and the data.
std::string citations_html(const Results& results);

/// Whether a plot has a file.
bool drawn(const Exhibits& exhibits, const Plot& plot);
/// A <figure> element with the preview of a picture. `caption` is HTML.
std::string figure_html(const Picture& picture, const std::string& description, const std::string& caption,
                        const std::filesystem::path& folder);
/// A <figure> element.
std::string plot_html(const Plot& plot, const std::filesystem::path& folder);
std::string picture_html(const Picture& picture, const std::filesystem::path& folder);

}  // namespace isobench
