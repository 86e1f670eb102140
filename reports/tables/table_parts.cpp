#include "isobench/reports/tables/table_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/runs/timing.h"

namespace isobench {

namespace {

std::string unit_of(const Published& published, const std::string& quantity) {
  for (const PublishedQuantity& candidate : published.quantities) {
    if (candidate.name == quantity && !candidate.unit.empty()) return candidate.unit;
  }
  return "";
}

// A reason may be a paragraph with the end of a log. A table cell has room for one line; run.json has all of it.
std::string shortened(const std::string& reason) {
  constexpr std::size_t longest = 120;
  if (reason.size() <= longest) return reason;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(reason[end]) & 0xC0U) == 0x80U) --end;
  return reason.substr(0, end) + "…";
}

}  // namespace

std::string dagger(const RunRecord& record) { return record.measurement && !is_closed_manifold(record) ? " †" : ""; }

std::string marks(const RunRecord& record) {
  const std::string open = dagger(record);
  return is_unmatched(record) ? (open.empty() ? " ‡" : open + "‡") : open;
}

std::string marks(const Runs& runs) {
  std::string all;
  for (const char* mark : {"†", "‡"}) {
    const Runs shown = counted_runs(runs);
    const bool any = std::any_of(shown.begin(), shown.end(),
                                 [mark](const RunRecord* run) { return marks(*run).find(mark) != std::string::npos; });
    if (any) all += mark;
  }
  return all.empty() ? "" : " " + all;
}

TableCell instead_of_figures(const RunRecord* record) {
  if (record == nullptr) return "not run";
  if (record->status == Status::ok) return {};
  TableCell cell(to_string(record->status));
  cell.reason = shortened(record->reason);
  return cell;
}

TableCell number_cell(double value, const Print& print) {
  TableCell cell;
  cell.figures.push_back({{value, value, value}, print});
  return cell;
}

TableCell over_all(const Runs& runs, const Figure& figure, const Print& print) {
  std::vector<double> values;
  for (const RunRecord* run : finished(runs)) values.push_back(figure(*run));
  TableCell cell;
  cell.figures.push_back({spread_of(std::move(values)), print});
  return cell;
}

TableCell over(const Runs& runs, const Figure& figure, const Print& print) {
  return over_all(counted_runs(runs), figure, print);
}

TableCell over_timed(const RunGrid& arrangement, const Runs& runs, const Figure& figure, const Print& print) {
  const Runs alike = runs_with_timing(counted_runs(runs), arrangement.timing);
  return alike.empty() ? TableCell("§") : over_all(alike, figure, print);
}

void say_how_timed(const RunGrid& arrangement, Table& table) {
  if (std::string remark = timing_remark(arrangement); !remark.empty()) table.remarks.push_back(std::move(remark));
}

TableCell beside(TableCell cell, const TableCell& next) {
  cell.figures.insert(cell.figures.end(), next.figures.begin(), next.figures.end());
  return cell;
}

TableCell with_published(TableCell cell, const Results& results, const std::vector<std::string>& quantities,
                         const std::string& dataset, const std::string& method) {
  if (!results.published) return cell;
  for (const std::string& quantity : quantities) {
    const PublishedFigure* figure = results.published->find(quantity, dataset, method);
    if (figure == nullptr) break;
    if (cell.published.empty()) cell.published_unit = unit_of(*results.published, quantity);
    cell.published.push_back(figure->printed);
  }
  return cell;
}

TableCell with_unit(TableCell cell, const std::string& unit) {
  cell.unit = unit;
  return cell;
}

TableCell with_mark(TableCell cell, const std::string& mark) {
  cell.mark += mark;
  return cell;
}

std::string definitions(const std::vector<std::string>& figures) {
  std::string text;
  for (const std::string& name : figures) {
    const FigureDeclaration& figure = declared_figure(name);
    text += fmt::format("- `{}`{}: {}\n", name, figure.unit.empty() ? "" : " [" + figure.unit + "]",
                        full_definition(figure));
  }
  return text.empty() ? "" : "\n" + text;
}

std::string source_line(const Results& results, const std::string& table) {
  if (!results.published) return "";
  const Published& published = *results.published;
  const bool any = std::any_of(published.figures.begin(), published.figures.end(),
                               [&table](const PublishedFigure& figure) { return figure.table == table; });
  if (!any) return "";
  return fmt::format("Published: {}, {}, measured on other data than ours; digits as printed there.",
                     published.short_source, table);
}

std::vector<const PublishedMethod*> published_alone(const Results& results, const RunGrid& runs,
                                                    const std::string& table) {
  std::vector<const PublishedMethod*> alone;
  if (!results.published) return alone;
  for (const PublishedMethod& method : results.published->methods) {
    const bool beside = std::any_of(runs.variants.begin(), runs.variants.end(), [&](const Variant& variant) {
      return results.published->method_beside(variant.method) == &method;
    });
    const bool printed = std::any_of(
        results.published->figures.begin(), results.published->figures.end(),
        [&](const PublishedFigure& figure) { return figure.table == table && figure.method == method.name; });
    if (!beside && printed) alone.push_back(&method);
  }
  return alone;
}

std::string heading(const std::string& title) { return "## " + title + "\n\n"; }

std::string plural(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

double vertices(const RunRecord& run) { return run.measurement->number("vertices"); }

}  // namespace isobench
