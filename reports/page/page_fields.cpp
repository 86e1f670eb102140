// Fields on the meshes: what simulations on them look like, and where they err.
#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"

namespace isobench {

std::string fields_html(const Exhibits& exhibits, const std::filesystem::path& folder) {
  std::string text;
  std::string group;
  for (const Picture& picture : exhibits.pictures) {
    if (picture.explanation.empty()) continue;
    if (picture.group != group) {
      text += (group.empty() ? "" : "</div>\n") + ("<h3>" + html_escaped(picture.group)) +
              "</h3>\n<p class=\"remark\">" + html_escaped(picture.explanation) +
              "</p>\n<div class=\"figures pictures\">\n";
      group = picture.group;
    }
    text += picture_html(picture, folder);
  }
  if (text.empty()) return "";
  return "<section id=\"fields\"><h2>What the meshes are worth to a simulation</h2>\n<p class=\"remark\">Each group of "
         "pictures has one view and one scale of colours.</p>\n" +
         text + "</div></section>\n";
}

}  // namespace isobench
