// [[claim]] of a file of published figures.
#include "isobench/reports/published/published_claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "isobench/reports/published/published.h"
#include "isobench/reports/record/figure_values.h"

namespace isobench {

namespace {

const std::vector<std::pair<std::string, Relation>>& relations() {
  static const std::vector<std::pair<std::string, Relation>> all = {{"~", Relation::about},
                                                                    {"<", Relation::below},
                                                                    {">", Relation::above},
                                                                    {"<<", Relation::far_below},
                                                                    {">>", Relation::far_above}};
  return all;
}

std::string known_name(const TomlValue& value, const std::string& name, const std::string& what,
                       const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw UsageError(value.place(), "unknown " + what + " '" + name + "'" + suggestion(name, known));
  }
  return name;
}

std::vector<std::string> printed_methods(const Published& published) {
  std::vector<std::string> names;
  for (const PublishedMethod& method : published.methods) names.push_back(method.printed);
  return names;
}

Relation relation_from(const TomlValue& order, const std::string& sign) {
  std::vector<std::string> known;
  for (const auto& [text, relation] : relations()) {
    if (text == sign) return relation;
    known.push_back(text);
  }
  throw UsageError(order.place(), fmt::format("'{}' is no relation between two methods; the known ones are: {}", sign,
                                              fmt::join(known, ", ")));
}

bool upward(Relation relation) { return relation == Relation::below || relation == Relation::far_below; }
bool downward(Relation relation) { return relation == Relation::above || relation == Relation::far_above; }

void read_order(PublishedClaim& claim, const TomlValue& order, const Published& published) {
  std::istringstream words(order.as_string());
  for (std::string word; words >> word;) {
    if (claim.order.size() == claim.relations.size())
      claim.order.push_back(known_name(order, word, "published method", printed_methods(published)));
    else
      claim.relations.push_back(relation_from(order, word));
  }
  if (claim.order.size() < 2 || claim.order.size() == claim.relations.size()) {
    throw UsageError(order.place(),
                     "an order needs at least two methods and a sign between each two, e.g. \"ps > af > mc\"");
  }
  // "a > b < c" says nothing about a and c, so nothing could be tested where b was not run.
  if (std::any_of(claim.relations.begin(), claim.relations.end(), upward) &&
      std::any_of(claim.relations.begin(), claim.relations.end(), downward)) {
    throw UsageError(order.place(), "an order must not mix '>' and '<'; split it into two claims");
  }
}

double positive(const TomlValue& value, double at_least, const std::string& what) {
  const double number = value.as_number();
  if (!(number > at_least)) {
    throw UsageError(value.place(), fmt::format("{} is {}; it must be more than {}", what, number, at_least));
  }
  return number;
}

// `about` says what "~" means, `much` what ">>" and "<<" mean: each is required where its sign occurs, and refused
// elsewhere.
double meaning_of(const TomlValue& table, const std::string& key, const std::string& sign, bool used, double at_least) {
  const std::optional<TomlValue> value = table.find(key);
  if (used && !value) throw UsageError(table.place(), "the order uses '" + sign + "' but '" + key + "' is missing");
  if (!used && value)
    throw UsageError(value->place(), "'" + key + "' explains '" + sign + "', which this claim does not use; remove it");
  return value ? positive(*value, at_least, key) : 0.0;
}

void read_meanings(PublishedClaim& claim, const TomlValue& table) {
  const auto uses = [&claim](Relation relation) {
    return std::find(claim.relations.begin(), claim.relations.end(), relation) != claim.relations.end();
  };
  claim.about = meaning_of(table, "about", "~", uses(Relation::about), 0.0);
  claim.much = meaning_of(table, "much", ">>", uses(Relation::far_above) || uses(Relation::far_below), 1.0);
}

void read_trend(PublishedClaim& claim, const TomlValue& table) {
  const std::optional<TomlValue> smaller = table.find("smaller");
  if (!smaller) return;
  claim.smaller = known_name(*smaller, smaller->as_string(), "sampling parameter", {"epsilon", "delta"});
  const TomlValue gives = table.require("gives");
  claim.gives_larger = known_name(gives, gives.as_string(), "trend", {"smaller", "larger"}) == "larger";
}

void read_bounds(PublishedClaim& claim, const TomlValue& table) {
  if (const auto bound = table.find("at_most")) claim.at_most = bound->as_number();
  if (const auto bound = table.find("at_least")) claim.at_least = bound->as_number();
}

Tendency tendency_from(const TomlValue& value) {
  const std::string name = known_name(value, value.as_string(), "tendency", {"larger", "smaller", "neither"});
  if (name == "neither") return Tendency::neither;
  return name == "larger" ? Tendency::larger : Tendency::smaller;
}

std::optional<AcrossMethods> across_methods_from(const TomlValue& table) {
  const std::optional<TomlValue> value = table.find("across_methods");
  if (!value) return std::nullopt;
  value->allow_keys({"larger", "gives", "tau"}, "across_methods");
  AcrossMethods across;
  const TomlValue larger = value->require("larger");
  across.larger = known_name(larger, larger.as_string(), "figure", figure_names());
  across.gives = tendency_from(value->require("gives"));
  const TomlValue tau = value->require("tau");
  across.tau = positive(tau, 0.0, "tau");
  if (across.tau > 1.0) {
    throw UsageError(tau.place(), fmt::format("tau is {}; a rank correlation is never more than 1", across.tau));
  }
  return across;
}

std::optional<Convergence> convergence_from(const TomlValue& table) {
  const std::optional<TomlValue> value = table.find("convergence");
  if (!value) return std::nullopt;
  value->allow_keys({"at_least", "at_most"}, "convergence");
  Convergence convergence;
  if (const auto bound = value->find("at_least")) convergence.at_least = bound->as_number();
  if (const auto bound = value->find("at_most")) convergence.at_most = bound->as_number();
  if (!convergence.at_least && !convergence.at_most)
    throw UsageError(value->place(), "convergence needs at_least, at_most or both");
  if (convergence.at_least && convergence.at_most && *convergence.at_least > *convergence.at_most) {
    throw UsageError(value->place(), fmt::format("no order of convergence is at least {} and at most {}",
                                                 *convergence.at_least, *convergence.at_most));
  }
  return convergence;
}

void check_method(const PublishedClaim& claim, const TomlValue& table) {
  const bool about_all = !claim.order.empty() || claim.across_methods;
  if (about_all && !claim.method.empty()) {
    throw UsageError(table.place(), claim.across_methods ? "across_methods is about all methods; remove 'method'"
                                                         : "the order names the methods; remove 'method'");
  }
  if (!about_all && !claim.convergence && claim.method.empty()) {
    throw UsageError(table.place(), "the claim needs 'method' to say which method it is about");
  }
}

void check_form(const PublishedClaim& claim, const TomlValue& table) {
  const int forms = (claim.order.empty() ? 0 : 1) + (claim.at_most || claim.at_least ? 1 : 0) +
                    (claim.smaller.empty() ? 0 : 1) + (claim.across_methods ? 1 : 0) + (claim.convergence ? 1 : 0);
  if (forms != 1) {
    throw UsageError(table.place(),
                     "a claim needs exactly one of: order; at_most or at_least; smaller with gives; across_methods; "
                     "convergence");
  }
  check_method(claim, table);
  if (claim.average && claim.order.empty()) {
    throw UsageError(table.place(), "data = \"average\" is only for a claim with 'order'; remove it");
  }
}

std::string quantity_of(const PublishedClaim& claim, const TomlValue& table, const Published& published) {
  std::vector<std::string> known;
  for (const PublishedQuantity& quantity : published.quantities) known.push_back(quantity.name);
  if (const auto named = table.find("published")) {
    return known_name(*named, named->as_string(), "published quantity", known);
  }
  const bool single = claim.figures.size() == 1;
  return single && std::find(known.begin(), known.end(), claim.figures.front()) != known.end() ? claim.figures.front()
                                                                                               : "";
}

}  // namespace

