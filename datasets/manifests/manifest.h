// A dataset's manifest: where its files come from, how they are prepared, and which isosurface is taken.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/generated/generated.h"
#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/manifests/family.h"
#include "isobench/datasets/preparation/prepare.h"
#include "isobench/datasets/surface_choices.h"

namespace isobench {

struct ManifestFile {
  std::string name;     ///< within the manifest's folder
  std::string sha256;   ///< "" only for files that are not fetched
  std::string address;  ///< "" if no address publishes it
  std::string member;   ///< its path in the package or in the package's archive
};

/// A Debian package that holds the files, by themselves or in a tar archive.
struct ManifestPackage {
  std::string name;
  std::string archive;  ///< "" if the files lie in the package by themselves
};

struct ManifestPhantom {
  std::string name;
  int nodes = 64;                            ///< along the longest axis
  std::map<std::string, double> parameters;  ///< mm; those that the manifest states
};

struct Manifest {
  std::string name;
  std::string title;
  std::string licence;
  std::string source;               ///< who publishes it, in words
  std::string acknowledgement;      ///< the sentence that its owners ask for
  std::filesystem::path folder;     ///< in ISOBENCH_DATA and in the cache, or in `beside`
  std::filesystem::path beside;     ///< the folder of a user's own manifest; empty for one of the catalogue
  std::vector<ManifestFile> files;  ///< the first is read and may name the others; raw files are all read, in order
  std::optional<ManifestPackage> package;
  VolumeChoice part;  ///< of a file that holds several volumes
  std::optional<RawLayout> raw;
  std::optional<ManifestPhantom> phantom;
  std::optional<GeneratedRequest> generated;
  std::string family;         ///< that it is a member of; "" if it is of none
  std::optional<int> member;  ///< its number in the family, from 1
  std::vector<PrepareStep> steps;
  double isovalue = 0.0;
  Inside inside = Inside::above;
  Kernel kernel = Kernel::bspline;
  SurfaceChoices choices;
};

/// Reads a manifest. `name` is its own name, or its path where it is a user's own; `member` is for families, and counts
/// from 1. Throws UsageError with the place of what is wrong, or for a family without the number of a member.
Manifest read_manifest(const std::filesystem::path& path, const std::string& name,
                       std::optional<int> member = std::nullopt);

/// The family of a manifest of one; std::nullopt for a manifest of one data set.
std::optional<Family> read_family(const std::filesystem::path& path);

/// The SHA-256 of everything that determines the prepared dataset. `file_sums` are the files' own, in order.
std::string manifest_checksum(const Manifest& manifest, const std::vector<std::string>& file_sums);

}  // namespace isobench
