// The commit that was built; the definitions are in a file that git_commit.cmake writes at build time, so that a new
// commit recompiles that file alone.
#pragma once

namespace isobench {

extern const char* const git_commit;
extern const bool git_dirty;

}  // namespace isobench
