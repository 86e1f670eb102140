// For tests of formats: small arrays with more axes than space has, encodings, and notes.
#pragma once

#include <bzlib.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "isobench/datasets/formats/testing/oblique_files.h"

namespace isobench {

inline std::string bzipped(const std::string& bytes) {
  std::string out(bytes.size() + bytes.size() / 50 + 1000, '\0');
  auto size = static_cast<unsigned>(out.size());
  std::string in = bytes;
  BZ2_bzBuffToBuffCompress(out.data(), &size, in.data(), static_cast<unsigned>(in.size()), 9, 0, 0);
  out.resize(size);
  return out;
}

/// Two digits a byte, 20 bytes a line, in either case.
inline std::string hex_text(const std::string& bytes) {
  std::string text;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const auto byte = static_cast<unsigned char>(bytes[n]);
    text += n % 2 == 0 ? fmt::format("{:02x}", byte) : fmt::format("{:02X}", byte);
    if (n % 20 == 19) text += '\n';
  }
  return text;
}

/// The small volume's samples as numbers of 16 bits.
inline const std::string shorts = bytes_of_samples<std::int16_t>(samples());

/// A header, the empty line that ends it, and what follows.
inline std::string with_data(const std::string& header, const std::string& data) {
  return fmt::format("{}\n{}", header, data);
}

/// An NRRD header of shorts on the small lattice, without its place.
inline std::string plain_nrrd(const std::string& more, const std::string& encoding = "raw") {
  return fmt::format("NRRD0005\ntype: short\ndimension: 3\nsizes: {} {} {}\nendian: little\nencoding: {}\n{}", nx, ny,
                     nz, encoding, more);
}

/// The sample of the small volume at the place `other` of an axis that is not space.
inline std::int16_t sample_at(int i, int j, int k, int other) {
  return static_cast<std::int16_t>(sample_at(i, j, k) + 1000.0F * static_cast<float>(other));
}

/// The bytes of an array whose axis `position` (0: the fastest) has `places` places and is not space.
inline std::string bytes_with_axis(int position, int places) {
  std::vector<int> sizes = {nx, ny, nz};
  sizes.insert(sizes.begin() + position, places);
  std::string bytes;
  std::vector<int> at(4, 0);
  for (at[3] = 0; at[3] < sizes[3]; ++at[3]) {
    for (at[2] = 0; at[2] < sizes[2]; ++at[2]) {
      for (at[1] = 0; at[1] < sizes[1]; ++at[1]) {
        for (at[0] = 0; at[0] < sizes[0]; ++at[0]) {
          std::vector<int> node = at;
          node.erase(node.begin() + position);
          bytes += bytes_of_value(sample_at(node[0], node[1], node[2], at[static_cast<std::size_t>(position)]));
        }
      }
    }
  }
  return bytes;
}

/// The samples at one place of that axis.
inline std::vector<float> samples_at(int other) {
  std::vector<float> values = samples();
  for (float& value : values) value += 1000.0F * static_cast<float>(other);
  return values;
}

/// Expects exactly one note for each of `parts`, in their order; each begins with the file's path.
inline void expect_notes(const VolumeFile& file, const std::filesystem::path& path,
                         const std::vector<std::string>& parts) {
  ASSERT_EQ(file.notes.size(), parts.size()) << (file.notes.empty() ? "no note" : file.notes.front());
  for (std::size_t n = 0; n < parts.size(); ++n) {
    EXPECT_NE(file.notes[n].find(parts[n]), std::string::npos) << file.notes[n];
    EXPECT_TRUE(file.notes[n].starts_with(path.string() + ": ")) << file.notes[n];
  }
}

}  // namespace isobench
