// For the tests Corpus.<name>, which give every file of a corpus to its fuzz target.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "isobench/foundation/files/whole_files.h"

namespace isobench {

/// No file may do harm or make the target print. Files named "good…" must be accepted and all others refused. A corpus
/// needs both kinds, so that both outcomes are tried.
inline void try_corpus(const std::filesystem::path& folder, bool (*target)(std::string_view)) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::size_t good = 0;
  std::string findings;  // reported at the end, because anything printed before is a finding, too
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::filesystem::path& file : files) {
    const std::string bytes = read_text(file);
    const std::string name = file.filename().string();
    bool accepted = false;
    try {
      accepted = target(bytes);
    } catch (const std::exception& error) {
      findings += name + ": " + error.what() + "\n";
    }
    if (accepted) ++good;
    if (accepted != name.starts_with("good")) findings += name + (accepted ? ": accepted\n" : ": refused\n");
  }
  findings += testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_EQ(findings, "") << folder;
  EXPECT_GT(good, 0U);
  EXPECT_LT(good, files.size());
}

}  // namespace isobench
