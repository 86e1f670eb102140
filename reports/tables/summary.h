// The figures of one mesh in a few lines for a person.
#pragma once

#include <string>

#include "isobench/metrics/measurement.h"

namespace isobench {

/// Some ten lines of "name  figures"; edge lengths are left out where forget_edge_lengths() was called.
std::string summary_text(const Measurement& measurement);

/// Makes the figures about h0 "not measured" (NaN): for a mesh that no sizing was asked of.
void forget_edge_lengths(Measurement& measurement);

}  // namespace isobench
