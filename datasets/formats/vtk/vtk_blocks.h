// Decoding the bytes of one array of a VTK XML file, which may be in base64 and in compressed blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isobench/datasets/formats/reading/byte_order.h"

namespace isobench {

enum class VtkCompressor { none, zlib, lz4, lzma };

struct VtkBlocks {
  std::string_view source;  ///< begins at the array's first byte; may reach beyond its last one
  bool base64 = false;
  bool wide_header = false;  ///< the numbers in front of the data have 64 bits instead of 32
  ByteOrder order = ByteOrder::little;
  VtkCompressor compressor = VtkCompressor::none;
};

/// Exactly `bytes` bytes of data; std::nullopt if the source is damaged or does not hold them. Takes no more memory
/// than the source could fill.
std::optional<std::string> decoded(const VtkBlocks& blocks, std::size_t bytes);

}  // namespace isobench
