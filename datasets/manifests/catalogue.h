// The named datasets: one TOML manifest each in datasets/catalogue/, or in the folder ISOBENCH_CATALOGUE, which is
// searched first. Wherever a name is asked for, a path that ends in ".toml" is a user's own manifest, with its data
// beside it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/datasets/preparation/prepare.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// A dataset ready to be meshed.
struct Dataset {
  std::string name;
  std::string title;
  std::unique_ptr<Isosurface> surface;
  std::string checksum;  ///< hash over sources, preparation, isovalue and kernel: decides what is reused
  std::vector<std::string> preparation;  ///< describe() of each step, for the record
  std::string source;                    ///< where the data came from: a folder, the cache, a package, "phantom"
};

/// What `isobench list datasets` shows.
struct DatasetInfo {
  std::string name;
  std::string title;
  std::string licence;
  std::string source;
  std::string acknowledgement;  ///< what its owners ask to be said; "" where they ask for nothing
};

std::vector<DatasetInfo> list_datasets();
std::vector<std::string> dataset_names();

/// The dataset's checksum without reading data (except files of a user's own manifest that states no sha256). Throws
/// UsageError for an unknown name, with the nearest one.
std::string dataset_checksum(const std::string& name, const Place& place = {});

/// Reads and prepares a dataset. Its files come from the folder ISOBENCH_DATA, else from the cache ($ISOBENCH_CACHE,
/// $XDG_CACHE_HOME/isobench or ~/.cache/isobench), else they are fetched into the cache; their SHA-256 is always
/// checked. Throws UsageError for an unknown name (with the nearest valid one, at `place`), DataError for missing data,
/// a checksum that does not match, and everything that reading, preparing and Isosurface throw.
Dataset load_dataset(const std::string& name, Monitor& monitor, const Place& place = {});

/// A dataset out of any volume file: smoothed with a Gaussian of `smooth_voxels` (0: not at all) and, where the object
/// leaves the volume, closed there, which the monitor is told. The checksum covers the samples and these arguments.
/// Throws what read_volume(), prepare() and Isosurface throw.
Dataset dataset_from_file(const std::filesystem::path& path, double isovalue, Inside inside, double smooth_voxels,
                          Kernel kernel, Monitor& monitor);

/// Brings a dataset's files into the cache, unless ISOBENCH_DATA has them, and says where they are; none for a phantom.
std::vector<std::filesystem::path> fetch_dataset(const std::string& name, Monitor& monitor);

}  // namespace isobench
