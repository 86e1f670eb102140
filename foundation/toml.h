// TOML with places: every value knows the file, line and column it came from, so that an error can name it.
// A thin handle over toml++, which is kept in toml.cpp because it compiles slowly.
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

/// A value of a TOML document; cheap to copy, keeps its document alive.
class TomlValue {
 public:
  /// Throws UsageError: with the place of a syntax error, or where the file cannot be read.
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

  // Each throws UsageError at the value's place if the type is another one.
  double as_number() const;  ///< an integer or a floating-point number, but not nan
  std::int64_t as_integer() const;
  bool as_bool() const;
  std::string as_string() const;
  std::vector<TomlValue> as_array() const;
  /// An array's elements, or the value itself as the only element.
  std::vector<TomlValue> as_list() const;

  /// The keys of a table, in file order.
  std::vector<std::string> keys() const;
  /// Throws UsageError at the first key that is not among `known`, with the nearest one. `what` names the table.
  void allow_keys(const std::vector<std::string>& known, const std::string& what) const;
  std::optional<TomlValue> find(const std::string& key) const;
  /// Throws UsageError at the table's place if the key is missing.
  TomlValue require(const std::string& key) const;

 private:
  struct Document;
  TomlValue(std::shared_ptr<const Document> document, const void* node, std::string name)
      : document_(std::move(document)), node_(node), name_(std::move(name)) {}
  [[noreturn]] void fail(const std::string& expected) const;

  std::shared_ptr<const Document> document_;
  const void* node_;  ///< a toml::node
  std::string name_;  ///< what an error calls the value: its key; "" for the document itself
};

}  // namespace isobench
