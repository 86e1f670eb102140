// Where a manifest's files are: a folder of the user's, the cache, or, brought into the cache, an address or a package.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

struct DataFiles {
  std::vector<std::filesystem::path> paths;  ///< one a file of the manifest, in its order
  std::vector<std::string> sums;             ///< their SHA-256, checked against the manifest's
  std::string source;                        ///< in words: which of the places, and where it is
};

/// Looks beside a user's own manifest, then in ISOBENCH_DATA, then in the cache, and else fetches into the cache.
/// A folder counts only if it has all the files. Throws DataError, naming the file and the remedy, if a checksum does
/// not match, nothing has the files and they cannot be fetched, or ISOBENCH_DATA is not a folder.
DataFiles locate_data(const Manifest& manifest, Monitor& monitor);

/// $ISOBENCH_CACHE, $XDG_CACHE_HOME/isobench or ~/.cache/isobench.
std::filesystem::path cache_folder();

}  // namespace isobench