PublishedClaim claim_from(const TomlValue& table, const Published& published) {
  table.allow_keys({"words", "differs", "figure", "published", "order", "about", "much", "data", "method", "at_most",
                    "at_least", "smaller", "gives", "across_methods", "convergence"},
                   "[[claim]]");
  PublishedClaim claim;
  claim.words = table.require("words").as_string();
  if (const auto differs = table.find("differs")) claim.differs = differs->as_string();
  for (const TomlValue& figure : table.require("figure").as_list()) {
    claim.figures.push_back(known_name(figure, figure.as_string(), "figure", figure_names()));
  }
  if (claim.figures.empty()) throw UsageError(table.require("figure").place(), "figure is an empty list");
  claim.quantity = quantity_of(claim, table, published);
  if (const auto order = table.find("order")) read_order(claim, *order, published);
  read_meanings(claim, table);
  if (const auto data = table.find("data")) {
    claim.average = known_name(*data, data->as_string(), "value of 'data'", {"each", "average"}) == "average";
  }
  if (const auto method = table.find("method")) {
    claim.method = known_name(*method, method->as_string(), "published method", printed_methods(published));
  }
  read_bounds(claim, table);
  read_trend(claim, table);
  claim.across_methods = across_methods_from(table);
  claim.convergence = convergence_from(table);
  check_form(claim, table);
  return claim;
}

std::string to_string(Relation relation) {
  for (const auto& [sign, known] : relations()) {
    if (known == relation) return sign;
  }
  return "";
}

}  // namespace isobench
