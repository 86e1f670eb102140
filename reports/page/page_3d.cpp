// Meshes in 3D: links to their files, and small copies for the page's script (view_3d.js).
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"

namespace isobench {

namespace {

// All different values, in the order in which they occur.
template <class Of>
std::vector<std::string> distinct(const std::vector<TurnableFile>& files, Of&& of) {
  std::vector<std::string> all;
  for (const TurnableFile& file : files) {
    if (std::find(all.begin(), all.end(), of(file)) == all.end()) all.push_back(of(file));
  }
  return all;
}

std::string cell_html(const Exhibits& exhibits, const std::string& dataset, const std::string& method) {
  std::string attributes;
  std::string link = "–";
  for (std::size_t n = 0; n < exhibits.turnable.size(); ++n) {
    const TurnableFile& file = exhibits.turnable[n];
    if (file.dataset != dataset || file.method != method) continue;
    attributes += fmt::format(" data-{}=\"mesh-{}\"", file.worst_place ? "worst" : "whole", n);
    link =
        fmt::format("<a href=\"{}/mesh.vtp\" title=\"{} triangles\">VTP</a>", html_escaped(file.run), file.triangles);
    if (!file.worst_place) attributes += fmt::format(" data-triangles=\"{}\"", file.triangles);
  }
  return fmt::format("<td{}>{}</td>", attributes, link);
}

}  // namespace

std::string turnable_html(const Exhibits& exhibits, const std::filesystem::path& folder) {
  if (exhibits.turnable.empty()) return "";
  std::string text =
      "<section id=\"turn\"><h2>Meshes in 3D</h2>\n<p class=\"remark\">Open the VTP files, which hold the "
      "meshes and their measurements, with a program such as ParaView. <span class=\"unscripted\">If scripts are "
      "allowed, this page shows the meshes, too.</span></p>\n<div class=\"wide\"><table class=\"turn\"><thead><tr><th "
      "scope=\"col\">Data</th>";
  const auto methods = distinct(exhibits.turnable, [](const TurnableFile& file) { return file.method; });
  for (const std::string& method : methods) text += "<th scope=\"col\">" + html_escaped(method) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const std::string& dataset :
       distinct(exhibits.turnable, [](const TurnableFile& file) { return file.dataset; })) {
    text += "<tr><th scope=\"row\">" + html_escaped(dataset) + "</th>";
    for (const std::string& method : methods) text += cell_html(exhibits, dataset, method);
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  for (std::size_t n = 0; n < exhibits.turnable.size(); ++n) {
    // The browser neither runs nor shows this text; view_3d.js reads it.
    text += fmt::format("<script type=\"text/plain\" id=\"mesh-{}\">{}</script>\n", n,
                        base64(read_text(folder / exhibits.turnable[n].file)));
  }
  return text + "</section>\n";
}

}  // namespace isobench
