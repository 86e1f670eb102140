// How NRRD files hold their samples and spell their headers.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/packed_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/text.h"

namespace isobench {
namespace {

std::string packed(const std::string& encoding, const std::string& bytes) {
  const std::string name = lower_case(encoding);
  if (name.starts_with("g")) return deflated(bytes, true);
  if (name.starts_with("b")) return bzipped(bytes);
  if (name == "hex") return hex_text(bytes);
  return name == "raw" ? bytes : text_of_samples();
}

TEST(Nrrd, EncodingsUnderAllTheirNames) {
  const TestFolder folder;
  for (const std::string encoding :
       {"raw", "RAW", "gzip", "gz", "GZIP", "bzip2", "bz2", "hex", "ascii", "text", "txt", "ASCII"}) {
    SCOPED_TRACE(encoding);
    expect_oblique(volume_of(folder.write("a.nrrd", nrrd_header("short", encoding) + "\n" + packed(encoding, shorts))));
  }
  std::string big = nrrd_header("int", "hex");
  big.replace(big.find("little"), 6, "BIG");
  expect_oblique(
      volume_of(folder.write("big.nrrd", big + "\n" + hex_text(bytes_of_samples<std::int32_t>(samples(), true)))));
  // Streams that follow each other in one file are one stream.
  for (const std::string encoding : {"gzip", "bzip2"}) {
    const std::string parts = packed(encoding, shorts.substr(0, 101)) + packed(encoding, shorts.substr(101));
    expect_oblique(volume_of(folder.write("parts.nrrd", nrrd_header("short", encoding) + "\n" + parts)));
  }
}

TEST(Nrrd, StreamsThatMeetWhereABlockOfTheFileEnds) {
  // The reader takes 1 MiB of the file at a time. The first stream ends 0, 1 or 2 bytes before that, so the mark of the
  // second one is cut. Stored blocks of deflate make streams of any length.
  const TestFolder folder;
  for (const std::size_t before : {0U, 1U, 2U}) {
    SCOPED_TRACE(before);
    std::string noise(std::size_t{1} << 20U, '\0');
    unsigned state = 1;
    for (char& c : noise) c = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
    // Deflate makes noise longer by a few bytes; a byte less of it makes the stream a byte shorter.
    std::size_t length = noise.size() - before;
    std::string stream = deflated(noise.substr(0, length), true);
    for (int n = 0; n < 10 && stream.size() != noise.size() - before; ++n) {
      length -= stream.size() - (noise.size() - before);
      stream = deflated(noise.substr(0, length), true);
    }
    ASSERT_EQ(stream.size(), noise.size() - before);
    const std::string data = stream + deflated("second", true);
    folder.write("data.gz", data);
    const auto path = folder.write(
        "a.nhdr",
        fmt::format("NRRD0004\ntype: uchar\ndimension: 3\nsizes: {} 1 1\nspacings: 1 1 1\nencoding: gzip\ndata "
                    "file: data.gz\n",
                    length + 6));
    EXPECT_EQ(volume_of(path).samples.size(), length + 6);
  }
}

struct Skip {
  const char* encoding;
  const char* fields;
  std::string before;  ///< in the file, as it is on disk
  std::string inside;  ///< before the samples, packed with them
  std::string after;   ///< after the samples, packed with them
};

TEST(Nrrd, SkipsInTheFileAndInThePackedStream) {
  const std::vector<Skip> skips = {
      {"raw", "byte skip: 3\n", "abc", "", ""},
      {"raw", "line skip: 2\n", "one\ntwo\r\n", "", ""},
      {"raw", "line skip: 1\nbyte skip: 4\n", "one\n1\n23", "", ""},
      {"raw", "byte skip: -1\n", "", "some header", ""},
      {"raw", "byte skip: -4\n", "", "some header", "end"},
      {"hex", "line skip: 1\nbyte skip: 3\n", "one\nxyz", "", ""},
      {"ascii", "line skip: 1\nbyte skip: 3\n", "one\nxyz", "", ""},
      {"gzip", "line skip: 2\n", "one\ntwo\n", "", ""},
      {"gzip", "byte skip: 352\n", "", std::string(352, 'h'), ""},
      {"gzip", "byte skip: -1\n", "", std::string(352, 'h'), ""},
      {"gzip", "byte skip: -4\n", "", std::string(352, 'h'), "end"},
      {"gzip", "line skip: 1\nbyte skip: 5\n", "one\n", "12345", ""},
      {"gzip", "line skip: 1\nbyte skip: -1\n", "one\n", "12345", ""},
      {"bzip2", "line skip: 2\n", "one\ntwo\n", "", ""},
      {"bzip2", "byte skip: 7\n", "", "1234567", ""},
      {"bzip2", "byte skip: -1\n", "", "1234567", ""},
  };
  const TestFolder folder;
  for (const Skip& skip : skips) {
    SCOPED_TRACE(std::string(skip.encoding) + " " + skip.fields);
    const std::string header = nrrd_header("short", skip.encoding) + skip.fields;
    const std::string data = skip.before + packed(skip.encoding, skip.inside + shorts + skip.after);
    folder.write("data.bin", data);
    for (const auto& path :
         {folder.write("a.nrrd", with_data(header, data)), folder.write("a.nhdr", header + "data file: data.bin\n")}) {
      const VolumeFile file = read_volume(path);
      expect_oblique(file.volume);
      expect_notes(file, path, {});
    }
  }
}

TEST(Nrrd, ADataFileLongerThanItsSamplesIsRefusedUnlessTheHeaderSaysWhereTheyBegin) {
  const TestFolder folder;
  for (const std::string encoding : {"raw", "gzip", "bzip2", "hex"}) {
    SCOPED_TRACE(encoding);
    const std::string header = nrrd_header("short", encoding);
    folder.write("v.nii.gz", packed(encoding, std::string(352, 'h') + shorts));
    expect_data_error(folder.write("forgot.nhdr", header + "data file: v.nii.gz\n"),
                      "'v.nii.gz' is 352 bytes longer than its samples");
    folder.write("data.bin", packed(encoding, shorts + "!"));
    const auto stated = folder.write("stated.nhdr", header + "byte skip: 0\ndata file: data.bin\n");
    expect_oblique(volume_of(stated));
    expect_notes(read_volume(stated), stated, {"'data.bin' has 1 byte after its samples, which were not used"});
    const auto attached = folder.write("attached.nrrd", with_data(header, packed(encoding, shorts + "more")));
    expect_oblique(volume_of(attached));
    expect_notes(read_volume(attached), attached,
                 {"'attached.nrrd' has 4 bytes after its samples, which were not used"});
  }
}

TEST(Nrrd, NumbersThatFollowTextSamplesAreNoted) {
  const TestFolder folder;
  const auto path = folder.write("a.nrrd", nrrd_header("short", "text") + "\n" + text_of_samples() + " 7\n");
  expect_oblique(volume_of(path));
  expect_notes(read_volume(path), path, {"'a.nrrd' has numbers after its samples"});
}

TEST(Nrrd, HeadersInOtherSpellings) {
  const TestFolder folder;
  const std::string fields =
      "NRRD0001\n# comment: one\nTYPE: signed short int\nDimension: 3\nSIZES: 7 6 5\nEndian: Little\nEncoding: Raw\n"
      "Spacings: 0.5 1.25 3\ncontent: a: b := c\nnumber: 210\nsample units: \"HU\"\nold min: 0\noldmax: 1\nlabels: "
      "\"x\" "
      "\"y\" \"z\"\nkey: with colon:=value: with colon\n";
  const auto expect_read = [&](const std::filesystem::path& path) {
    const VolumeFile file = read_volume(path);
    EXPECT_EQ(floats_of(file.volume), samples());
    EXPECT_LT((file.volume.lattice.spacing - spacing).norm(), 1e-12);
    expect_notes(file, path, {});
  };
  expect_read(folder.write("a.nrrd", fields + "\n" + shorts));
  std::string windows;
  for (const char c : fields + "\n") windows += c == '\n' ? "\r\n" : std::string(1, c);
  expect_read(folder.write("b.nrrd", windows + shorts));
  folder.write("sub/data.raw", "x\n12" + shorts);
  expect_read(folder.write("c.nhdr", fields + "lineskip: 1\nbyteskip: 2\ndatafile: sub/data.raw"));
  expect_read(folder.write("d.nhdr", fields + "line skip: 1\nbyte skip: 2\ndata file: sub\\data.raw\r\n"));
  expect_read(folder.write(
      "e.nhdr", fields + "lineskip:1\nbyteskip:2\ndata file: " + (folder.path() / "sub/data.raw").string() + "\n"));
}

TEST(Nrrd, WhatAHeaderLeavesOutIsNoted) {
  const TestFolder folder;
  std::string header = plain_nrrd("spacings: 0.5 1.25 3\n");
  header.erase(header.find("endian: little\n"), 15);
  const auto order = folder.write("a.nrrd", header + "\n" + shorts);
  EXPECT_EQ(floats_of(volume_of(order)), samples());
  expect_notes(read_volume(order), order, {"does not state the order of bytes"});
  const auto misspelt = folder.write("b.nrrd", plain_nrrd("spacing: 0.5 1.25 3\n\n") + shorts);
  expect_notes(
      read_volume(misspelt), misspelt,
      {"field 'spacing' is not known and was not used; did you mean 'spacings'?", "axis 0", "axis 1", "axis 2"});
}

}  // namespace
}  // namespace isobench
