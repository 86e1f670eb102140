// For tests: bytes as files hold them.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace isobench {

/// The bytes, compressed by deflate, with a gzip header if `gzip`, otherwise with a zlib header.
inline std::string deflated(const std::string& bytes, bool gzip) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// The bytes of one value, in the order of this machine or in the other one (`swapped`).
template <class Value>
std::string bytes_of_value(Value value, bool swapped = false) {
  std::string bytes(sizeof(Value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Value));
  return swapped ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

template <class Sample>
std::string bytes_of_samples(const std::vector<float>& samples, bool swapped = false) {
  std::string bytes;
  for (const float sample : samples) bytes += bytes_of_value(static_cast<Sample>(sample), swapped);
  return bytes;
}

}  // namespace isobench
