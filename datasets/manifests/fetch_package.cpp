#include <fmt/format.h>

#include "isobench/datasets/manifests/fetch.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/files/scratch_folder.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

void run_step(const std::vector<std::string>& words, const std::filesystem::path& folder, const Manifest& manifest) {
  if (run_tool(words, folder)) return;
  const std::string said = last_lines(folder / "log.txt", 1);
  const std::filesystem::path wanted = manifest.folder / manifest.files.front().name;
  throw DataError(fmt::format(
      "{}: {} failed on the Debian package {} ({}); run apt-get update with the package archive reachable, or set "
      "ISOBENCH_DATA to a folder that has {}",
      manifest.name, words.front(), manifest.package->name, said.empty() ? "it could not be started" : said,
      wanted.string()));
}

std::filesystem::path package_file(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".deb") return entry.path();
  }
  throw DataError(folder.string() + ": apt-get download left no package file; run apt-get update");
}

}  // namespace

void fetch_from_package(const Manifest& manifest, const std::filesystem::path& folder, Monitor& monitor) {
  const ScratchFolder scratch(folder);
  const std::filesystem::path& path = scratch.path();
  run_step({"apt-get", "download", manifest.package->name}, path, manifest);
  monitor.check();
  run_step({"dpkg-deb", "-x", package_file(path).string(), "unpacked"}, path, manifest);
  std::filesystem::path root = path / "unpacked";
  if (!manifest.package->archive.empty()) {
    const std::string archive = (root / manifest.package->archive).string();
    std::filesystem::create_directory(path / "members");
    std::vector<std::string> words = {"tar", "-x", "-f", archive, "-C", "members", "--no-same-owner"};
    for (const ManifestFile& file : manifest.files) words.push_back(file.member);
    run_step(words, path, manifest);
    root = path / "members";
  }
  for (const ManifestFile& file : manifest.files) {
    const std::filesystem::path member = root / file.member;
    if (!std::filesystem::is_regular_file(member)) {
      throw DataError(fmt::format(
          "{}: the Debian package {} has no {}; fetch the version of the package that the manifest was written for",
          manifest.name, manifest.package->name, file.member));
    }
    const std::string sum = sha256_of_file(member);
    if (sum != file.sha256) {
      throw DataError(fmt::format(
          "{} of the Debian package {}: its SHA-256 is {}, but {} is expected; fetch the version of the package that "
          "the manifest was written for",
          file.member, manifest.package->name, sum, file.sha256));
    }
    std::filesystem::rename(member, folder / file.name);
  }
}

}  // namespace isobench
