// The parameters of a method. One declaration gives their defaults, their checks and their documentation.
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

/// The declaration of one parameter.
struct ParameterSpec {
  std::string name;
  ParameterValue default_value;  ///< its type is the type of the parameter
  std::string unit;              ///< "" if there is none
  std::string description;
  double min = -std::numeric_limits<double>::infinity();  ///< for numbers; min and max are allowed values
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< for strings; empty: any string is allowed
  bool integer = false;                   ///< for numbers
  bool required = false;                  ///< the default is not usable: a value must be given
  /// For strings: returns what is wrong with a value, to follow "'name': " in a message, or "".
  std::string (*problem)(const std::string& text) = nullptr;
};

using ParameterSchema = std::vector<ParameterSpec>;

/// A value for every parameter of a schema, checked against its declaration.
class Parameters {
 public:
  Parameters() = default;
  /// Every parameter at its default.
  explicit Parameters(const ParameterSchema& schema);

  /// Throws UsageError, which begins with `place`, for an unknown name (and suggests the nearest valid one), a wrong
  /// type, a value out of range or one that is not among the choices.
  void set(const ParameterSchema& schema, const std::string& name, const ParameterValue& value,
           const Place& place = {});
  /// The same for a value in text, such as a command line's `key=value`.
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
