// Random numbers by index. The n-th number does not depend on who asks for it, so results do not depend on threads.
#pragma once

#include <cstdint>

namespace isobench {

/// SplitMix64 (Steele, Lea, Flood 2014).
inline std::uint64_t split_mix_64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1), determined by (seed, index, stream).
inline double uniform_random(std::uint64_t seed, std::uint64_t index, std::uint64_t stream) {
  return static_cast<double>(split_mix_64(split_mix_64(split_mix_64(seed) ^ index) ^ stream) >> 11) * 0x1p-53;
}

}  // namespace isobench
