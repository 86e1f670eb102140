// The preparation steps of a manifest: prepare = [ { step = "pad", voxels = 4 }, … ].
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/preparation/prepare.h"
#include "isobench/foundation/toml.h"

namespace isobench {

/// Which surface the manifest states: the object that a step may have to close.
struct ManifestSurface {
  double isovalue = 0.0;
  Inside inside = Inside::above;
};

/// Throws UsageError with the place of an unknown step or key, or of a value that is out of range.
std::vector<PrepareStep> parse_steps(const TomlValue& list, const ManifestSurface& surface);

/// One number for all axes, or three; each must be > 0.
Eigen::Vector3d parse_triple(const TomlValue& value);

/// An integer from `least` to `most`.
int parse_count(const TomlValue& value, int least, int most = std::numeric_limits<int>::max());

/// One integer for all axes, or three; each from `least` to `most`.
std::array<int, 3> parse_counts(const TomlValue& value, int least, int most = std::numeric_limits<int>::max());

}  // namespace isobench
