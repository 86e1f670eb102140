#include "isobench/datasets/manifests/dataset_names.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <charconv>
#include <cstdlib>
#include <vector>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/manifest.h"

namespace isobench {

namespace {

bool is_manifest_path(const std::string& name) { return name.ends_with(".toml"); }

/// Adds the manifests of a folder and of the folders in it, unless there is one of the same name already.
void add_manifests(const std::filesystem::path& folder, std::map<std::string, std::filesystem::path>& paths) {
  std::error_code error;
  std::filesystem::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
    if (entry.depth() > 0) entry.disable_recursion_pending();
    const std::filesystem::path& path = entry->path();
    if (path.extension() == ".toml") paths.emplace(path.stem().string(), path);
  }
}

void add_members(const std::string& manifest, const Family& family, std::vector<std::string>& names) {
  for (int member = 1; member <= family.members; ++member)
    names.push_back(manifest + "-" + member_number(family, member));
}

[[noreturn]] void refuse_unknown(const std::string& name, const Place& place) {
  const std::string nearest = nearest_name(name, dataset_names());
  std::vector<std::string> lines;
  for (const auto& [manifest, path] : manifest_paths()) {
    const std::optional<Family> family = read_family(path);
    lines.push_back(family ? members_text(*family, manifest) : manifest);
  }
  throw UsageError(place, fmt::format("unknown dataset '{}'{}", name,
                                      suggestion(name, nearest.empty() ? lines : std::vector{nearest})));
}

/// The number at the end of a member's name, "wild-fields-017"; std::nullopt if the family has no such member.
std::optional<int> member_of(const Family& family, const std::string& digits) {
  int member = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), member);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  const bool exists = member >= 1 && member <= family.members && digits == member_number(family, member);
  return exists ? std::optional(member) : std::nullopt;
}

}  // namespace

std::map<std::string, std::filesystem::path> manifest_paths() {
  std::vector<std::filesystem::path> folders;
  if (const char* own = std::getenv("ISOBENCH_CATALOGUE"); own != nullptr && *own != '\0') {
    std::error_code error;
    if (!std::filesystem::is_directory(own, error)) {
      throw UsageError(fmt::format("ISOBENCH_CATALOGUE names {}, which is not a folder; correct or unset it", own));
    }
    folders.emplace_back(own);
  }
  folders.emplace_back(ISOBENCH_CATALOGUE_DIR);
  std::map<std::string, std::filesystem::path> paths;
  for (const std::filesystem::path& folder : folders) {
    add_manifests(folder, paths);
  }
  if (paths.empty()) {
    throw UsageError(
        fmt::format("{} has no manifests; set ISOBENCH_CATALOGUE to the folder datasets/catalogue of the source code",
                    folders.back().string()));
  }
  return paths;
}

ManifestPlace find_manifest(const std::string& name, const Place& place) {
  if (is_manifest_path(name)) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(name, error)) {
      throw UsageError(place, fmt::format("no dataset manifest at '{}'; give the path of an existing one", name));
    }
    return {name, name, std::nullopt};
  }
  const auto paths = manifest_paths();
  const std::size_t dash = name.rfind('-');
  const std::string stem = name.substr(0, dash);
  const auto whole = paths.find(name);
  const auto found = whole != paths.end() ? whole : paths.find(stem);
  if (found == paths.end()) refuse_unknown(name, place);
  const std::optional<Family> family = read_family(found->second);
  if (!family && found != whole) refuse_unknown(name, place);
  if (!family) return {found->second, name, std::nullopt};
  const std::string range = members_text(*family, found->first);
  if (found == whole) {
    throw UsageError(place,
                     fmt::format("'{}' is a family of data sets; give one of {}, or all, '{}-*'", name, range, name));
  }
  const std::optional<int> member = member_of(*family, name.substr(dash + 1));
  if (!member) throw UsageError(place, fmt::format("the family '{}' has no member '{}'; it has {}", stem, name, range));
  return {found->second, stem, member};
}

std::vector<std::string> dataset_names() {
  std::vector<std::string> names;
  for (const auto& [manifest, path] : manifest_paths()) {
    if (const std::optional<Family> family = read_family(path))
      add_members(manifest, *family, names);
    else
      names.push_back(manifest);
  }
  return names;
}

bool is_glob(const std::string& name) {
  return !is_manifest_path(name) && name.find_first_of("*?[") != std::string::npos;
}

std::vector<std::string> matching(const std::string& glob, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (fnmatch(glob.c_str(), name.c_str(), 0) == 0) found.push_back(name);
  }
  return found;
}

}  // namespace isobench
