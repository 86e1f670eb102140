#include "isobench/reports/published/published.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "isobench/foundation/toml.h"

namespace isobench {

namespace {

std::string text_or(const TomlValue& table, const std::string& key, const std::string& otherwise = "") {
  const std::optional<TomlValue> value = table.find(key);
  return value ? value->as_string() : otherwise;
}

std::vector<TomlValue> tables(const TomlValue& document, const std::string& key) {
  const std::optional<TomlValue> value = document.find(key);
  return value ? value->as_array() : std::vector<TomlValue>{};
}

PublishedMethod method_from(const TomlValue& table) {
  table.allow_keys({"printed", "name", "beside"}, "a published method");
  PublishedMethod method{table.require("printed").as_string(), table.require("name").as_string(), {}};
  if (const std::optional<TomlValue> beside = table.find("beside")) {
    for (const TomlValue& name : beside->as_list()) method.beside.push_back(name.as_string());
  }
  return method;
}

PublishedQuantity quantity_from(const TomlValue& table) {
  table.allow_keys({"name", "unit", "meaning"}, "a published quantity");
  return {table.require("name").as_string(), text_or(table, "unit"), text_or(table, "meaning")};
}

// Reads the printed number. "149 × 188 × 148" is not a number and leaves `value` empty.
void parse_printed(PublishedFigure& figure) {
  std::string number = figure.printed;
  if (number.starts_with("<")) {
    figure.bound = true;
    number = number.substr(1);
  }
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (end == number.c_str() || *end != '\0' || !std::isfinite(value)) return;
  figure.value = value;
  const std::size_t point = number.find('.');
  figure.decimals = point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

std::string our_name(const Published& published, const TomlValue& printed) {
  const std::string name = printed.as_string();
  std::vector<std::string> known;
  for (const PublishedMethod& method : published.methods) {
    if (method.printed == name) return method.name;
    known.push_back(method.printed);
  }
  throw UsageError(printed.place(), "unknown published method '" + name + "'" + suggestion(name, known));
}

void add_figures(Published& published, const TomlValue& table) {
  std::vector<std::string> keys = {"table", "method", "dataset"};
  for (const PublishedQuantity& quantity : published.quantities) keys.push_back(quantity.name);
  table.allow_keys(keys, "[[figures]]");
  PublishedFigure figure;
  figure.table = table.require("table").as_string();
  figure.dataset = table.require("dataset").as_string();
  if (const std::optional<TomlValue> method = table.find("method")) figure.method = our_name(published, *method);
  for (const PublishedQuantity& quantity : published.quantities) {
    const std::optional<TomlValue> printed = table.find(quantity.name);
    if (!printed) continue;
    PublishedFigure one = figure;
    one.quantity = quantity.name;
    one.printed = printed->as_string();
    parse_printed(one);
    published.figures.push_back(one);
  }
}

PublishedPlate plate_from(const TomlValue& table) {
  table.allow_keys({"number", "shows", "dataset", "caption"}, "[[plate]]");
  PublishedPlate plate;
  const TomlValue number = table.require("number");
  if (number.as_integer() < 1 || number.as_integer() > 1000) {
    throw UsageError(number.place(), fmt::format("number is {}; it must be 1 to 1000", number.as_integer()));
  }
  plate.number = static_cast<int>(number.as_integer());
  const TomlValue shows = table.require("shows");
  plate.shows = shows.as_string();
  if (std::find(plate_kinds().begin(), plate_kinds().end(), plate.shows) == plate_kinds().end()) {
    throw UsageError(shows.place(),
                     "unknown kind of plate '" + plate.shows + "'" + suggestion(plate.shows, plate_kinds()));
  }
  plate.dataset = text_or(table, "dataset");
  plate.caption = table.require("caption").as_string();
  return plate;
}

}  // namespace

const std::vector<std::string>& plate_kinds() {
  static const std::vector<std::string> kinds = {"pipeline",      "sizing grid", "contraction", "edges over h0",
                                                 "radius ratios", "mesh",        "particles",   "close-ups"};
  return kinds;
}

const PublishedMethod* Published::method_beside(const std::string& method) const {
  for (const PublishedMethod& candidate : methods) {
    if (candidate.name == method) return &candidate;
  }
  for (const PublishedMethod& candidate : methods) {
    if (std::find(candidate.beside.begin(), candidate.beside.end(), method) != candidate.beside.end()) {
      return &candidate;
    }
  }
  return nullptr;
}

const PublishedFigure* Published::find(const std::string& quantity, const std::string& dataset,
                                       const std::string& method) const {
  const PublishedMethod* beside = method_beside(method);
  const std::string name = beside != nullptr ? beside->name : method;
  for (const PublishedFigure& figure : figures) {
    if (figure.quantity == quantity && figure.dataset == dataset && figure.method == name) return &figure;
  }
  return nullptr;
}

Published read_published(const std::filesystem::path& path) {
  const TomlValue document = TomlValue::parse_file(path);
  document.allow_keys({"source", "short", "note", "method", "quantity", "figures", "claim", "plate"},
                      "a file of published figures");
  Published published;
  published.source = document.require("source").as_string();
  published.short_source = text_or(document, "short", published.source);
  published.note = text_or(document, "note");
  for (const TomlValue& table : tables(document, "method")) published.methods.push_back(method_from(table));
  for (const TomlValue& table : tables(document, "quantity")) published.quantities.push_back(quantity_from(table));
  for (const TomlValue& table : tables(document, "figures")) add_figures(published, table);
  for (const TomlValue& table : tables(document, "claim")) published.claims.push_back(claim_from(table, published));
  for (const TomlValue& table : tables(document, "plate")) published.plates.push_back(plate_from(table));
  return published;
}

}  // namespace isobench
