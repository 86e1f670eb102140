#include "isobench/methods/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace isobench {

namespace {

// The alternatives of ParameterValue in words, in their order there.
const char* type_name(const ParameterValue& value) {
  static constexpr const char* kNames[] = {"true or false", "a number", "a string"};
  return kNames[value.index()];
}

const ParameterSpec& find_spec(const ParameterSchema& schema, const std::string& name, const Place& place) {
  std::vector<std::string> names;
  for (const ParameterSpec& spec : schema) {
    if (spec.name == name) return spec;
    names.push_back(spec.name);
  }
  if (names.empty()) throw UsageError(place, fmt::format("unknown parameter '{}'; the method has none", name));
  throw UsageError(place, fmt::format("unknown parameter '{}'{}", name, suggestion(name, names)));
}

std::string range_in_words(const ParameterSpec& spec) {
  const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
  const std::string kind = spec.integer ? "an integer" : "a number";
  if (std::isfinite(spec.min) && std::isfinite(spec.max)) {
    return fmt::format("{} from {} to {}{}", kind, spec.min, spec.max, unit);
  }
  if (std::isfinite(spec.min)) return fmt::format("{} of at least {}{}", kind, spec.min, unit);
  if (std::isfinite(spec.max)) return fmt::format("{} of at most {}{}", kind, spec.max, unit);
  return spec.integer ? kind : "a finite number";
}

bool in_range(const ParameterSpec& spec, double value) {
  if (!std::isfinite(value) || value < spec.min || value > spec.max) return false;
  // Parameters::integer() returns an int.
  return !spec.integer || (value == std::floor(value) && std::abs(value) <= std::numeric_limits<int>::max());
}

void check(const ParameterSpec& spec, const ParameterValue& value, const Place& place) {
  if (value.index() != spec.default_value.index()) {
    throw UsageError(
        place, fmt::format("'{}' must be {}, not {}", spec.name, type_name(spec.default_value), to_string(value)));
  }
  if (const auto* number = std::get_if<double>(&value); number != nullptr && !in_range(spec, *number)) {
    throw UsageError(place, fmt::format("'{}' must be {}, not {}", spec.name, range_in_words(spec), *number));
  }
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return;
  if (spec.problem != nullptr) {
    const std::string problem = spec.problem(*text);
    if (!problem.empty()) throw UsageError(place, fmt::format("'{}': {}", spec.name, problem));
  }
  if (spec.choices.empty()) return;
  if (std::find(spec.choices.begin(), spec.choices.end(), *text) != spec.choices.end()) return;
  throw UsageError(place, fmt::format("'{}' cannot be '{}'{}", spec.name, *text, suggestion(*text, spec.choices)));
}

ParameterValue parse(const ParameterSpec& spec, const std::string& text) {
  if (std::holds_alternative<bool>(spec.default_value)) {
    if (text == "true") return true;
    if (text == "false") return false;
  } else if (std::holds_alternative<double>(spec.default_value)) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end) return number;
  }
  return text;
}

template <typename Type>
const Type& get(const std::map<std::string, ParameterValue>& values, const std::string& name) {
  const auto found = values.find(name);
  const Type* value = found == values.end() ? nullptr : std::get_if<Type>(&found->second);
  // A mistake in the method, not in the user's input.
  if (value == nullptr) throw std::logic_error("the method's schema does not declare '" + name + "' with this type");
  return *value;
}

}  // namespace

std::string to_string(const ParameterValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

Parameters::Parameters(const ParameterSchema& schema) {
  for (const ParameterSpec& spec : schema) {
    if (spec.required)
      values_[spec.name] = spec.default_value;  // would not pass the check
    else
      set(schema, spec.name, spec.default_value);
  }
}

void Parameters::set(const ParameterSchema& schema, const std::string& name, const ParameterValue& value,
                     const Place& place) {
  check(find_spec(schema, name, place), value, place);
  values_[name] = value;
  // −0 becomes 0: the two are equal, but parameters are compared as text.
  if (auto* number = std::get_if<double>(&values_[name])) *number += 0.0;
}

void Parameters::set_text(const ParameterSchema& schema, const std::string& name, const std::string& text) {
  set(schema, name, parse(find_spec(schema, name, {}), text));
}

double Parameters::number(const std::string& name) const { return get<double>(values_, name); }

int Parameters::integer(const std::string& name) const {
  const double value = number(name);
  if (value != std::floor(value)) {
    throw std::logic_error("the method's schema does not declare '" + name + "' as an integer");
  }
  return static_cast<int>(value);
}

bool Parameters::flag(const std::string& name) const { return get<bool>(values_, name); }

const std::string& Parameters::text(const std::string& name) const { return get<std::string>(values_, name); }

}  // namespace isobench
