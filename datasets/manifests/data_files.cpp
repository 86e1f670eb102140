#include "isobench/datasets/manifests/data_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "isobench/datasets/manifests/fetch.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

/// "" if the variable is not set.
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool has_file(const std::filesystem::path& folder, const ManifestFile& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(folder / file.name, error);
}

bool has_all(const std::filesystem::path& folder, const Manifest& manifest) {
  return std::all_of(manifest.files.begin(), manifest.files.end(),
                     [&](const ManifestFile& file) { return has_file(folder, file); });
}

DataFiles check_files(const Manifest& manifest, const std::filesystem::path& folder, const std::string& source,
                      const std::string& remedy, Monitor& monitor) {
  DataFiles found;
  found.source = source;
  for (const ManifestFile& file : manifest.files) {
    monitor.progress(static_cast<double>(found.paths.size()) / static_cast<double>(manifest.files.size()));
    const std::filesystem::path path = folder / file.name;
    const std::string sum = sha256_of_file(path);
    if (!file.sha256.empty() && sum != file.sha256) {
      throw DataError(
          fmt::format("{}: its SHA-256 is {}, but {} is expected; {}", path.string(), sum, file.sha256, remedy));
    }
    found.paths.push_back(path);
    found.sums.push_back(sum);
  }
  return found;
}

/// The dataset's folder in ISOBENCH_DATA; empty if the variable is not set or a file is missing there.
std::filesystem::path data_folder(const Manifest& manifest) {
  const std::filesystem::path root = environment("ISOBENCH_DATA");
  if (root.empty()) return {};
  std::error_code error;
  if (!std::filesystem::is_directory(root, error)) {
    throw DataError(fmt::format("ISOBENCH_DATA names {}, which is not a folder; correct or unset it", root.string()));
  }
  return has_all(root / manifest.folder, manifest) ? root / manifest.folder : std::filesystem::path();
}

/// Fetches the files into the cache. Returns in words where they came from.
std::string fetch(const Manifest& manifest, const std::filesystem::path& folder, Monitor& monitor) {
  const auto stage = monitor.stage("fetch");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw DataError(folder.string() +
                    ": the cache's folder cannot be made; set ISOBENCH_CACHE to a folder that can be written");
  if (manifest.package) {
    fetch_from_package(manifest, folder, monitor);
    return "the Debian package " + manifest.package->name;
  }
  for (const ManifestFile& file : manifest.files) {
    if (!has_file(folder, file)) fetch_from_address(file, folder, monitor);
  }
  return manifest.files.front().address;
}

}  // namespace

std::filesystem::path cache_folder() {
  if (std::string own = environment("ISOBENCH_CACHE"); !own.empty()) return own;
  if (const std::string xdg = environment("XDG_CACHE_HOME"); !xdg.empty())
    return std::filesystem::path(xdg) / "isobench";
  if (const std::string home = environment("HOME"); !home.empty())
    return std::filesystem::path(home) / ".cache" / "isobench";
  throw DataError(
      "there is no folder for the cache: none of ISOBENCH_CACHE, XDG_CACHE_HOME and HOME is set; set one of them");
}

DataFiles locate_data(const Manifest& manifest, Monitor& monitor) {
  const bool own = !manifest.beside.empty();
  if (own && has_all(manifest.beside / manifest.folder, manifest)) {
    const std::filesystem::path folder = manifest.beside / manifest.folder;
    return check_files(manifest, folder, "beside its manifest, " + folder.string(), "correct the manifest or the file",
                       monitor);
  }
  const bool fetchable = manifest.package || !manifest.files.front().address.empty();
  if (own && !fetchable) {
    const auto missing = std::find_if_not(manifest.files.begin(), manifest.files.end(), [&](const ManifestFile& file) {
      return has_file(manifest.beside / manifest.folder, file);
    });
    throw DataError(
        fmt::format("{}: no such file; the manifest of '{}' names it, so correct the manifest or put the file there",
                    (manifest.beside / manifest.folder / missing->name).string(), manifest.name));
  }
  if (const std::filesystem::path folder = data_folder(manifest); !folder.empty()) {
    return check_files(manifest, folder, "ISOBENCH_DATA, " + folder.string(),
                       "replace it, or unset ISOBENCH_DATA to have it fetched", monitor);
  }
  // A user's manifest that states no folder gets one named after the dataset in the cache.
  const std::filesystem::path folder =
      cache_folder() / (manifest.folder.empty() ? std::filesystem::path(manifest.name) : manifest.folder);
  const bool cached = has_all(folder, manifest);
  if (!cached && !fetchable) {
    throw DataError(
        fmt::format("{}: its manifest states no address for its files; set ISOBENCH_DATA to a folder that has {}",
                    manifest.name, (manifest.folder / manifest.files.front().name).string()));
  }
  const std::string origin = cached ? "" : ", fetched from " + fetch(manifest, folder, monitor);
  return check_files(manifest, folder, "the cache, " + folder.string() + origin,
                     "delete it and run again to have it fetched", monitor);
}

}  // namespace isobench
