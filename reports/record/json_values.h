// Conversions that run.json and plan.json share.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "isobench/foundation/error.h"
#include "isobench/reports/record/record.h"

namespace isobench {

using Json = nlohmann::ordered_json;

// JSON has no numbers that are not finite; they become null.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

inline void read(const Json& json, double& value) {
  value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}
// Throws for 1e300, true and 2^40, which the library's own get<int>() accepts.
template <class Integer>
Integer integer(const Json& json) {
  const bool fits = json.is_number_unsigned()
                        ? std::in_range<Integer>(json.get<std::uint64_t>())
                        : json.is_number_integer() && std::in_range<Integer>(json.get<std::int64_t>());
  if (!fits) throw DataError(json.dump().substr(0, 40) + " is not a whole number, or is too large");
  return json.get<Integer>();
}
template <class Integer>
std::vector<Integer> integers(const Json& json) {
  std::vector<Integer> values;
  values.reserve(json.size());  // thousands of records are held at once
  for (const Json& value : json) values.push_back(integer<Integer>(value));
  return values;
}

template <class Integer>
void read(const Json& json, Integer& value) {
  value = integer<Integer>(json);
}

inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }
inline std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

// Notes and reasons may quote text that is not UTF-8. The library would throw; here the wrong bytes are replaced.
inline std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

// Runs `body`. Any exception becomes a DataError with one sentence that names `origin`.
template <class Body>
auto located(const std::string& origin, const char* what, Body&& body) {
  try {
    return body();
  } catch (const std::exception& error) {
    throw DataError(
        fmt::format("{}: not a readable {} ({}); remove it and run the experiment again", origin, what, error.what()));
  }
}

Json request_to_json(const RunRequest& request);
RunRequest request_from_json(const Json& json);

}  // namespace isobench
