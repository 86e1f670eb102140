#include <fmt/format.h>

#include <cmath>

#include "isobench/experiments/plan/config_readers.h"
#include "isobench/foundation/error.h"

namespace isobench {

std::vector<TomlValue> nonempty_list(const TomlValue& value, const std::string& what) {
  std::vector<TomlValue> list = value.as_list();
  if (list.empty()) throw UsageError(value.place(), what + " is an empty list; give at least one value");
  return list;
}

double positive(const TomlValue& value, const std::string& what) {
  const double number = value.as_number();
  if (!std::isfinite(number) || number <= 0.0) {
    throw UsageError(value.place(), fmt::format("{} is {}; expected a finite number > 0", what, number));
  }
  return number;
}

int whole_number(const TomlValue& value, const std::string& what, int least, int most) {
  const std::int64_t number = value.as_integer();
  if (number < least || number > most) {
    throw UsageError(value.place(),
                     fmt::format("{} is {}; expected a whole number from {} to {}", what, number, least, most));
  }
  return static_cast<int>(number);
}

ParameterValue parameter_value(const TomlValue& value) {
  if (value.is_bool()) return value.as_bool();
  if (value.is_number()) return value.as_number();
  return value.as_string();
}

std::string printable_line(const TomlValue& value, const std::string& what, std::size_t longest) {
  std::string text = value.as_string();
  if (text.size() > longest || printable(text) != text) {
    throw UsageError(value.place(), fmt::format("{} must be one printable line of at most {} bytes", what, longest));
  }
  return text;
}

}  // namespace isobench
