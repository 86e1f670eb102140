#include "isobench/datasets/formats/tiff/tiff_file.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <optional>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t tiff_pages_limit = std::size_t{1} << 20U;

/// By which factor a compression can shrink data, at most.
std::uint64_t most_compression(std::uint16_t compression) {
  switch (compression) {
    case COMPRESSION_NONE:
      return 1;
    case COMPRESSION_PACKBITS:
      return 64;
    case COMPRESSION_LZW:
      return 4096;
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
      return 1032;
    default:
      return std::uint64_t{1} << 16U;
  }
}

std::optional<SampleType> tiff_type(std::uint16_t format, std::uint16_t bits) {
  const bool is_real = format == SAMPLEFORMAT_IEEEFP;
  const bool is_signed = format == SAMPLEFORMAT_INT;
  if (!is_real && !is_signed && format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID) return std::nullopt;
  switch (bits) {
    case 8:
      return is_real ? std::nullopt : std::optional(is_signed ? SampleType::i8 : SampleType::u8);
    case 16:
      return is_real ? std::nullopt : std::optional(is_signed ? SampleType::i16 : SampleType::u16);
    case 32:
      return is_real ? SampleType::f32 : is_signed ? SampleType::i32 : SampleType::u32;
    case 64:
      return is_real ? SampleType::f64 : is_signed ? SampleType::i64 : SampleType::u64;
    default:
      return std::nullopt;
  }
}

bool is_known_photometric(std::uint16_t photometric, std::uint16_t compression) {
  switch (photometric) {
    case PHOTOMETRIC_MINISBLACK:
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_RGB:
    case PHOTOMETRIC_PALETTE:
    case PHOTOMETRIC_MASK:
      return true;
    default:
      return photometric == PHOTOMETRIC_YCBCR && compression == COMPRESSION_JPEG;  // libtiff makes RGB of it
  }
}

}  // namespace

class TiffFile::Handle {
 public:
  explicit Handle(const std::filesystem::path& path) : path_(path) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options, drop_warning, nullptr);
    // Without a map of the file into memory: a file that another program shortens would end this one.
    tiff_ = TIFFOpenExt(path.c_str(), "rm", options);
    TIFFOpenOptionsFree(options);
    if (tiff_ == nullptr) fail("not a TIFF file, or damaged; copy or export it again");
  }
  ~Handle() {
    if (tiff_ != nullptr) TIFFClose(tiff_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  TIFF* get() const { return tiff_; }

  /// Throws; the message quotes the first error of libtiff.
  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(fmt::format("{}: {}{}", path_.string(), what, error_.empty() ? "" : " (libtiff: " + error_ + ")"));
  }
  bool has_error() const { return !error_.empty(); }

  template <class Number>
  Number field(std::uint32_t tag, Number otherwise) const {
    Number value{};
    return TIFFGetFieldDefaulted(tiff_, tag, &value) == 1 ? value : otherwise;
  }

 private:
  static int keep_error(TIFF* /*tiff*/, void* handle, const char* /*module*/, const char* format, va_list values) {
    std::array<char, 160> text{};
    std::vsnprintf(text.data(), text.size(), format, values);
    std::string& error = static_cast<Handle*>(handle)->error_;
    if (error.empty()) error = text.data();
    return 1;
  }
  static int drop_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  const std::filesystem::path& path_;
  TIFF* tiff_ = nullptr;
  std::string error_;
};

TiffFile::TiffFile(const std::filesystem::path& path) : path_(path), handle_(std::make_unique<Handle>(path_)) {
  do {
    if (pages_.size() >= tiff_pages_limit) handle_->fail(fmt::format("more than {} pages", tiff_pages_limit));
    pages_.push_back(read_page());
  } while (TIFFReadDirectory(handle_->get()) == 1);
  if (handle_->has_error()) handle_->fail("damaged: its list of pages breaks off; copy or export it again");
}

TiffFile::~TiffFile() = default;

