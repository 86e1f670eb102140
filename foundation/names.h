// Names of files and folders that come from a user.
#pragma once

#include <string>

namespace isobench {

/// Whether a text may become the name of a file or folder: it is printable and has no "/", begins with neither "."
/// (which excludes "..") nor "-" (which reads as an option), and has at most `longest` bytes. File systems allow 255;
/// 100 leave room for additions to the name.
bool is_plain_name(const std::string& name, std::size_t longest = 100);

}  // namespace isobench
