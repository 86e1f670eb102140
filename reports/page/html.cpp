#include "isobench/reports/page/html.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/metrics/metric.h"

namespace isobench {

namespace {

constexpr std::size_t most_open_rows = 60;  // longer tables are folded
constexpr std::size_t most_roomy_columns = 12;

// A cell is sorted by its first measured number. Without one, page.js takes the cell's text.
std::string sort_key(const TableCell& cell) {
  if (!cell.figures.empty() && std::isfinite(cell.figures.front().spread.median)) {
    return fmt::format(" data-sort=\"{}\"", cell.figures.front().spread.median);
  }
  return "";
}

std::string cell_html(const TableCell& cell, bool label) {
  TableCell measured = cell;
  measured.published.clear();
  measured.note.clear();
  std::string body = html_escaped(measured.text());
  if (!cell.note.empty()) body += "<span class=\"note\">" + html_escaped(cell.note) + "</span>";
  if (!cell.published.empty()) {
    TableCell published;
    published.published = cell.published;
    published.published_unit = cell.published_unit;
    body +=
        fmt::format("{}<span class=\"published\">{}</span>", body.empty() ? "" : " ", html_escaped(published.text()));
  }
  if (label) return fmt::format("<th scope=\"row\">{}</th>", body);
  const char* kind = !cell.figures.empty() ? " class=\"number\"" : !cell.note.empty() ? " class=\"noted\"" : "";
  return fmt::format("<td{}{}>{}</td>", kind, sort_key(cell), body);
}

std::string definitions_html(const Table& table) {
  std::string text;
  for (const std::string& name : table.definitions) {
    const FigureDeclaration& figure = declared_figure(name);
    text += fmt::format("<li><code>{}</code>{}: {}</li>\n", name,
                        figure.unit.empty() ? "" : " [" + html_escaped(figure.unit) + "]",
                        html_escaped(full_definition(figure)));
  }
  return text.empty() ? ""
                      : "<details><summary>Definitions of the figures</summary>\n<ul>\n" + text + "</ul></details>\n";
}

std::string classes_of(const Table& table) {
  const bool rows_depend_on_order = std::any_of(table.rows.begin(), table.rows.end(), [](const TableRow& row) {
    return row.empty() || row.front().text().empty();
  });
  const bool dense = table.header.size() > most_roomy_columns;
  if (rows_depend_on_order) return dense ? "dense" : "";
  return dense ? "sortable dense" : "sortable";
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string html_prose(std::string_view text) {
  std::string result;
  bool code = false;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('`', start), text.size());
    result += html_escaped(text.substr(start, end - start));
    if (end == text.size()) break;
    result += code ? "</code>" : "<code>";
    code = !code;
    start = end + 1;
  }
  return result + (code ? "</code>" : "");
}

std::string base64(const std::string& bytes) {
  std::string encoded(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(encoded.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  encoded.resize(static_cast<std::size_t>(length));
  return encoded;
}

std::string data_uri(const std::string& media_type, const std::string& bytes) {
  return "data:" + media_type + ";base64," + base64(bytes);
}

std::string html(const Table& table) {
  if (table.empty()) return "";
  std::string text = "<h3>" + html_escaped(table.title) + "</h3>\n";
  const bool folded = table.rows.size() > most_open_rows;
  if (folded) text += fmt::format("<details><summary>{} rows</summary>\n", table.rows.size());
  const std::string classes = classes_of(table);
  text += "<div class=\"wide\"><table" + (classes.empty() ? "" : " class=\"" + classes + "\"") + ">\n<thead><tr>";
  for (const std::string& column : table.header) text += "<th scope=\"col\">" + html_escaped(column) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const TableRow& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) text += cell_html(row[i], i < table.label_columns);
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  if (folded) text += "</details>\n";
  for (const std::string& remark : table.remarks) text += "<p class=\"remark\">" + html_prose(remark) + "</p>\n";
  if (!table.source.empty()) text += "<p class=\"remark\">" + html_escaped(table.source) + "</p>\n";
  return text + definitions_html(table);
}

}  // namespace isobench
