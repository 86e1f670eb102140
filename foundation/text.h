// Small operations on text.
#pragma once

#include <string>

namespace isobench {

/// The text without blanks, tabs and line ends at both ends.
std::string trimmed(const std::string& text);

/// The text with the letters A to Z in lower case.
std::string lower_case(std::string text);

}  // namespace isobench
