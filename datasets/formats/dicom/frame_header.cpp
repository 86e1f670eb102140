#include "isobench/datasets/formats/dicom/frame_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace isobench {

namespace {

/// What the header of a frame states.
struct FrameSize {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  std::uint64_t components = 0;
  std::uint64_t bits = 0;
};

std::uint64_t big(std::string_view data, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t n = 0; n < bytes; ++n) value = value << 8U | static_cast<unsigned char>(data[at + n]);
  return value;
}

/// From the frame header of JPEG (ITU-T T.81, B.2.2) and JPEG-LS (T.87, C.2.2).
std::optional<FrameSize> size_in_jpeg(std::string_view data) {
  if (data.size() < 4 || !data.starts_with("\xff\xd8")) return std::nullopt;
  for (std::size_t at = 2; at + 4 <= data.size();) {
    if (data[at] != '\xff') return std::nullopt;
    const std::uint64_t marker = big(data, at + 1, 1);
    if (marker == 0xFF) {  // a fill byte
      ++at;
      continue;
    }
    const std::uint64_t length = big(data, at + 2, 2);
    const bool is_frame =
        (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) || marker == 0xF7;
    if (is_frame) {
      if (at + 10 > data.size()) return std::nullopt;
      return FrameSize{big(data, at + 5, 2), big(data, at + 7, 2), big(data, at + 9, 1), big(data, at + 4, 1)};
    }
    if (length < 2 || marker == 0xDA) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

/// From the marker SIZ (ITU-T T.800, A.5.1), which follows that of the code stream's beginning.
std::optional<FrameSize> size_in_jpeg_2000(std::string_view data) {
  const std::size_t at = data.find(std::string_view("\xff\x4f\xff\x51", 4));
  if (at == std::string_view::npos || at + 43 > data.size()) return std::nullopt;
  const std::uint64_t x0 = big(data, at + 16, 4);
  const std::uint64_t y0 = big(data, at + 20, 4);
  const std::uint64_t components = big(data, at + 40, 2);
  FrameSize size{big(data, at + 12, 4) - x0, big(data, at + 8, 4) - y0, components, 0};
  for (std::size_t n = 0; n < components; ++n) {
    const std::size_t component = at + 42 + 3 * n;
    if (component + 3 > data.size()) return std::nullopt;
    // Components of another resolution would have another size.
    if (data[component + 1] != 1 || data[component + 2] != 1) return std::nullopt;
    size.bits = std::max(size.bits, (big(data, component, 1) & 0x7FU) + 1);
  }
  // Tiles must not be so small that their number takes the memory.
  const std::uint64_t tile_columns = big(data, at + 24, 4);
  const std::uint64_t tile_rows = big(data, at + 28, 4);
  if (x0 != 0 || y0 != 0 || tile_columns == 0 || tile_rows == 0) return std::nullopt;
  const std::uint64_t tiles = (size.columns / tile_columns + 1) * (size.rows / tile_rows + 1);
  return tiles <= 65535 ? std::optional(size) : std::nullopt;
}

/// From the header of RLE (DICOM PS3.5, G.5): a segment for each byte of a sample.
std::string check_rle(std::string_view data, const DicomLayout& layout) {
  constexpr std::size_t header = 64;
  if (data.size() < header) return "it is shorter than its header";
  const auto segments = static_cast<std::size_t>(layout.components * layout.allocated / 8);
  const auto number = [&](std::size_t n) { return number_at<std::uint32_t>(data.data() + 4 * n, ByteOrder::little); };
  if (number(0) != segments || segments > 15) return fmt::format("its header states {} segments", number(0));
  for (std::size_t n = 1; n <= segments; ++n) {
    const std::size_t begin = number(n);
    if (begin < header || begin > data.size() || (n > 1 && begin < number(n - 1)))
      return "its segments are not in order";
  }
  return "";
}

}  // namespace

std::string check_frame_header(std::string_view data, const DicomImage& image) {
  const DicomLayout& layout = image.layout;
  const std::string& syntax = image.transfer_syntax;
  if (syntax == "1.2.840.10008.1.2.5") return check_rle(data, layout);
  const bool is_2000 = syntax == "1.2.840.10008.1.2.4.90" || syntax == "1.2.840.10008.1.2.4.91";
  const std::optional<FrameSize> size = is_2000 ? size_in_jpeg_2000(data) : size_in_jpeg(data);
  if (!size) return "it does not begin as such data do";
  const bool same = size->rows == static_cast<std::uint64_t>(layout.rows) &&
                    size->columns == static_cast<std::uint64_t>(layout.columns) &&
                    size->components == static_cast<std::uint64_t>(layout.components) &&
                    size->bits <= static_cast<std::uint64_t>(layout.allocated) && size->bits > 0;
  if (same) return "";
  return fmt::format("they hold {} × {} samples of {} × {} bits, its header states {} × {} of {} × {}", size->columns,
                     size->rows, size->components, size->bits, layout.columns, layout.rows, layout.components,
                     layout.allocated);
}

}  // namespace isobench
