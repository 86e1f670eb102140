// For tests: whether a page is well-formed.
#pragma once

#include <string>
#include <vector>

namespace isobench {

/// The first element that is not closed, or not in the right order; "" if there is none.
inline std::string first_unbalanced(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const bool closing = page[at + 1] == '/';
    const std::size_t start = at + (closing ? 2 : 1);
    std::string name = page.substr(start, page.find_first_of(" >\n", start) - start);
    if (name == "!DOCTYPE" || name == "meta" || name == "link" || name == "img") continue;
    if (name == "script" || name == "style") {
      at = page.find("</" + name + ">", at);
      continue;
    }
    if (!closing) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

}  // namespace isobench
