// For tests: what a reader says about how it read a file.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "isobench/datasets/formats/read_volume.h"

namespace isobench {

inline VolumeChoice chosen(std::optional<std::size_t> step, std::optional<std::size_t> component = {}) {
  VolumeChoice choice;
  choice.step = step;
  choice.component = component;
  return choice;
}

/// Reads the file and expects exactly one note, a single sentence that has `part` and begins with the path of the file,
/// or of its header.
inline Volume volume_with_note(const std::filesystem::path& path, const std::string& part,
                               const VolumeChoice& choice = {}) {
  VolumeFile file = read_volume(path, choice);
  EXPECT_EQ(file.notes.size(), 1U) << path;
  for (const std::string& note : file.notes) {
    EXPECT_NE(note.find(part), std::string::npos) << note;
    EXPECT_TRUE(note.starts_with((path.parent_path() / path.stem()).string())) << note;
    EXPECT_EQ(note.find('\n'), std::string::npos) << note;
    EXPECT_NE(note.back(), '.') << note;
  }
  return std::move(file.volume);
}

/// Reads the file and expects nothing to be said.
inline Volume volume_without_note(const std::filesystem::path& path, const VolumeChoice& choice = {}) {
  VolumeFile file = read_volume(path, choice);
  for (const std::string& note : file.notes) ADD_FAILURE() << note;
  return std::move(file.volume);
}

}  // namespace isobench
