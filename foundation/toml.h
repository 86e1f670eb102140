// TOML in which every value knows its file, line and column, so that errors can name them. Wraps toml++, which only
// toml.cpp includes because it compiles slowly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

/// A value of a TOML document. It is cheap to copy and keeps the document alive.
class TomlValue {
 public:
  /// Throws UsageError if the file cannot be read or, with the place, for a syntax error.
  static TomlValue parse_file(const std::filesystem::path& path);
  static TomlValue parse_text(const std::string& text, const std::string& name);

  /// The file as the caller of parse_file() gave it, or the `name` given to parse_text().
  Place place() const;
  std::string type_name() const;  ///< "table", "array", "string", "integer", "number", "boolean", "date or time"

  bool is_table() const;
  bool is_array() const;
  bool is_string() const;
  bool is_number() const;  ///< integer or floating point
  bool is_bool() const;

  // These throw UsageError with the value's place if it has another type.
  double as_number() const;  ///< an integer or a floating-point number, but not nan
  std::int64_t as_integer() const;
  bool as_bool() const;
  std::string as_string() const;
  std::vector<TomlValue> as_array() const;
  /// The elements of an array; any other value counts as an array of itself.
  std::vector<TomlValue> as_list() const;

  /// The keys of a table, in file order.
  std::vector<std::string> keys() const;
  /// Throws UsageError for the first key that is not in `known` and suggests the nearest one. `what` names the table.
  void allow_keys(const std::vector<std::string>& known, const std::string& what) const;
  std::optional<TomlValue> find(const std::string& key) const;
  /// Throws UsageError with the table's place if the key is missing.
  TomlValue require(const std::string& key) const;

  // Copies that differ from the file. Every value keeps the place that it has in its own file.

  /// A table like this one, in which `key` has this value.
  TomlValue with(const std::string& key, const TomlValue& value) const;
  /// An array like this one, with these elements.
  TomlValue with_elements(std::vector<TomlValue> elements) const;

 private:
  struct Document;
  struct Changes;
  TomlValue(std::shared_ptr<const Document> document, const void* node, std::string name)
      : document_(std::move(document)), node_(node), name_(std::move(name)) {}
  [[noreturn]] void fail(const std::string& expected) const;
  const Changes& changes() const;

  std::shared_ptr<const Document> document_;
  const void* node_;  ///< a toml::node
  std::string name_;  ///< the key, for error messages; "" for the document itself
  std::shared_ptr<const Changes> changes_;
};

}  // namespace isobench
