// Programs of the system that we call: no shell in between.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isobench {

/// Runs a program of the search path in `folder`, with nothing to read and what it prints going to log.txt there.
/// True if it could be started and ended with 0.
bool run_tool(std::vector<std::string> words, const std::filesystem::path& folder);

/// A new empty folder in `parent` that goes with all its contents when the scope ends. Throws Error where none can be
/// made.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace isobench