ByteOrder TiffFile::order() const { return TIFFIsBigEndian(handle_->get()) != 0 ? ByteOrder::big : ByteOrder::little; }

TiffPage TiffFile::read_page() {
  TIFF* tiff = handle_->get();
  const std::size_t number = pages_.size() + 1;
  TiffPage page;
  page.offset = TIFFCurrentDirOffset(tiff);
  page.is_reduced = (handle_->field<std::uint32_t>(TIFFTAG_SUBFILETYPE, 0) &
                     (std::uint32_t{FILETYPE_REDUCEDIMAGE} | std::uint32_t{FILETYPE_MASK})) != 0;
  page.layout = read_layout(number, page.is_reduced);
  const auto compression = handle_->field<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  if (TIFFIsCODECConfigured(compression) == 0)
    handle_->fail(fmt::format("its compression {} is not known; export it with deflate, LZW or none", compression));
  most_compression_ = std::max(most_compression_, most_compression(compression));
  const auto photometric = handle_->field<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (!is_known_photometric(photometric, compression))
    handle_->fail(fmt::format("its page {} has colours that are not RGB; convert it to grey", number));
  page.is_palette = photometric == PHOTOMETRIC_PALETTE;
  page.is_white_at_zero = photometric == PHOTOMETRIC_MINISWHITE;
  page.x_resolution = handle_->field<float>(TIFFTAG_XRESOLUTION, 0.0F);
  page.y_resolution = handle_->field<float>(TIFFTAG_YRESOLUTION, 0.0F);
  const auto unit = handle_->field<std::uint16_t>(TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  page.unit = unit == RESUNIT_CENTIMETER ? 10.0 : unit == RESUNIT_INCH ? 25.4 : 0.0;
  const char* description = handle_->field<const char*>(TIFFTAG_IMAGEDESCRIPTION, nullptr);
  if (description != nullptr && pages_.empty()) page.description = description;
  const std::uint64_t* offsets = nullptr;
  if (compression == COMPRESSION_NONE && TIFFIsTiled(tiff) == 0 && TIFFNumberOfStrips(tiff) == 1 &&
      TIFFGetField(tiff, TIFFTAG_STRIPOFFSETS, &offsets) == 1 && offsets != nullptr)
    page.data_offset = offsets[0];
  return page;
}

TiffLayout TiffFile::read_layout(std::size_t number, bool is_reduced) {
  TiffLayout layout;
  layout.columns = handle_->field<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0);
  layout.rows = handle_->field<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0);
  layout.components = handle_->field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
  if (layout.columns < 1 || layout.rows < 1 || layout.components < 1)
    handle_->fail(fmt::format("damaged: its page {} has no samples; copy or export it again", number));
  const auto bits = handle_->field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
  const std::optional<SampleType> type = tiff_type(handle_->field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, 1), bits);
  if (!type && !is_reduced) {
    handle_->fail(fmt::format(
        "its page {} has samples of {} bits that cannot be read; convert it to whole numbers of 8, 16 or 32 bits, or "
        "floating-point numbers of 32 or 64",
        number, bits));
  }
  layout.type = type.value_or(SampleType::u8);
  return layout;
}

void TiffFile::check_bytes(std::uint64_t bytes) {
  constexpr std::uint64_t always = std::uint64_t{1} << 16U;
  const std::uint64_t file = std::filesystem::file_size(path_);
  if (bytes / most_compression_ > file && (bytes > always || most_compression_ == 1)) {
    handle_->fail(fmt::format(
        "truncated: its pages state {} bytes of samples, but the file has {}; copy or export it again", bytes, file));
  }
}

