// The figures of one mesh in a few lines for a person.
#pragma once

#include <string>

#include "isobench/metrics/measurement.h"

namespace isobench {

/// Some ten lines of "name  figures", more where metrics of use were measured. A line whose figures were not measured
/// says what they need: a surface, a sizing or another mesh.
std::string summary_text(const Measurement& measurement);

}  // namespace isobench
