// Folders for temporary files.
#pragma once

#include <filesystem>
#include <string>

namespace isobench {

/// A new empty folder in `parent`, removed with all its contents when the scope ends. Its name is `prefix` and six
/// random characters. Throws Error if it cannot be made.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent, const std::string& prefix = ".scratch-");
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace isobench
