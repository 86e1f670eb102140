// Samples as files hold them: plain or deflated bytes of a stated type and byte order, converted to float while they
// are read, so that no second copy of a volume is ever in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"

namespace isobench {

enum class Encoding {
  plain,
  deflated,  ///< a gzip or zlib stream, told apart by its header
};

/// Reads a file's bytes in order, inflating them where asked. Throws DataError, naming the file, if it cannot be opened
/// or its compressed data are damaged.
class ByteReader {
 public:
  ByteReader(std::filesystem::path path, Encoding encoding, std::uintmax_t offset = 0);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Up to `count` bytes; fewer only where the data end.
  std::size_t read(char* bytes, std::size_t count);
  /// One line without its end ("\n" or "\r\n"), at most `limit` bytes; false where the data end.
  bool read_line(std::string& line, std::size_t limit = 65536);
  /// Passes over up to `count` bytes; says how many there were.
  std::uintmax_t skip(std::uintmax_t count);
  /// Of a compressed stream: reads on to its end. Throws DataError if it stops before its own end mark, its checksum
  /// does not match, or it goes on for more than a mebibyte (a few kilobytes inflate to gigabytes of zeros).
  void finish();
  /// The most bytes that can still follow: deflate shrinks by a factor of at most 1032.
  std::uintmax_t possible_bytes() const;
  /// How many bytes of the file itself, from its beginning, were handed out; for plain files only.
  std::uintmax_t consumed() const;
  Encoding encoding() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  struct State;
  std::filesystem::path path_;
  std::unique_ptr<State> state_;
};

std::size_t bytes_of(SampleType type);

/// `count` numbers, for float and double, out of bytes that hold as many of the type.
template <class Number>
void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, Number* numbers);

/// "unsigned short", "u16", "uint16" and the like; std::nullopt for a name that is none of them.
std::optional<SampleType> sample_type(const std::string& name);

/// Appends `count` samples to `samples` and makes sure that a compressed stream ends whole. Throws DataError if the
/// file holds fewer; what it can hold is checked before anything is allocated, and memory is taken as samples arrive,
/// so a hostile size costs nothing.
void read_samples(ByteReader& reader, std::size_t count, SampleType type, ByteOrder order, std::vector<float>& samples);

/// `count` numbers written as text.
void read_text_samples(ByteReader& reader, std::size_t count, std::vector<float>& samples);

}  // namespace isobench
