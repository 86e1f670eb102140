// Names that become files and folders of ours.
#pragma once

#include <string>

namespace isobench {

/// Whether a text may name a file or folder that we make: printable, without "/", not hidden (which ".." is, too), not
/// to be taken for an option, and not longer than a file system can take: 100 bytes leave room for what is put behind
/// it.
bool is_plain_name(const std::string& name, std::size_t longest = 100);

}  // namespace isobench
