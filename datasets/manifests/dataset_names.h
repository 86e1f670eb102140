// From the name of a dataset to its manifest.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "isobench/foundation/error.h"

namespace isobench {

/// The manifests of the catalogue and of the folders in it, by their names. One in the folder ISOBENCH_CATALOGUE hides
/// one of the same name.
std::map<std::string, std::filesystem::path> manifest_paths();

/// Where a dataset is described.
struct ManifestPlace {
  std::filesystem::path path;
  std::string manifest;       ///< the manifest's name, or its path for a user's own
  std::optional<int> member;  ///< of the family that the manifest describes
};

/// Finds the manifest of a name or path; a manifest of that name hides a member of a family. Reads no manifest, but for
/// the one of the member's family. Throws UsageError at `place` for an unknown name, with the nearest one or with all
/// that there are, and for a member that its family does not have, with those that it has.
ManifestPlace find_manifest(const std::string& name, const Place& place);

}  // namespace isobench
