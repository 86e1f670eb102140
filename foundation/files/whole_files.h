// Files that are read and written as a whole. A reader never sees a file that is half written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "isobench/foundation/error.h"

namespace isobench {

/// A file that gets its name only when it is complete. Until then it has a temporary name beside the final one and the
/// same ending; if it is never completed, it is removed when the scope ends.
class PartialFile {
 public:
  /// Follows the final name in every temporary name: "mesh.ply.tmp-4711.ply".
  static constexpr const char* mark = ".tmp-";

  explicit PartialFile(std::filesystem::path target);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write.
  const std::filesystem::path& path() const { return temporary_; }
  /// Gives the file its final name, in place of an older file. Close it first. Throws not_written().
  void complete();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// The error to throw where a file could not be written: its name, the cause and what helps. `cause` is a value of
/// errno; 0 if it is not known.
Error not_written(const std::filesystem::path& path, int cause);

/// Throws DataError, naming the file, if it cannot be read.
std::string read_text(const std::filesystem::path& path);
/// The same; "" if it cannot be read.
std::string read_text_or_empty(const std::filesystem::path& path);

/// Writes through a PartialFile, so an older file stays if this one cannot be written. Throws not_written() then.
void write_text(const std::filesystem::path& path, const std::string& text);
/// The same for a text that is too long to be held in memory.
void write_text(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// The last `count` lines with more in them than blanks and dots, joined by " | ". Looks only at the last 4 KB, and not
/// before byte `begin`. "" if there are none or the file cannot be read.
std::string last_lines(const std::filesystem::path& path, std::size_t count, std::uintmax_t begin = 0);

}  // namespace isobench
