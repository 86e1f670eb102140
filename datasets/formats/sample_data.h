// Samples as files hold them: plain or compressed bytes of a stated type and byte order. They are read straight into
// the volume's array, so that no second copy of a volume is ever in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"

namespace isobench {

enum class Encoding {
  plain,
  deflated,  ///< a gzip or a zlib stream; its header tells which
};

/// Reads a file's bytes in order and inflates them if they are compressed. Throws DataError naming the file if it
/// cannot be opened or its compressed data are damaged.
class ByteReader {
 public:
  ByteReader(std::filesystem::path path, Encoding encoding, std::uintmax_t offset = 0);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Reads up to `count` bytes, fewer only at the end of the data. Returns their number.
  std::size_t read(char* bytes, std::size_t count);
  /// Reads one line, of at most `limit` bytes, without its end ("\n" or "\r\n"). Returns false at the end of the data.
  bool read_line(std::string& line, std::size_t limit = 65536);
  /// Skips up to `count` bytes. Returns how many there were.
  std::uintmax_t skip(std::uintmax_t count);
  /// Reads a compressed stream to its end. Throws DataError if the stream stops before its end mark, if its checksum
  /// does not match, or if more than a mebibyte follows (a few kilobytes can inflate to gigabytes of zeros).
  /// Does nothing for a plain file.
  void finish();
  /// The most bytes that can still follow: deflate compresses by a factor of at most 1032.
  std::uintmax_t possible_bytes() const;
  /// How many bytes from the file's beginning the caller has read. Precondition: a plain file.
  std::uintmax_t consumed() const;
  Encoding encoding() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  struct State;
  std::filesystem::path path_;
  std::unique_ptr<State> state_;
};

/// Converts `count` samples from a file's bytes to double; 64-bit integers beyond 2^53 are rounded.
void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, double* numbers);

/// The samples that `count` · bytes_of(type) bytes of a file hold.
Samples samples_of_bytes(const char* bytes, std::size_t count, SampleType type, ByteOrder order);

/// The samples that a text of exactly `count` numbers holds; std::nullopt if it is not one. An integer may be written
/// as 3, 3.0 or 3e0, and must be within the range of its type.
std::optional<Samples> samples_of_text(std::string_view text, std::size_t count, SampleType type);

/// The type that a file's header names: "unsigned short", "u16", "uint16", "MET_USHORT" and the like; std::nullopt for
/// other names.
std::optional<SampleType> sample_type(const std::string& name);

/// Appends `count` samples of the type of `samples`, and checks that a compressed stream is complete. Throws DataError
/// if the file holds fewer samples. It compares `count` with the file's size before it takes memory, and takes memory
/// as samples arrive, so that a wrong size in a header costs nothing.
void read_samples(ByteReader& reader, std::size_t count, ByteOrder order, Samples& samples);

/// The same for numbers written as text. Throws DataError, too, for a word that is not a number of the samples' type.
void read_text_samples(ByteReader& reader, std::size_t count, Samples& samples);

}  // namespace isobench
