// Binary numbers in a file's bytes, of either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

namespace isobench {

static_assert(std::endian::native == std::endian::little, "the mesh files are written in the machine's own byte order");

/// Takes a number off the front of `bytes`. Precondition: there are enough of them.
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
