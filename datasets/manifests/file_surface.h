// A surface of any volume file, without a manifest.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/volume_file.h"
#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/preparation/prepare.h"
#include "isobench/datasets/surface_choices.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// What to do with an object that reaches the volume's border.
enum class Border { close, refuse };

/// Sigma of the Gaussian that smooths labels if no other is asked for, voxels.
inline constexpr double label_smoothing = 1.0;

/// Which surface of a volume file is asked for.
struct FileSurface {
  std::optional<double> isovalue = {};  ///< needed, unless there are labels
  Inside inside = Inside::above;
  /// The object is where samples have one of these labels; empty: the isovalue says where it is.
  std::vector<std::int64_t> labels = {};
  std::optional<Eigen::Vector3d> resample = {};  ///< mm, the spacing to interpolate at
  std::optional<double> smooth_voxels = {};      ///< sigma of a Gaussian; if not given 0, of labels label_smoothing
  Kernel kernel = Kernel::bspline;
  Border border = Border::close;
  SurfaceChoices choices = {};
  VolumeChoice part = {};  ///< of a file that holds several volumes
};

/// The steps that make the surface's volume of a file's. With an isovalue: resample, smooth by the Gaussian, close an
/// object that reaches the border. With labels: select them exactly, close at the border, crop to them and pad; where
/// slices are thick (1.5 times the least spacing, or more) or a spacing is asked for, interpolate between the slices by
/// signed distances (shape-based interpolation: Raya and Udupa 1990) at the spacing asked for or the least one; smooth.
/// The surface is where this mask is 0.5. Throws UsageError if the members contradict each other.
std::vector<PrepareStep> steps_of(const FileSurface& asked, const Lattice& lattice);

/// Makes a dataset of any volume file by steps_of(). The monitor gets notes: on how the file was read, on the area
/// closed at the border and, for labels, on what smoothing did: the volume and the number of islands before and after.
/// The checksum covers the samples and these arguments. Throws what read_volume(), prepare(), Isosurface and
/// settle_surface() throw. Unless `manifest` is empty, writes a manifest there that gives the same surface of the same
/// file, which lies beside it.
Dataset dataset_from_file(const std::filesystem::path& path, const FileSurface& asked, Monitor& monitor,
                          const std::filesystem::path& manifest = {});

/// The text of that manifest. `lattice` is the file's.
std::string manifest_text(const std::filesystem::path& path, const FileSurface& asked, const Lattice& lattice);

}  // namespace isobench
