// A dataset's manifest: where its files come from, how they are prepared, and which surface in them is meant.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/preparation/prepare.h"

namespace isobench {

struct ManifestFile {
  std::string name;     ///< within the manifest's folder
  std::string sha256;   ///< "" only for files that are not fetched
  std::string address;  ///< "" where nothing publishes it
  std::string member;   ///< its path in the package, or in the package's archive
};

/// A Debian package that holds the files, perhaps in a tar archive within it.
struct ManifestPackage {
  std::string name;
  std::string archive;  ///< "" if the files are the package's own members
};

struct ManifestPhantom {
  std::string name;
  int nodes = 64;                            ///< along the longest axis
  std::map<std::string, double> parameters;  ///< mm, those that the manifest states
};

struct Manifest {
  std::string name;
  std::string title;
  std::string licence;
  std::string source;               ///< who publishes it, in words
  std::string acknowledgement;      ///< what its owners ask to be said
  std::filesystem::path folder;     ///< below ISOBENCH_DATA and the cache, or, for a user's own manifest, beside it
  std::filesystem::path beside;     ///< the folder of a user's own manifest; empty for the catalogue's
  std::vector<ManifestFile> files;  ///< the first is read, the others lie beside it; raw files are read in order
  std::optional<ManifestPackage> package;
  std::optional<RawLayout> raw;
  std::optional<ManifestPhantom> phantom;
  std::vector<PrepareStep> steps;
  double isovalue = 0.0;
  Inside inside = Inside::above;
  Kernel kernel = Kernel::bspline;
};

/// Throws UsageError, with the place, for anything that is not a valid manifest.
Manifest read_manifest(const std::filesystem::path& path, const std::string& name);

/// The SHA-256 of all that decides the prepared dataset. `file_sums` has one sum a file, in order.
std::string manifest_checksum(const Manifest& manifest, const std::vector<std::string>& file_sums);

}  // namespace isobench
