// Questions about a mesh that are answered with yes or no. Each is declared once, for the tables and for results.csv.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isobench/reports/record/record.h"

namespace isobench {

/// Bounds on all angles of a mesh, degrees: what good meshes keep, and what all should keep.
struct AngleBounds {
  double smallest = 0.0;
  double largest = 0.0;
};
inline constexpr AngleBounds narrow_angles{35.0, 90.0};
inline constexpr AngleBounds wide_angles{30.0, 100.0};

struct Check {
  std::string column;      ///< name in results.csv
  std::string name;        ///< "closed manifold"
  std::string definition;  ///< one or more sentences
  /// std::nullopt where a figure that the answer needs was not measured, or is unknown to an old record.
  std::optional<bool> (*passes)(const Measurement& measurement);
};

/// All checks, in the order in which tables show them.
const std::vector<Check>& checks();
/// The check with this column. Throws std::logic_error for any other name.
const Check& check(const std::string& column);

/// The answer for a run; std::nullopt also if it has no mesh.
std::optional<bool> passes(const Check& check, const RunRecord& run);

}  // namespace isobench
