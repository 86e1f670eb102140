// For the tests Corpus.<name>: every file of a fuzz target's corpus through the target.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace isobench {

/// None of the files may do harm or print. Those named "good…" are accepted and all others refused; there are both, or
/// the corpus would not reach what it is for.
inline void try_corpus(const std::filesystem::path& folder, bool (*target)(std::string_view)) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::size_t good = 0;
  std::string findings;  // told afterwards: what is printed meanwhile is a finding, too
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
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
