// How much memory this process may still take.
#pragma once

#include <filesystem>

namespace isobench {

/// Bytes: what the machine has available, or what is left of the limit of a control group (versions 1 and 2) that the
/// process is in, whichever is least. Infinite where /proc says nothing. `root` is for tests: the folder in which
/// proc/ and sys/ are looked for.
double available_memory(const std::filesystem::path& root = "/");

}  // namespace isobench
