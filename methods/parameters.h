// A method's own parameters: declared once, and from that declaration checked, defaulted, documented and listed.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

using ParameterValue = std::variant<bool, double, std::string>;
std::string to_string(const ParameterValue& value);

/// One parameter as a method declares it.
struct ParameterSpec {
  std::string name;
  ParameterValue default_value;  ///< its type is the parameter's type
  std::string unit;              ///< "" where it has none
  std::string description;
  double min = -std::numeric_limits<double>::infinity();  ///< inclusive, for numbers
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< for strings; empty: any
  bool integer = false;                   ///< for numbers
  bool required = false;                  ///< the default is none that works: a value must be given
  /// For strings: what is wrong with one, to be read after "'name': "; "" where nothing is.
  std::string (*problem)(const std::string& text) = nullptr;
};

using ParameterSchema = std::vector<ParameterSpec>;

/// Values by name, complete and checked against a schema.
class Parameters {
 public:
  Parameters() = default;
  /// Every parameter at its default.
  explicit Parameters(const ParameterSchema& schema);

  /// Throws UsageError, with `place` in front, for an unknown name (with the nearest valid one), a wrong type, a value
  /// out of range or not among the choices.
  void set(const ParameterSchema& schema, const std::string& name, const ParameterValue& value,
           const Place& place = {});
  /// The same from text such as a command line's `key=value`.
  void set_text(const ParameterSchema& schema, const std::string& name, const std::string& text);

  double number(const std::string& name) const;
  int integer(const std::string& name) const;
  bool flag(const std::string& name) const;
  const std::string& text(const std::string& name) const;
  const std::map<std::string, ParameterValue>& all() const { return values_; }

 private:
  std::map<std::string, ParameterValue> values_;
};

}  // namespace isobench
