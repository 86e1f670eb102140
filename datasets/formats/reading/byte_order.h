// The order of the bytes of a number in a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

namespace isobench {

enum class ByteOrder { little, big };

inline constexpr ByteOrder native_order = std::endian::native == std::endian::big ? ByteOrder::big : ByteOrder::little;

/// The number that begins at `bytes`, which need not be aligned.
template <class Number>
Number number_at(const char* bytes, ByteOrder order) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), bytes, raw.size());
  if (order != native_order) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Turns numbers in this byte order into numbers of this machine's.
template <class Number>
void to_native_order(std::span<Number> numbers, ByteOrder order) {
  if (sizeof(Number) == 1 || order == native_order) return;
  for (Number& number : numbers) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    std::reverse(raw.begin(), raw.end());
    number = std::bit_cast<Number>(raw);
  }
}

}  // namespace isobench
