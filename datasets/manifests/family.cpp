#include "isobench/datasets/manifests/family.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/manifests/manifest_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

const std::vector<std::string>& varied_manifest_keys() {
  static const std::vector<std::string> keys = {"isovalue", "inside", "kernel"};
  return keys;
}

/// The steps of `prepare` that have this name.
std::vector<TomlValue> steps_named(const TomlValue& manifest, const std::string& name) {
  std::vector<TomlValue> found;
  const auto steps = manifest.find("prepare");
  if (!steps) return found;
  for (const TomlValue& step : steps->as_array()) {
    if (step.require("step").as_string() == name) found.push_back(step);
  }
  return found;
}

/// The table outside [family] in which a key of [family] is to be set.
TomlValue table_of(const TomlValue& manifest, const FamilyKey& key) {
  if (key.table.empty()) return manifest;
  if (key.table == "generated") return manifest.require("generated");
  return steps_named(manifest, key.table).front();
}

FamilyKey parse_family_key(const TomlValue& manifest, const std::string& table, const TomlValue& list,
                           const std::string& name) {
  FamilyKey key{table, name, list.as_array()};
  if (key.values.empty()) throw UsageError(list.place(), fmt::format("{} lists no value; give at least one", name));
  if (const auto fixed = table_of(manifest, key).find(name)) {
    throw UsageError(fixed->place(), fmt::format("'{}' stands in [family], too; keep it in one place", name));
  }
  return key;
}

void parse_step_keys(const TomlValue& manifest, const std::string& step, const TomlValue& table, Family& family) {
  const std::size_t count = steps_named(manifest, step).size();
  if (count != 1) {
    throw UsageError(table.place(), fmt::format("prepare has {} steps '{}'; [family] can vary a step that it has once",
                                                count == 0 ? "no" : std::to_string(count), step));
  }
  for (const std::string& name : table.keys())
    family.keys.push_back(parse_family_key(manifest, step, table.require(name), name));
}

/// Refuses members that nothing tells apart.
void check_members(const TomlValue& members, const Family& family, bool generated) {
  double combinations = 1.0;
  for (const FamilyKey& key : family.keys) combinations *= static_cast<double>(key.values.size());
  if (!generated && family.members > combinations) {
    throw UsageError(members.place(), fmt::format("{} members are asked for, but the lists have {} combinations; give "
                                                  "fewer members, or more values",
                                                  family.members, combinations));
  }
}

std::vector<std::size_t> digits_of(const Family& family, int member) {
  std::vector<std::size_t> digits;
  const auto n = static_cast<std::size_t>(member - 1);
  std::size_t product = 1;  // at most a little more than n: beyond it, n / product is 0 and n mod product is n
  for (const FamilyKey& key : family.keys) {
    digits.push_back((n / product + n % product) % key.values.size());
    if (product <= n) product *= key.values.size();
  }
  return digits;
}

/// A value in one line, as in TOML, but texts without quotes.
std::string value_text(const TomlValue& value) {
  if (value.is_string()) return value.as_string();
  if (value.is_number()) return fmt::format("{}", value.as_number());
  if (value.is_bool()) return value.as_bool() ? "true" : "false";
  std::string text;
  for (const TomlValue& element : value.as_array()) text += (text.empty() ? "" : ", ") + value_text(element);
  return "[" + text + "]";
}

TomlValue with_step_value(const TomlValue& manifest, const FamilyKey& key, const TomlValue& value) {
  const TomlValue steps = manifest.require("prepare");
  std::vector<TomlValue> changed;
  for (const TomlValue& step : steps.as_array())
    changed.push_back(step.require("step").as_string() == key.table ? step.with(key.name, value) : step);
  return manifest.with("prepare", steps.with_elements(std::move(changed)));
}

}  // namespace

std::optional<Family> parse_family(const TomlValue& manifest, const std::string& name) {
  const auto table = manifest.find("family");
  if (!table) return std::nullopt;
  const bool generated = manifest.find("generated").has_value();
  Family family;
  family.name = name;
  family.title = manifest.require("title").as_string();
  if (const auto group = table->find("name")) family.name = group->as_string();
  const TomlValue members = table->require("members");
  family.members = parse_count(members, 1, most_members);
  for (const std::string& key : table->keys()) {
    if (key == "name" || key == "members") continue;
    const TomlValue value = table->require(key);
    const std::vector<std::string>& own = varied_manifest_keys();
    if (value.is_table())
      parse_step_keys(manifest, key, value, family);
    else if (std::find(own.begin(), own.end(), key) != own.end())
      family.keys.push_back(parse_family_key(manifest, "", value, key));
    else if (generated)
      family.keys.push_back(parse_family_key(manifest, "generated", value, key));
    else
      throw UsageError(value.place(), fmt::format("unknown key '{}' in [family]{}", key, suggestion(key, own)));
  }
  check_members(members, family, generated);
  return family;
}

TomlValue member_manifest(const TomlValue& manifest, const Family& family, int member) {
  TomlValue own = manifest;
  const std::vector<std::size_t> digits = digits_of(family, member);
  for (std::size_t n = 0; n < digits.size(); ++n) {
    const FamilyKey& key = family.keys[n];
    const TomlValue& value = key.values[digits[n]];
    if (key.table.empty())
      own = own.with(key.name, value);
    else if (key.table == "generated")
      own = own.with("generated", own.require("generated").with(key.name, value));
    else
      own = with_step_value(own, key, value);
  }
  return own;
}

std::string member_text(const Family& family, int member) {
  std::string text;
  const std::vector<std::size_t> digits = digits_of(family, member);
  for (std::size_t n = 0; n < digits.size(); ++n) {
    const FamilyKey& key = family.keys[n];
    const bool in_step = !key.table.empty() && key.table != "generated";
    text += fmt::format("{}{}{} {}", text.empty() ? "" : ", ", in_step && key.table != key.name ? key.table + " " : "",
                        key.name, value_text(key.values[digits[n]]));
  }
  return text;
}

std::string member_number(const Family& family, int member) {
  return fmt::format("{:0{}}", member, std::to_string(family.members).size());
}

std::string members_text(const Family& family, const std::string& manifest) {
  return fmt::format("{}-{} … -{}", manifest, member_number(family, 1), member_number(family, family.members));
}

}  // namespace isobench
