// Small operations on text.
#pragma once

#include <string>

namespace isobench {

/// The text without blanks, tabs and line ends at both ends.
std::string trimmed(const std::string& text);

}  // namespace isobench
