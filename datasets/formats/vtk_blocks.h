// The bytes of one array of a VTK XML file, out of base64 and out of its compressed blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isobench/datasets/formats/read_volume.h"

namespace isobench {

enum class VtkCompressor { none, zlib, lz4, lzma };

struct VtkBlocks {
  std::string_view source;  ///< from the array's first byte on; it may go on beyond its last one
  bool base64 = false;
  bool wide_header = false;  ///< the numbers in front of the data have 64 bits, else 32
  ByteOrder order = ByteOrder::little;
  VtkCompressor compressor = VtkCompressor::none;
};

/// Exactly `bytes` bytes of data; std::nullopt where the source is damaged or does not hold as many. Nothing is
/// allocated that the source could not fill.
std::optional<std::string> decoded(const VtkBlocks& blocks, std::size_t bytes);

}  // namespace isobench
