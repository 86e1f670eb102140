// The bytes of one file, unpacked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>

#include "isobench/datasets/formats/reading/byte_reader.h"

namespace isobench {

/// By which factor an encoding can compress at most.
std::uintmax_t most_compression(Encoding encoding);

/// The bytes of a file on disk from where its data begin. Throws DataError if the file cannot be opened.
std::uintmax_t packed_bytes(const DataFile& file);

/// Reads one file from where its data begin; the encodings are derived classes.
class ByteReader::Stream {
 public:
  explicit Stream(const DataFile& file);
  virtual ~Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Up to `count` bytes, at least one but at the end.
  virtual std::size_t read(char* bytes, std::size_t count) = 0;
  /// Skips up to `count` bytes; 0 if they must be read.
  virtual std::uintmax_t skip(std::uintmax_t /*count*/) { return 0; }
  /// False if the file stopped before its encoded data did.
  virtual bool is_complete() const { return true; }
  virtual std::uintmax_t possible_bytes() const = 0;
  std::uintmax_t position() const { return size_ - left_; }

  static std::unique_ptr<Stream> open(const DataFile& file, Encoding encoding);

 protected:
  std::size_t read_file(char* bytes, std::size_t count);
  std::uintmax_t skip_file(std::uintmax_t count);
  const std::filesystem::path& path() const { return path_; }
  std::uintmax_t left() const { return left_; }
  [[noreturn]] void throw_damaged() const;

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::uintmax_t size_ = 0;
  std::uintmax_t left_ = 0;
};

}  // namespace isobench
