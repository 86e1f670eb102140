// Finding a manifest's files: in a folder of the user or in the cache; otherwise they are fetched into the cache from
// an address or a package.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

struct DataFiles {
  std::vector<std::filesystem::path> paths;  ///< one for each file of the manifest, in its order
  std::vector<std::string> sums;             ///< their SHA-256, which were compared with the manifest's
  std::string source;                        ///< the place where they were found, in words
};

/// Looks beside a user's own manifest, then in ISOBENCH_DATA, then in the cache, for a folder that has all the files;
/// else fetches them into the cache. Throws DataError naming the file and the remedy if a checksum is wrong, if the
/// files are nowhere and cannot be fetched, or if ISOBENCH_DATA is not a folder.
DataFiles locate_data(const Manifest& manifest, Monitor& monitor);

/// $ISOBENCH_CACHE, else $XDG_CACHE_HOME/isobench, else ~/.cache/isobench. Throws DataError if no variable is set.
std::filesystem::path cache_folder();

}  // namespace isobench
