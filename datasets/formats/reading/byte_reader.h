// The bytes of a file, or of several files one after the other, plain or compressed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isobench {

enum class Encoding {
  plain,
  deflated,  ///< gzip or zlib; the stream's first bytes tell which
  bzip2,
  hex,  ///< two hexadecimal digits a byte, as text
};

/// A file of data, and the byte at which they begin.
struct DataFile {
  std::filesystem::path path;
  std::uintmax_t offset = 0;
};

/// Reads bytes in order and unpacks them if they are compressed. Throws DataError naming the file if it cannot be
/// opened or its compressed data are damaged.
class ByteReader {
 public:
  ByteReader(const std::filesystem::path& path, Encoding encoding, std::uintmax_t offset = 0);
  /// Reads one file after the other; each is compressed by itself. Precondition: there is at least one.
  ByteReader(std::vector<DataFile> files, Encoding encoding);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Reads up to `count` bytes, fewer only at the end of the data. Returns their number.
  std::size_t read(char* bytes, std::size_t count);
  /// Reads one line, of at most `limit` bytes, without its end ("\n" or "\r\n"). Returns false at the end of the data.
  bool read_line(std::string& line, std::size_t limit = 65536);
  /// Skips up to `count` bytes, without reading them where the file is plain. Returns how many there were.
  std::uintmax_t skip(std::uintmax_t count);
  /// Reads a compressed stream to its end. Throws DataError if the stream stops before its end mark, if its checksum
  /// does not match, or if more than a mebibyte follows (a few kilobytes can inflate to gigabytes of zeros).
  /// For plain files, it only sets surplus().
  void finish();
  /// The bytes that finish() found after what was read.
  std::uintmax_t surplus() const { return surplus_; }
  /// The most bytes that can still follow: deflate compresses by a factor of at most 1032, bzip2 by about 10^6.
  std::uintmax_t possible_bytes() const;
  /// How many bytes from the file's beginning the caller has read. Precondition: one plain file.
  std::uintmax_t consumed() const;
  Encoding encoding() const { return encoding_; }
  /// The file that the next byte comes from; the last one at the end of the data.
  const std::filesystem::path& path() const { return files_[at_].path; }

 private:
  class Stream;  // and the encodings' own: byte_streams.h
  class PlainStream;
  class HexStream;
  class CompressedStream;
  class DeflatedStream;
  class Bzip2Stream;
  std::size_t read_stream(char* bytes, std::size_t count);
  void check_complete() const;

  std::vector<DataFile> files_;
  Encoding encoding_;
  std::size_t at_ = 0;  // of the file that is being read
  std::unique_ptr<Stream> stream_;
  std::uintmax_t later_bytes_ = 0;  // of the files that come after it, as they are on disk
  std::vector<char> lines_;         // bytes that read_line() has read from the file but not returned
  std::size_t lines_begin_ = 0;
  std::uintmax_t surplus_ = 0;
};

/// The encoding that a file's first bytes show.
Encoding encoding_of(const std::filesystem::path& path);

}  // namespace isobench
