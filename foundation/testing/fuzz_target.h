// Fuzzing. A target is a function `bool isobench::fuzz_<name>(std::string_view bytes)` in a *_fuzz.cpp beside the code
// that it tries, named in the CMakeLists.txt of its floor. It takes any bytes as input and returns whether they were
// valid. CMake makes two things from it:
//   - the libFuzzer program fuzz-<name> (preset "fuzz", section "fuzz" of .ci/run), which searches for harmful inputs,
//     starting from those in corpus/<name>/ beside the target;
//   - the test Corpus.<name>, which tries every file of that corpus in any build.
// A target may refuse an input with a UsageError or a DataError. Any other exception is a finding. When a finding is
// fixed, its input becomes a file of the corpus.
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

/// Reports a finding if `holds` is false. It must be true for every input.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error("required of every input: " + what);
}

/// Runs `body`, which returns whether its input was valid. Returns false if the input was refused with a proper error.
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

/// Writes the bytes to a file, for targets that read by path, and returns its path. Each process has its own folder.
inline std::filesystem::path fuzz_file(const std::string& name, std::string_view bytes) {
  static const TestFolder folder;
  std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace isobench
