// Damaged, incomplete and hostile files: the error is one sentence that names the file, and nothing is printed.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// A complete file of each format and encoding, with its name.
std::vector<std::pair<std::string, std::string>> whole_files() {
  NiftiHeader nifti;
  nifti.put_sform(oblique(), origin);
  const std::string floats = bytes_of_samples<float>(samples());
  const std::string inr = inrimage(inrimage_fields("TYPE=float\nPIXSIZE=32 bits", "decm"), floats);
  return {{"a.nrrd", nrrd_header("float", "raw") + "\n" + floats},
          {"b.nrrd", nrrd_header("float", "gzip") + "\n" + deflated(floats, true)},
          {"c.mha", metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL") + floats},
          {"d.mha", metaimage_header("CompressedData = True\nElementType = MET_FLOAT\nElementDataFile = LOCAL") +
                        deflated(floats, false)},
          {"e.nii", nifti.bytes() + floats},
          {"f.nii.gz", deflated(nifti.bytes() + floats, true)},
          {"g.vti", vti_text(text_of_samples())},
          {"h.inr", inr},
          {"i.inr.gz", deflated(inr, true)},
          {"j.nrrd", nrrd_header("float", "ascii") + "\n" + text_of_samples()}};
}

TEST(ReadVolumeBadInput, TruncatedFilesOfEveryFormat) {
  const TestFolder folder;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (const auto& [name, bytes] : whole_files()) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(read_volume(folder.write(name, bytes)));
    // Without the last bytes (of a compressed file only the end of the checksum), cut in half, and cut in the header.
    const std::size_t tail = name == "g.vti" ? 40 : name == "j.nrrd" ? 4 : 3;
    for (const std::size_t length : {bytes.size() - tail, bytes.size() / 2, bytes.size() / 10, std::size_t{5}}) {
      expect_data_error(folder.write("cut-" + name, bytes.substr(0, length)), "");
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadVolumeBadInput, ForeignEmptyAndMissingFiles) {
  const TestFolder folder;
  testing::internal::CaptureStderr();
  for (const auto& [name, bytes] : whole_files()) {
    SCOPED_TRACE(name);
    expect_data_error(folder.write("empty-" + name, ""), "empty");
    expect_data_error(folder.write("foreign-" + name, std::string(2000, 'x') + "\n"), "");
    expect_data_error(folder.write("jpeg-" + name, "\xff\xd8\xff\xe0" + std::string(5000, '\x07')), "");
    expect_data_error(folder.path() / ("missing-" + name), "no such file");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  expect_data_error(folder.write("volume.xyz", "II"), ".nii.gz");
  std::filesystem::create_directory(folder.path() / "folder.nrrd");
  expect_data_error(folder.path() / "folder.nrrd", "an empty folder");
}

TEST(ReadVolumeBadInput, DamagedCompressedData) {
  const TestFolder folder;
  for (auto& [name, bytes] : whole_files()) {
    if (name != "b.nrrd" && name != "d.mha" && name != "f.nii.gz" && name != "i.inr.gz") continue;
    std::string damaged = bytes;
    damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 0x55);  // in the checksum or near it
    expect_data_error(folder.write(name, damaged), "");
  }
}

TEST(ReadVolumeBadInput, HostileSizesAllocateNothing) {
  const TestFolder folder;
  testing::internal::CaptureStderr();
  std::string nrrd = nrrd_header("float", "raw") + "\n";
  nrrd.replace(nrrd.find("sizes: 7 6 5"), 12, "sizes: 999999 999999 999999");
  expect_data_error(folder.write("a.nrrd", nrrd + "1234"), "");
  std::string meta = metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL");
  meta.replace(meta.find("DimSize = 7 6 5"), 15, "DimSize = 60000 60000 200");
  expect_data_error(folder.write("b.mha", meta + "1234"), "truncated");
  NiftiHeader nifti;
  for (const std::size_t at : {42, 44, 46}) nifti.put<std::int16_t>(at, 32767);
  expect_data_error(folder.write("c.nii", nifti.bytes() + "1234"), "");
  nifti.put<std::int16_t>(44, -3);
  expect_data_error(folder.write("d.nii", nifti.bytes() + "1234"), "");
  std::string vti = vti_text("1 2 3");
  for (std::size_t at = vti.find("2 8 0 5 0 4"); at != std::string::npos; at = vti.find("2 8 0 5 0 4"))
    vti.replace(at, 11, "0 99999 0 99999 0 99999");
  expect_data_error(folder.write("e.vti", vti), "");
  expect_data_error(
      folder.write(
          "f.inr",
          inrimage("XDIM=90000\nYDIM=90000\nZDIM=90000\nVDIM=1\nTYPE=float\nPIXSIZE=32 bits\nCPU=decm\n", "1234")),
      "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadVolumeBadInput, CompressedDataThatGoOnForLong) {
  const TestFolder folder;
  const std::string bomb = deflated(std::string(std::size_t{64} << 20U, '\0'), true);
  ASSERT_LT(bomb.size(), 70000U);
  const std::string long_after = "go on long after";
  expect_data_error(folder.write("a.nrrd", nrrd_header("float", "gzip") + "\n" + bomb), long_after);
  expect_data_error(
      folder.write("b.mha",
                   metaimage_header("CompressedData = True\nElementType = MET_FLOAT\nElementDataFile = LOCAL") + bomb),
      long_after);
  NiftiHeader nifti;
  const std::string zeros(std::size_t{64} << 20U, '\0');
  expect_data_error(folder.write("c.nii.gz", deflated(nifti.bytes() + zeros, true)), long_after);
  expect_data_error(
      folder.write("d.inr.gz", deflated(inrimage(inrimage_fields("TYPE=float\nPIXSIZE=32 bits", "decm"), zeros), true)),
      long_after);
  // A text that is one endless number.
  std::string text = nrrd_header("float", "ascii");
  text.replace(text.find("encoding: ascii"), 15, "encoding: ascii\nbyte skip: 0");
  expect_data_error(folder.write("e.nrrd", text + "\n" + std::string(std::size_t{8} << 20U, '1')), "not a number");
}

TEST(ReadVolumeBadInput, CompressedDataThatPromiseWhatTheyDoNotHold) {
  const TestFolder folder;
  // So many bytes could hold as much when deflated; only reading them shows that they do not.
  const std::string data = deflated(std::string(20000, '\x5a') + std::string(300000, '\0'), true);
  std::string nrrd = nrrd_header("uchar", "gzip") + "\n";
  nrrd.replace(nrrd.find("sizes: 7 6 5"), 12, "sizes: 100 100 100");
  expect_data_error(folder.write("a.nrrd", nrrd + data), "at most 320000 follow");
}

TEST(ReadVolumeBadInput, MessagesAreOneLineWhateverTheFileSays) {
  const TestFolder folder;
  std::string nrrd = nrrd_header("float", "raw") + "\n";
  nrrd.replace(nrrd.find("type: float"), 11, "type: \x1b[31m\xff" + std::string(5000, 'x'));
  expect_data_error(folder.write("a.nrrd", nrrd), "\\x1b[31m\\xff");
}

TEST(ReadVolumeBadInput, NotA3DScalarVolume) {
  const TestFolder folder;
  NiftiHeader series;
  series.put<std::int16_t>(40, 4);
  series.put<std::int16_t>(48, 2);
  const std::string twice = bytes_of_samples<float>(samples()) + bytes_of_samples<float>(samples());
  expect_data_error(folder.write("series.nii", series.bytes() + twice),
                    "it has 2 steps; choose one with --step 0 to 1");
  std::string sheared = nrrd_header("float", "raw");
  const std::size_t at = sheared.find("space directions:");
  sheared.replace(at, sheared.find('\n', at) - at, "space directions: (1,0,0) (0.5,1,0) (1,1,0.01)");
  expect_data_error(folder.write("sheared.nrrd", sheared + "\n" + twice), "nearly in a plane");
}

}  // namespace
}  // namespace isobench
