// The named datasets. Each has a TOML manifest in datasets/catalogue/ or in the folder that ISOBENCH_CATALOGUE names,
// which is searched first. In place of a name, the path of a user's own manifest may be given, which ends in ".toml";
// its data lie beside it. A manifest may also describe a family of datasets (family.h), whose members have names such
// as "wild-fields-017".
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
#include "isobench/datasets/surface_choices.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// A dataset ready to be meshed.
struct Dataset {
  std::string name;
  std::string title;
  std::unique_ptr<Isosurface> surface;
  std::shared_ptr<const CertifiedTopology> topology;  ///< of the surface; proven
  /// Set if this isovalue is no regular value of F, so that the surface has another (settle_surface.h).
  std::optional<double> asked_isovalue;
  std::string checksum;  ///< hash of sources, preparation, isovalue and kernel; results are reused if it is the same
  std::vector<std::string> preparation;  ///< describe() of each step, for the record
  /// Where the data came from: a folder, the cache, a package, "phantom" or "generated".
  std::string source;
};

/// A line of `isobench list datasets`: a dataset, or a family of them.
struct DatasetInfo {
  std::string name;  ///< of the manifest
  std::string title;
  std::string licence;
  std::string source;
  std::string acknowledgement;  ///< the sentence that its owners ask for; "" if they ask for none
  std::string members;          ///< "wild-fields-001 … -240"; "" if it is no family
  std::string first;            ///< the name of the dataset, or of the family's first member
};

std::vector<DatasetInfo> list_datasets();
/// The names of all datasets; those of a family's members in their order. Reads every manifest.
std::vector<std::string> dataset_names();

/// Whether a dataset is asked for by a pattern, with *, ? or [, instead of by its name.
bool is_glob(const std::string& name);
/// The names that a glob matches, by the rules of fnmatch(), in their order.
std::vector<std::string> matching(const std::string& glob, const std::vector<std::string>& names);

/// The family that a dataset is a member of; "" if it is of none. Throws as dataset_checksum() does.
std::string dataset_family(const std::string& name);

/// The dataset's checksum. Reads no data, except files for which a user's own manifest states no sha256. Throws
/// UsageError with the nearest valid name for an unknown one.
std::string dataset_checksum(const std::string& name, const Place& place = {});

/// Reads and prepares a dataset. Its files come from the folder ISOBENCH_DATA, else from the cache ($ISOBENCH_CACHE,
/// $XDG_CACHE_HOME/isobench or ~/.cache/isobench), else they are fetched into the cache. Their SHA-256 is always
/// checked. Throws UsageError at `place`, with the nearest valid name, for an unknown name; DataError for missing data
/// or a wrong checksum; and what reading, preparing, Isosurface and settle_surface() throw.
///
/// `min_component` (mm³) replaces the manifest's own, if it is larger.
Dataset load_dataset(const std::string& name, Monitor& monitor, const Place& place = {}, double min_component = 0.0);

/// Fetches a dataset's files into the cache, unless ISOBENCH_DATA or the cache has them. Returns their paths, none for
/// a phantom or a generated dataset.
std::vector<std::filesystem::path> fetch_dataset(const std::string& name, Monitor& monitor);

}  // namespace isobench
