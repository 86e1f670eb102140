#include "isobench/foundation/files/scratch_folder.h"

#include <cstdlib>

#include "isobench/foundation/error.h"

namespace isobench {

ScratchFolder::ScratchFolder(const std::filesystem::path& parent, const std::string& prefix) {
  std::string name = (parent / (prefix + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) throw Error(parent.string() + ": no folder can be made here");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

}  // namespace isobench
