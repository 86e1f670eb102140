// The surface of `mesh` and `measure`: a data set, or a volume file with its isovalue.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/frame.h"
#include "isobench/datasets/manifests/file_surface.h"

namespace isobench {

struct SurfaceArguments {
  std::string dataset;           ///< or:
  std::filesystem::path volume;  ///< a file or a folder, with the members below
  std::optional<double> isovalue;
  std::vector<std::int64_t> labels;  ///< in place of the isovalue
  std::string inside = "above";
  std::vector<double> resample;  ///< mm; one number or three
  std::optional<double> smooth;  ///< Gaussian sigma, voxels
  std::string kernel = to_string(Kernel::bspline);
  std::string border = "close";
  VolumeChoice part;
  SurfaceChoices choices;
  std::filesystem::path save_manifest;
  std::string frame = to_string(Frame::file);  ///< of the mesh

  bool given() const { return !dataset.empty() || !volume.empty() || isovalue.has_value() || !labels.empty(); }
};

/// Throws UsageError unless exactly one surface is given, with all that it needs.
void check(const SurfaceArguments& surface);

/// The frame of the mesh's coordinates.
Frame frame_of(const SurfaceArguments& surface);

/// Reads and prepares the volume, and writes its manifest if one is asked for. Precondition: check() passed.
Dataset load(const SurfaceArguments& surface, Monitor& monitor);

}  // namespace isobench
