// What run.json and plan.json share; for this folder's two JSON files alone.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/record.h"

namespace isobench {

using Json = nlohmann::ordered_json;

// JSON has no word for a number that is not finite.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

inline void read(const Json& json, double& value) {
  value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}
template <class Integer>
void read(const Json& json, Integer& value) {
  value = json.get<Integer>();
}

inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }
inline std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

// Runs `body`, turning whatever the JSON library has to say into one sentence about `origin`.
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
