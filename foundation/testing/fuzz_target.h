// Fuzzing. A target is a function `bool isobench::fuzz_<name>(std::string_view bytes)` in a *_fuzz.cpp beside the code
// that it tries, listed in its folder's CMakeLists.txt: it takes any bytes for an input and returns whether they were a
// good one. From it come
//   - the libFuzzer program fuzz-<name> (preset "asan", section "fuzz" of .ci/run), which looks for inputs that do
//     harm, starting from corpus/<name>/ beside the target;
//   - the test Corpus.<name> of the folder's suite, which tries every file of that corpus, in any build.
// Whatever harm is found becomes a file of the corpus when it is mended. An input may be refused with a UsageError or a
// DataError. Everything else that leaves a target is a finding.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {

/// A finding: of a state that no input may lead to.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error("required of every input: " + what);
}

/// Runs `body`, which returns whether its input was a good one; false where that was refused as it should be.
template <class Body>
bool accepts(Body&& body) {
  const auto check = [](const Error& error) {
    const std::string message = error.what();
    require(!message.empty() && message.size() < 5000, "an error says something, and not everything");
    require(printable(message) == message || message.size() > 1000, "an error is one printable line");
    return false;
  };
  try {
    return body();
  } catch (const UsageError& error) {
    return check(error);
  } catch (const DataError& error) {
    return check(error);
  }
}

/// A file of these bytes, in a folder of this process that all targets share; what is read by path is tried so.
inline std::filesystem::path fuzz_file(const std::string& name, std::string_view bytes) {
  static const TestFolder folder;
  std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace isobench
