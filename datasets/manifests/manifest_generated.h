// The table [generated] of a manifest.
#pragma once

#include "isobench/datasets/generated/generated.h"
#include "isobench/foundation/toml.h"

namespace isobench {

/// Throws UsageError with the place of an unknown key or generator, or of a value that is out of range.
GeneratedRequest parse_generated(const TomlValue& table);

}  // namespace isobench
