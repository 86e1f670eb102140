// The surface of `mesh` and `measure`: a data set, or a volume file with its isovalue.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "isobench/datasets/manifests/catalogue.h"

namespace isobench {

struct SurfaceArguments {
  std::string dataset;           ///< or:
  std::filesystem::path volume;  ///< a file, with the members below
  std::optional<double> isovalue;
  std::string inside = "above";
  double smooth = 0.0;  ///< Gaussian sigma, voxels
  std::string border = "close";
  SurfaceChoices choices;

  bool given() const { return !dataset.empty() || !volume.empty() || isovalue.has_value(); }
};

/// Throws UsageError unless exactly one surface is given, with all that it needs.
void check(const SurfaceArguments& surface);

/// Reads and prepares the volume. Precondition: check() passed.
Dataset load(const SurfaceArguments& surface, Monitor& monitor);

}  // namespace isobench
