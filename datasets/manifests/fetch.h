// Fetching files into a folder, from an address or from a Debian package. A file gets its name only when it is complete
// and its checksum is right, so that neither a killed process nor a second one beside it does harm.
#pragma once

#include <filesystem>
#include <string>

#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Downloads with libcurl (https, http, file). Throws DataError with libcurl's message if that fails, or if the
/// checksum is wrong.
void fetch_from_address(const ManifestFile& file, const std::filesystem::path& folder, Monitor& monitor);

/// Downloads with apt-get and unpacks with dpkg-deb and tar, in a scratch folder within `folder`. Needs no root and
/// installs nothing. Throws DataError with the failing program's last message.
void fetch_from_package(const Manifest& manifest, const std::filesystem::path& folder, Monitor& monitor);

}  // namespace isobench
