// For tests: bytes as files hold them, and environment variables that go when the test ends.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "isobench/foundation/testing/test_folder.h"

namespace isobench {

/// An environment variable for the length of a test.
class TestVariable {
 public:
  TestVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    had_ = std::getenv(name) != nullptr;
    setenv(name, value.c_str(), 1);
  }
  ~TestVariable() {
    if (had_)
      setenv(name_, before_.c_str(), 1);
    else
      unsetenv(name_);
  }
  TestVariable(const TestVariable&) = delete;
  TestVariable& operator=(const TestVariable&) = delete;

 private:
  const char* name_;
  std::string before_;
  bool had_ = false;
};

/// Deflated with a gzip (`gzip` true) or zlib header.
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

/// The bytes of one value, in the machine's order or swapped.
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
