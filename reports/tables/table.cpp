#include "isobench/reports/tables/table.h"

#include <fmt/format.h>

#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

std::string CellFigure::text() const {
  const std::string low = print(spread.min);
  const std::string high = print(spread.max);
  const std::string middle = print(spread.median);
  return low == high ? middle : fmt::format("{} ({}–{})", middle, low, high);
}

std::string TableCell::text() const {
  std::string body = words_and_note() + (reason.empty() ? "" : ": " + reason);
  for (std::size_t i = 0; i < figures.size(); ++i) body += (i == 0 ? "" : " / ") + figures[i].text();
  if (!figures.empty() && !unit.empty()) body += " " + unit;
  body += mark;
  if (published.empty()) return body;
  const std::string theirs =
      fmt::format("published {}{}{}", fmt::join(published, " / "), published_unit.empty() ? "" : " ", published_unit);
  return body.empty() ? theirs : body + " (" + theirs + ")";
}

std::string markdown(const Table& table) {
  if (table.empty()) return "";
  MarkdownTable cells(table.header);
  for (const TableRow& row : table.rows) {
    std::vector<std::string> texts;
    for (const TableCell& cell : row) texts.push_back(cell.text());
    cells.add(std::move(texts));
  }
  std::string text = heading(table.title) + cells.text();
  for (const std::string& remark : table.remarks) text += "\n" + remark + "\n";
  text += definitions(table.definitions);
  return table.source.empty() ? text : text + "\n" + table.source + " See the section on the published figures.\n";
}

}  // namespace isobench
