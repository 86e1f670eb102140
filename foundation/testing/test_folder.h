// For tests: a folder that is removed when the test ends.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "isobench/foundation/files/scratch_folder.h"

namespace isobench {

class TestFolder : public ScratchFolder {
 public:
  TestFolder() : ScratchFolder(std::filesystem::temp_directory_path(), "isobench-test-") {}

  /// A file of these bytes in this folder; makes the folders on the way. Returns its path.
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::ofstream(path() / name, std::ios::binary) << bytes;
    return path() / name;
  }
};

}  // namespace isobench
