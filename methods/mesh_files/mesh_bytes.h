// Reads and writes binary numbers in a file's bytes, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

namespace isobench {

static_assert(std::endian::native == std::endian::little, "the mesh files are written in the machine's own byte order");

/// Removes a number from the front of `bytes` and returns it. Precondition: there are enough bytes.
template <typename Number>
Number take_number(std::string_view& bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> raw{};
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  bytes.remove_prefix(raw.size());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Appends a number in little-endian order.
template <typename Number>
void put_number(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());
}

}  // namespace isobench
