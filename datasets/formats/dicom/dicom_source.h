// The bytes of a DICOM file, the rest of which may be deflated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace isobench {

/// Reads bytes in order. Throws DataError naming the file if it cannot be opened, if it ends too early, or if its
/// deflated part is damaged.
class DicomSource {
 public:
  explicit DicomSource(const std::filesystem::path& path);
  ~DicomSource();
  DicomSource(const DicomSource&) = delete;
  DicomSource& operator=(const DicomSource&) = delete;

  void read(char* bytes, std::size_t count);
  void skip(std::uintmax_t count);
  /// Skips to a position, which must not lie before the present one.
  void skip_to(std::uintmax_t position) { skip(position - position_); }
  /// The next bytes, which are read again afterwards; fewer at the end.
  std::string peek(std::size_t count);
  /// Takes what follows for a deflated stream without a header. Its bytes count on from the present position.
  void inflate_rest();

  /// How many bytes have been read.
  std::uintmax_t position() const { return position_; }
  /// The most bytes that can still follow: exact unless they are deflated.
  std::uintmax_t possible_bytes() const;
  bool is_deflated() const { return inflating_ != nullptr; }
  const std::filesystem::path& path() const { return path_; }

 private:
  class File;
  class Inflating;
  std::size_t read_some(char* bytes, std::size_t count);

  std::filesystem::path path_;
  std::unique_ptr<File> file_;
  std::unique_ptr<Inflating> inflating_;
  std::string ahead_;  // read by peek()
  std::uintmax_t position_ = 0;
};

}  // namespace isobench
