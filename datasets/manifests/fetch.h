// Bringing files into a folder from an address or out of a Debian package. Each file appears under its name only when
// it is complete and its checksum matches, so that a process that is killed, or another one beside it, does no harm.
#pragma once

#include <filesystem>
#include <string>

#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// By libcurl (https, http, file). Throws DataError, saying what libcurl says, if it fails or the checksum differs.
void fetch_from_address(const ManifestFile& file, const std::filesystem::path& folder, Monitor& monitor);

/// By apt-get download and dpkg-deb -x (and tar), into a scratch folder within `folder`; needs no root and installs
/// nothing. Throws DataError, saying what the failing program said.
void fetch_from_package(const Manifest& manifest, const std::filesystem::path& folder, Monitor& monitor);

}  // namespace isobench
