// The figures that are looked at over many data sets.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/spread.h"

namespace isobench {

struct Criterion {
  std::string id;    ///< part of file names: "radius-ratio-min"
  std::string name;  ///< "Smallest radius ratio"
  std::string unit;
  bool larger = true;  ///< a larger value is better
  Print print;
  Figure value;        ///< of a run with a mesh; NaN if it was not measured
  bool timed = false;  ///< seconds, which are compared only between runs that were timed alike
};

/// Name and unit, for headings and axes: "Smallest angle, °".
std::string name_with_unit(const Criterion& criterion);

/// Quality and speed. Their distributions, ranks and profiles are shown.
const std::vector<Criterion>& quality_criteria();
/// One of quality_criteria() by its id. Throws std::logic_error for any other.
const Criterion& quality_criterion(const std::string& id);
/// Of these only the worst cases are shown: most meshes should have the same value.
const std::vector<Criterion>& defect_criteria();

}  // namespace isobench
