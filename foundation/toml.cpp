#include "isobench/foundation/toml.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

namespace isobench {

struct TomlValue::Document {
  toml::table root;
  std::string name;
};

struct TomlValue::Changes {
  std::map<std::string, TomlValue> values;         // of a table
  std::optional<std::vector<TomlValue>> elements;  // of an array
};

namespace {

const toml::node& as_node(const void* node) { return *static_cast<const toml::node*>(node); }

Place to_place(const toml::source_region& source, const std::string& name) {
  return {name, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

std::string with_article(const std::string& type) {
  return (std::string_view("aeiou").find(type.front()) != std::string_view::npos ? "an " : "a ") + type;
}

/// The keys of a table with their places; toml++ itself keeps them sorted by name.
std::vector<const toml::key*> keys_in_file_order(const toml::table& table) {
  std::vector<const toml::key*> keys;
  for (auto entry = table.cbegin(); entry != table.cend(); ++entry) keys.push_back(&entry->first);
  std::sort(keys.begin(), keys.end(),
            [](const toml::key* a, const toml::key* b) { return a->source().begin < b->source().begin; });
  return keys;
}

}  // namespace

TomlValue TomlValue::parse_file(const std::filesystem::path& path) {
  // Opening a directory succeeds, only reading from it fails.
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw UsageError({path.string()}, "cannot be read; give the path of a TOML file");
  }
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw UsageError({path.string()}, "reading failed before the end of the file");
  return parse_text(text, path.string());
}

TomlValue TomlValue::parse_text(const std::string& text, const std::string& name) {
  try {
    auto document = std::make_shared<Document>();
    document->root = toml::parse(std::string_view(text), std::string_view(name));
    document->name = name;
    const toml::node* root = &document->root;
    return {std::move(document), root, ""};
  } catch (const toml::parse_error& error) {
    throw UsageError(to_place(error.source(), name), std::string(error.description()));
  }
}

Place TomlValue::place() const { return to_place(as_node(node_).source(), document_->name); }

std::string TomlValue::type_name() const {
  switch (as_node(node_).type()) {
    case toml::node_type::table:
      return "table";
    case toml::node_type::array:
      return "array";
    case toml::node_type::string:
      return "string";
    case toml::node_type::integer:
      return "integer";
    case toml::node_type::floating_point:
      return "number";
    case toml::node_type::boolean:
      return "boolean";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
    case toml::node_type::none:
      break;
  }
  return "date or time";
}

bool TomlValue::is_table() const { return as_node(node_).is_table(); }
bool TomlValue::is_array() const { return as_node(node_).is_array(); }
bool TomlValue::is_string() const { return as_node(node_).is_string(); }
bool TomlValue::is_number() const { return as_node(node_).is_number(); }
bool TomlValue::is_bool() const { return as_node(node_).is_boolean(); }

const TomlValue::Changes& TomlValue::changes() const {
  static const Changes none;
  return changes_ ? *changes_ : none;
}

void TomlValue::fail(const std::string& expected) const {
  const std::string subject = name_.empty() ? "the document" : "'" + name_ + "'";
  throw UsageError(place(), subject + " must be " + with_article(expected) + ", not " + with_article(type_name()));
}

double TomlValue::as_number() const {
  if (!is_number()) fail("number");
  // toml++ refuses to convert integers that no double equals, such as 2^53 + 1.
  const auto* integer = as_node(node_).as_integer();
  const double value =
      integer != nullptr ? static_cast<double>(integer->get()) : as_node(node_).as_floating_point()->get();
  if (std::isnan(value)) throw UsageError(place(), "'" + name_ + "' must be a number, not nan");
  return value;
}

std::int64_t TomlValue::as_integer() const {
  const auto* value = as_node(node_).as_integer();
  if (value == nullptr) fail("integer");
  return value->get();
}

bool TomlValue::as_bool() const {
  const auto* value = as_node(node_).as_boolean();
  if (value == nullptr) fail("boolean");
  return value->get();
}

std::string TomlValue::as_string() const {
  const auto* value = as_node(node_).as_string();
  if (value == nullptr) fail("string");
  return value->get();
}

std::vector<TomlValue> TomlValue::as_array() const {
  const auto* array = as_node(node_).as_array();
  if (array == nullptr) fail("array");
  if (changes().elements) return *changes().elements;
  std::vector<TomlValue> elements;
  for (const toml::node& element : *array) elements.push_back(TomlValue(document_, &element, name_));
  return elements;
}

std::vector<TomlValue> TomlValue::as_list() const { return is_array() ? as_array() : std::vector<TomlValue>{*this}; }

std::vector<std::string> TomlValue::keys() const {
  const auto* table = as_node(node_).as_table();
  if (table == nullptr) fail("table");
  std::vector<std::string> names;
  for (const toml::key* key : keys_in_file_order(*table)) names.emplace_back(key->str());
  for (const auto& [key, value] : changes().values) {
    if (!table->contains(std::string_view(key))) names.push_back(key);
  }
  return names;
}

void TomlValue::allow_keys(const std::vector<std::string>& known, const std::string& what) const {
  const auto* table = as_node(node_).as_table();
  if (table == nullptr) fail("table");
  for (const toml::key* key : keys_in_file_order(*table)) {
    const std::string name(key->str());
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(to_place(key->source(), document_->name),
                     fmt::format("unknown key '{}' in {}{}", name, what, suggestion(name, known)));
  }
  for (const auto& [name, value] : changes().values) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(value.place(), fmt::format("unknown key '{}' in {}{}", name, what, suggestion(name, known)));
  }
}

std::optional<TomlValue> TomlValue::find(const std::string& key) const {
  const auto* table = as_node(node_).as_table();
  if (table == nullptr) fail("table");
  if (const auto changed = changes().values.find(key); changed != changes().values.end()) return changed->second;
  const toml::node* node = table->get(std::string_view(key));
  if (node == nullptr) return std::nullopt;
  return TomlValue(document_, node, key);
}

TomlValue TomlValue::require(const std::string& key) const {
  std::optional<TomlValue> value = find(key);
  if (!value) {
    const std::string where = name_.empty() ? "" : " in '" + name_ + "'";
    throw UsageError(place(), "the key '" + key + "' is missing" + where);
  }
  return *value;
}

TomlValue TomlValue::with(const std::string& key, const TomlValue& value) const {
  if (!is_table()) fail("table");
  auto now = std::make_shared<Changes>(changes());
  now->values.insert_or_assign(key, value).first->second.name_ = key;
  TomlValue changed = *this;
  changed.changes_ = std::move(now);
  return changed;
}

TomlValue TomlValue::with_elements(std::vector<TomlValue> elements) const {
  if (!is_array()) fail("array");
  auto now = std::make_shared<Changes>();
  now->elements = std::move(elements);
  TomlValue changed = *this;
  changed.changes_ = std::move(now);
  return changed;
}

}  // namespace isobench
