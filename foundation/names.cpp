#include "isobench/foundation/names.h"

#include "isobench/foundation/error.h"

namespace isobench {

bool is_plain_name(const std::string& name, std::size_t longest) {
  if (name.empty() || name.size() > longest || name.front() == '.' || name.front() == '-') return false;
  return name.find('/') == std::string::npos && printable(name) == name;
}

}  // namespace isobench
