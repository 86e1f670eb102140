#include "isobench/datasets/manifests/manifest_generated.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/manifests/manifest_steps.h"
#include "isobench/datasets/manifests/manifest_values.h"

namespace isobench {

namespace {

double number_between(const TomlValue& table, const char* key, double least, double most, const char* unit) {
  const TomlValue value = table.require(key);
  const double number = value.as_number();
  if (!(number >= least && number <= most)) {
    throw UsageError(value.place(),
                     fmt::format("{} is {}; give a number from {} to {}{}", key, number, least, most, unit));
  }
  return number;
}

std::array<double, 2> parse_radii(const TomlValue& value) {
  const std::vector<TomlValue> list = value.as_array();
  if (list.size() != 2) throw UsageError(value.place(), "radii are two numbers, the smallest and the largest");
  const std::array<double, 2> radii{list[0].as_number(), list[1].as_number()};
  if (!(radii[0] >= 0.1 && radii[0] <= radii[1] && radii[1] <= most_generated_size)) {
    throw UsageError(value.place(), fmt::format("radii are [{}, {}]; give two numbers of voxels from 0.1 to {}, the "
                                                "smaller one first",
                                                radii[0], radii[1], most_generated_size));
  }
  return radii;
}

std::vector<std::string> keys_of(Generator generator) {
  std::vector<std::string> keys = {"generator", "seed", "size", "spacing"};
  const auto add = [&keys](std::initializer_list<const char*> more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (generator == Generator::random_field || generator == Generator::mask) add({"correlation", "quantile"});
  if (generator == Generator::foam) add({"bubbles", "wall"});
  if (generator == Generator::islands) add({"islands", "radii"});
  return keys;
}

}  // namespace

GeneratedRequest parse_generated(const TomlValue& table) {
  constexpr int most_things = 10000;  // more would take minutes
  GeneratedRequest request;
  table.require("generator");
  request.generator =
      parse_choice(table, "generator", {Generator::random_field, Generator::mask, Generator::foam, Generator::islands});
  table.allow_keys(keys_of(request.generator), fmt::format("[generated] of a {}", to_string(request.generator)));
  if (const auto seed = table.find("seed")) request.seed = static_cast<std::uint64_t>(parse_count(*seed, 0));
  request.size = parse_counts(table.require("size"), least_generated_size, most_generated_size);
  if (const auto spacing = table.find("spacing")) request.spacing = parse_triple(*spacing);
  switch (request.generator) {
    case Generator::random_field:
    case Generator::mask:
      request.correlation = number_between(table, "correlation", 0.5, 50.0, " voxels");
      request.quantile = number_between(table, "quantile", 0.01, 0.99, "");
      break;
    case Generator::foam:
      request.bubbles = parse_count(table.require("bubbles"), 2, most_things);
      request.wall = number_between(table, "wall", 0.5, 100.0, " voxels");
      break;
    case Generator::islands:
      request.islands = parse_count(table.require("islands"), 1, most_things);
      request.radii = parse_radii(table.require("radii"));
      break;
  }
  return request;
}

}  // namespace isobench
