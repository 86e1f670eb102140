// The figures of the publication, by number, made from our pictures and plots.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"

namespace isobench {

namespace {

using Panels = std::vector<std::string>;

// The pictures of a data set, method by method; each method's shots in the given order.
Panels pictures_of(const Exhibits& exhibits, const std::string& dataset, const std::vector<const char*>& shots,
                   const std::filesystem::path& folder) {
  std::vector<std::string> methods;
  for (const Picture& picture : exhibits.pictures) {
    const bool known = std::find(methods.begin(), methods.end(), picture.title) != methods.end();
    if (picture.dataset == dataset && !known) methods.push_back(picture.title);
  }
  Panels panels;
  for (const std::string& method : methods) {
    for (const char* shot : shots) {
      for (const Picture& picture : exhibits.pictures) {
        if (picture.dataset == dataset && picture.title == method && picture.shot == shot)
          panels.push_back(picture_html(picture, folder));
      }
    }
  }
  return panels;
}

// Five pictures of one run, from the medial axis to the mesh: the first run that kept its artefacts.
Panels pipeline(const Exhibits& exhibits, const std::string& dataset, const std::filesystem::path& folder) {
  const auto first = std::find_if(exhibits.pictures.begin(), exhibits.pictures.end(), [&dataset](const Picture& p) {
    return p.shot == shots::medial_axis && (dataset.empty() || p.dataset == dataset);
  });
  if (first == exhibits.pictures.end()) return {};
  Panels panels;
  for (const char* shot :
       {shots::medial_axis, shots::initial_sizing, shots::limited_sizing, shots::particles, shots::whole}) {
    for (const Picture& picture : exhibits.pictures) {
      if (picture.dataset == first->dataset && picture.title == first->title && picture.shot == shot)
        panels.push_back(picture_html(picture, folder));
    }
  }
  return panels;
}

Panels grid(const Exhibits& exhibits, const std::filesystem::path& folder) {
  Panels panels;
  for (const Picture& picture : exhibits.pictures) {
    if (picture.grid) panels.push_back(picture_html(picture, folder));
  }
  return panels;
}

Panels plots_of(Exhibits& exhibits, const std::vector<std::string>& kinds, const std::filesystem::path& folder) {
  Panels panels;
  for (const std::string& kind : kinds) {
    for (const Plot& plot : exhibits.plots) {
      if (plot.kind != kind || !drawn(exhibits, plot)) continue;
      panels.push_back(plot_html(plot, folder));
      exhibits.shown.push_back(plot.name);
    }
  }
  return panels;
}

// Our methods for the publication's first method, which is the one that it proposes.
std::vector<std::string> proposed_methods(const Results& results) {
  if (results.published->methods.empty()) return {};
  const PublishedMethod& first = results.published->methods.front();
  std::vector<std::string> names = first.beside;
  names.push_back(first.name);
  return names;
}

Panels proposed_pictures(const Results& results, const Exhibits& exhibits, const std::string& dataset,
                         const std::vector<const char*>& shots, const std::filesystem::path& folder) {
  Exhibits proposed;
  for (const std::string& method : proposed_methods(results)) {
    std::copy_if(exhibits.pictures.begin(), exhibits.pictures.end(), std::back_inserter(proposed.pictures),
                 [&method](const Picture& picture) { return picture.title == method && !picture.grid; });
  }
  return pictures_of(proposed, dataset, shots, folder);
}

Panels panels_of(const PublishedPlate& plate, const Results& results, Exhibits& exhibits,
                 const std::filesystem::path& folder) {
  if (plate.shows == "pipeline") return pipeline(exhibits, plate.dataset, folder);
  if (plate.shows == "sizing grid") return grid(exhibits, folder);
  if (plate.shows == "contraction") return plots_of(exhibits, {"contraction", "edge-over-h"}, folder);
  if (plate.shows == "edges over h0") return plots_of(exhibits, {"edge-over-h0"}, folder);
  if (plate.shows == "radius ratios") return plots_of(exhibits, {"radius-ratio"}, folder);
  if (plate.shows == "mesh")
    return proposed_pictures(results, exhibits, plate.dataset, {shots::whole, shots::closer}, folder);
  if (plate.shows == "particles") {
    return proposed_pictures(results, exhibits, plate.dataset,
                             {shots::particles, shots::particles_closer, shots::whole, shots::closer}, folder);
  }
  Panels panels = proposed_pictures(results, exhibits, plate.dataset, {shots::whole}, folder);
  panels.resize(std::min<std::size_t>(panels.size(), 1));
  for (std::string& panel : pictures_of(exhibits, plate.dataset, {shots::worst}, folder))
    panels.push_back(std::move(panel));
  return panels;
}

std::string what_it_needs(const PublishedPlate& plate) {
  const std::string of = plate.dataset.empty() ? "" : " of " + plate.dataset;
  if (plate.shows == "pipeline" || plate.shows == "particles" || plate.shows == "contraction")
    return "a finished run" + of + " with artefacts = true";
  if (plate.shows == "sizing grid") return "finished runs with several values of ε and δ";
  return "a finished run" + of;
}

}  // namespace

std::string plates_html(const Results& results, Exhibits& exhibits, const std::filesystem::path& folder) {
  if (!results.published || results.published->plates.empty()) return "";
  std::string text = fmt::format("<section id=\"figures\"><h2>Figures of {}, made with our meshes</h2>\n",
                                 html_escaped(results.published->short_source));
  for (const PublishedPlate& plate : results.published->plates) {
    const Panels panels = panels_of(plate, results, exhibits, folder);
    text += fmt::format("<h3 id=\"figure-{0}\">Figure {0}</h3>\n<p class=\"remark\">{1}</p>\n", plate.number,
                        html_escaped(plate.caption));
    if (panels.empty()) {
      text += "<p class=\"remark\">Not available. It needs " + html_escaped(what_it_needs(plate)) + ".</p>\n";
      continue;
    }
    const bool plots = plate.shows == "contraction" || plate.shows == "edges over h0" || plate.shows == "radius ratios";
    // The pipeline's pictures and the grid keep their rows on a window of any width.
    const std::size_t across = plate.shows == "pipeline" ? panels.size() : exhibits.across;
    const bool rows = plate.shows == "pipeline" || plate.shows == "sizing grid";
    text += rows ? fmt::format("<div class=\"figures grid\" style=\"--across:{}\">\n", across)
                 : fmt::format("<div class=\"figures{}\">\n", plots ? "" : " pictures");
    text += fmt::format("{}</div>\n", fmt::join(panels, ""));
  }
  return text + "</section>\n";
}

}  // namespace isobench
