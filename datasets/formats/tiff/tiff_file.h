// The pages of a TIFF file, through libtiff.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/samples.h"

namespace isobench {

/// How a page stores its samples.
struct TiffLayout {
  long long columns = 0;
  long long rows = 0;
  std::size_t components = 1;
  SampleType type = SampleType::u8;

  bool operator==(const TiffLayout&) const = default;
};

struct TiffPage {
  TiffLayout layout;
  std::uint64_t offset = 0;       ///< of its directory in the file
  bool is_reduced = false;        ///< a smaller copy or a mask of another page
  bool is_palette = false;        ///< samples are places in a table of colours
  bool is_white_at_zero = false;  ///< small samples are bright
  std::uint64_t data_offset = 0;  ///< of its first sample, where all lie in one plain piece; 0 elsewhere
  double x_resolution = 0.0;      ///< samples per unit; 0 if not stated
  double y_resolution = 0.0;
  double unit = 0.0;  ///< mm of the unit of the resolutions; 0 if none is stated
  std::string description;
};

/// An open file. Errors of libtiff become DataErrors that name the file; its warnings are dropped.
class TiffFile {
 public:
  /// Reads the directories of all pages. Throws DataError if it is not a TIFF file, if it is damaged, or if a page has
  /// samples that are not whole or floating-point numbers of 8 to 64 bits.
  explicit TiffFile(const std::filesystem::path& path);
  ~TiffFile();
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  const std::vector<TiffPage>& pages() const { return pages_; }
  ByteOrder order() const;

  /// Appends one component of a page, which is one of pages(), to samples of the page's type. Throws DataError where
  /// the data are damaged. Takes memory for the page, and for one strip or tile.
  void read(const TiffPage& page, std::size_t component, Samples& samples);
  /// Throws DataError if the file is too small for so many bytes of samples, compressed as its pages are.
  void check_bytes(std::uint64_t bytes);

 private:
  class Handle;
  TiffPage read_page();
  TiffLayout read_layout(std::size_t number, bool is_reduced);

  std::filesystem::path path_;
  std::unique_ptr<Handle> handle_;
  std::vector<TiffPage> pages_;
  std::uint64_t most_compression_ = 1;
};

}  // namespace isobench