namespace {

/// Strips and tiles in one: a rectangle of samples.
struct TiffChunk {
  long long column = 0;
  long long row = 0;
  long long columns = 0;  ///< stored; tiles may reach beyond the page
  long long rows = 0;
};

/// Copies one component of a chunk to its place in a page.
template <class T>
void copy_chunk(const std::vector<char>& bytes, const TiffChunk& chunk, std::size_t stride, std::size_t component,
                const TiffLayout& layout, T* page) {
  const long long columns = std::min(chunk.columns, layout.columns - chunk.column);
  const long long rows = std::min(chunk.rows, layout.rows - chunk.row);
  for (long long row = 0; row < rows; ++row) {
    const char* from = bytes.data() + (static_cast<std::size_t>(row * chunk.columns) * stride + component) * sizeof(T);
    T* to = page + (chunk.row + row) * layout.columns + chunk.column;
    for (long long column = 0; column < columns; ++column, from += stride * sizeof(T))
      std::memcpy(to++, from, sizeof(T));
  }
}

}  // namespace

void TiffFile::read(const TiffPage& page, std::size_t component, Samples& samples) {
  TIFF* tiff = handle_->get();
  const auto number = static_cast<std::size_t>(&page - pages_.data()) + 1;
  const auto damaged = [&]() { handle_->fail(fmt::format("its page {} is damaged; copy or export it again", number)); };
  if (TIFFSetSubDirectory(tiff, page.offset) != 1) damaged();
  const TiffLayout& layout = page.layout;
  if (handle_->field<std::uint16_t>(TIFFTAG_PHOTOMETRIC, 0) == PHOTOMETRIC_YCBCR)
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  const bool is_tiled = TIFFIsTiled(tiff) != 0;
  const bool is_separate =
      layout.components > 1 && handle_->field<std::uint16_t>(TIFFTAG_PLANARCONFIG, 1) == PLANARCONFIG_SEPARATE;
  const std::uint64_t chunk_bytes = is_tiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff);
  check_bytes(chunk_bytes);
  std::vector<char> bytes(static_cast<std::size_t>(chunk_bytes));
  TiffChunk chunk;
  chunk.columns = is_tiled ? handle_->field<std::uint32_t>(TIFFTAG_TILEWIDTH, 0) : layout.columns;
  chunk.rows = is_tiled ? handle_->field<std::uint32_t>(TIFFTAG_TILELENGTH, 0)
                        : std::min<long long>(handle_->field<std::uint32_t>(TIFFTAG_ROWSPERSTRIP, 0), layout.rows);
  const std::size_t stride = is_separate ? 1 : layout.components;
  const auto row_bytes = static_cast<std::uint64_t>(chunk.columns) * stride * bytes_of(layout.type);
  if (chunk.columns < 1 || chunk.rows < 1 || chunk_bytes < row_bytes * static_cast<std::uint64_t>(chunk.rows))
    damaged();
  samples.visit([&](auto& values) {
    const std::size_t done = values.size();
    values.resize(done + static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows));
    for (; chunk.row < layout.rows; chunk.row += chunk.rows) {
      for (chunk.column = 0; chunk.column < layout.columns; chunk.column += chunk.columns) {
        const auto x = static_cast<std::uint32_t>(chunk.column);
        const auto y = static_cast<std::uint32_t>(chunk.row);
        const auto plane = static_cast<std::uint16_t>(is_separate ? component : 0);
        const std::uint32_t place = is_tiled ? TIFFComputeTile(tiff, x, y, 0, plane) : TIFFComputeStrip(tiff, y, plane);
        const auto size = static_cast<tmsize_t>(bytes.size());
        const tmsize_t got = is_tiled ? TIFFReadEncodedTile(tiff, place, bytes.data(), size)
                                      : TIFFReadEncodedStrip(tiff, place, bytes.data(), size);
        const long long rows = is_tiled ? chunk.rows : std::min(chunk.rows, layout.rows - chunk.row);
        if (got < static_cast<tmsize_t>(row_bytes) * rows) damaged();
        copy_chunk(bytes, chunk, stride, is_separate ? 0 : component, layout, values.data() + done);
      }
    }
  });
}

}  // namespace isobench
