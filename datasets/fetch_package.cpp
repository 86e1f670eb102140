#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "datasets/error.h"
#include "datasets/fetch.h"
#include "datasets/sha256.h"

namespace isobench {

namespace {

/// A folder that goes with all its contents when the scope ends.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent) {
    std::string name = (parent / ".package-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw DataError(parent.string() + ": the cache cannot be written; set ISOBENCH_CACHE to a folder that can");
    }
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs a program in a folder without a shell, what it prints going to a file there; true if it ended with 0.
bool run_program(std::vector<std::string> words, const std::filesystem::path& folder) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "log.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int problem = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) return false;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string last_line(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last.empty() ? "it could not be started" : last;
}

void run_step(const std::vector<std::string>& words, const std::filesystem::path& folder, const Manifest& manifest) {
  if (run_program(words, folder)) return;
  const std::filesystem::path wanted = manifest.folder / manifest.files.front().name;
  throw DataError(fmt::format(
      "{}: {} failed on the Debian package {} ({}); run apt-get update with the package archive reachable, or set "
      "ISOBENCH_DATA to a folder that has {}",
      manifest.name, words.front(), manifest.package->name, last_line(folder / "log.txt"), wanted.string()));
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
      throw DataError(fmt::format("{}: the Debian package {} has no {}; another version of it is needed", manifest.name,
                                  manifest.package->name, file.member));
    }
    const std::string sum = sha256_of_file(member);
    if (sum != file.sha256) {
      throw DataError(fmt::format(
          "{} of the Debian package {}: its SHA-256 is {} where {} is expected; another version of the package is "
          "needed",
          file.member, manifest.package->name, sum, file.sha256));
    }
    std::filesystem::rename(member, folder / file.name);
  }
}

}  // namespace isobench
