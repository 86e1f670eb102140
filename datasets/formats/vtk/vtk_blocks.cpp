#include "isobench/datasets/formats/vtk/vtk_blocks.h"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "isobench/datasets/formats/reading/sample_data.h"

namespace isobench {

namespace {

/// 0 to 63; -1 for a character that is not a digit of base64.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// The length that `bytes` bytes have in the source.
std::size_t encoded_size(std::size_t bytes, bool base64) { return base64 ? (bytes + 2) / 3 * 4 : bytes; }

/// The first `bytes` bytes of a source; std::nullopt if it does not hold them.
std::optional<std::string> take(std::string_view source, std::size_t bytes, bool base64) {
  if (bytes > source.size() || encoded_size(bytes, base64) > source.size()) return {};
  if (!base64) return std::string(source.substr(0, bytes));
  std::string result;
  result.reserve(bytes + 2);
  for (std::size_t at = 0; result.size() < bytes; at += 4) {
    unsigned group = 0;
    for (std::size_t n = 0; n < 4; ++n) {
      const int digit = base64_digit(source[at + n]);
      // Only the last group may be padded, if fewer than its three bytes are needed.
      if (digit < 0 && (source[at + n] != '=' || result.size() + n <= bytes)) return {};
      group = group << 6U | static_cast<unsigned>(std::max(digit, 0));
    }
    for (const unsigned shift : {16U, 8U, 0U}) result.push_back(static_cast<char>(group >> shift & 0xFFU));
  }
  result.resize(bytes);
  return result;
}

/// The whole numbers of a header.
std::optional<std::vector<std::uint64_t>> header_of(const VtkBlocks& blocks, std::size_t count) {
  const std::size_t width = blocks.wide_header ? 8 : 4;
  if (count > blocks.source.size() / width) return {};
  const std::optional<std::string> bytes = take(blocks.source, count * width, blocks.base64);
  if (!bytes) return {};
  std::vector<std::uint64_t> numbers;
  for (std::size_t n = 0; n < count; ++n) {
    std::uint64_t value = 0;
    for (std::size_t b = 0; b < width; ++b) {
      const std::size_t digit = blocks.order == ByteOrder::big ? b : width - 1 - b;
      value = value << 8U | static_cast<unsigned char>((*bytes)[n * width + digit]);
    }
    numbers.push_back(value);
  }
  return numbers;
}

/// Decompresses a block to `out`; false unless the block is complete and has exactly this size.
bool inflate_block(VtkCompressor compressor, std::string_view block, char* out, std::size_t size) {
  const auto* in = reinterpret_cast<const unsigned char*>(block.data());
  auto* target = reinterpret_cast<unsigned char*>(out);
  constexpr std::size_t largest = std::numeric_limits<int>::max();
  if (block.size() > largest || size > largest) return false;
  if (compressor == VtkCompressor::lz4) {
    return LZ4_decompress_safe(block.data(), out, static_cast<int>(block.size()), static_cast<int>(size)) ==
           static_cast<int>(size);
  }
  if (compressor == VtkCompressor::lzma) {
    std::uint64_t memory = std::uint64_t{1} << 28U;
    std::size_t in_position = 0;
    std::size_t out_position = 0;
    return lzma_stream_buffer_decode(&memory, 0, nullptr, in, &in_position, block.size(), target, &out_position,
                                     size) == LZMA_OK &&
           out_position == size;
  }
  uLongf length = size;
  return uncompress(target, &length, in, block.size()) == Z_OK && length == size;
}

/// The header has the number of blocks, the size of a block, the size of the last block (0 if it is as large as the
/// others), all before compression, and then the size of every block after compression.
std::optional<std::string> inflated(const VtkBlocks& blocks, std::size_t bytes) {
  const auto head = header_of(blocks, 3);
  if (!head) return {};
  const std::uint64_t count = (*head)[0];
  const std::uint64_t size = (*head)[1];
  const std::uint64_t last = (*head)[2] == 0 ? size : (*head)[2];
  if (count == 0 || count > blocks.source.size() || size > bytes + (std::uint64_t{1} << 32U) || last > size) return {};
  if ((count - 1) > bytes / std::max<std::uint64_t>(size, 1) || (count - 1) * size + last != bytes) return {};
  const auto header = header_of(blocks, 3 + count);
  if (!header) return {};
  std::uint64_t stored = 0;
  for (std::size_t n = 3; n < header->size(); ++n) {
    // No compressor does better: LZMA compresses zeros by a factor of seven thousand.
    const std::uint64_t one = (*header)[n];
    if (one > blocks.source.size() || (n + 1 < header->size() ? size : last) > 10000 * (one + 1)) return {};
    stored += one;
  }
  const std::size_t width = blocks.wide_header ? 8 : 4;
  const std::size_t begin = encoded_size(header->size() * width, blocks.base64);
  const auto data = take(blocks.source.substr(std::min(begin, blocks.source.size())), stored, blocks.base64);
  if (!data) return {};
  std::string result;
  std::size_t at = 0;
  for (std::size_t n = 3; n < header->size(); ++n) {
    const std::size_t whole = n + 1 < header->size() ? size : last;
    result.resize(result.size() + whole);
    const std::string_view block = std::string_view(*data).substr(at, (*header)[n]);
    if (!inflate_block(blocks.compressor, block, result.data() + result.size() - whole, whole)) return {};
    at += block.size();
  }
  return result;
}

}  // namespace

std::optional<std::string> decoded(const VtkBlocks& blocks, std::size_t bytes) {
  if (blocks.compressor != VtkCompressor::none) return inflated(blocks, bytes);
  const auto head = header_of(blocks, 1);
  if (!head || head->front() != bytes) return {};
  const std::size_t width = blocks.wide_header ? 8 : 4;
  auto data = take(blocks.source, width + bytes, blocks.base64);
  if (data) data->erase(0, width);
  return data;
}

}  // namespace isobench
