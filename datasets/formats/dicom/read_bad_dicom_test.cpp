// DICOM files that are damaged, or that no volume can be made of: one sentence each.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/dicom/test_dicom_writer.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

using TS = gdcm::TransferSyntax;

std::string bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Expects a volume or a message of one line.
void expect_handled(const std::filesystem::path& path) {
  try {
    read_volume(path);
  } catch (const DataError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
  }
}

TEST(ReadBadDicom, EveryTruncationIsHandled) {
  for (const TS::TSType syntax :
       {TS::ExplicitVRLittleEndian, TS::ImplicitVRLittleEndian, TS::DeflatedExplicitVRLittleEndian, TS::RLELossless}) {
    const TestFolder folder;
    DicomTestFile file = dicom_slice(0);
    file.syntax = syntax;
    const std::string whole = bytes_of_file(file.write(folder.path() / "a.dcm"));
    for (std::size_t size = 1; size < whole.size(); size += 5 + size % 3) {
      expect_handled(folder.write("a.dcm", whole.substr(0, size)));
    }
    expect_data_error(folder.write("a.dcm", whole.substr(0, 300)), "truncated");
  }
}

TEST(ReadBadDicom, EveryChangedByteIsHandled) {
  const TestFolder folder;
  const std::string whole = bytes_of_file(dicom_slice(0).write(folder.path() / "a.dcm"));
  for (std::size_t at = 128; at < whole.size(); at += 5) {
    for (const char value : {'\0', '\xff'}) {
      std::string changed = whole;
      changed[at] = value;
      expect_handled(folder.write("a.dcm", changed));
    }
  }
}

TEST(ReadBadDicom, DamagedCompressedData) {
  for (const TS::TSType syntax : {TS::RLELossless, TS::JPEGLosslessProcess14_1, TS::JPEGLSLossless}) {
    SCOPED_TRACE(TS::GetTSString(syntax));
    const TestFolder folder;
    DicomTestFile file = dicom_slice(0);
    file.syntax = syntax;
    const std::string whole = bytes_of_file(file.write(folder.path() / "a.dcm"));
    const std::size_t pixels = whole.rfind(std::string("\xfe\xff\x00\xe0", 4));
    for (std::size_t at = pixels; at < whole.size(); at += 11) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ '\x55');
      expect_handled(folder.write("a.dcm", changed));
    }
    std::string larger = whole;
    const std::size_t rows = larger.find(std::string("\x28\0\x10\0US\2\0", 8));
    larger.replace(rows + 8, 2, std::string("\0\x40", 2));
    if (syntax != TS::RLELossless) expect_data_error(folder.write("a.dcm", larger), "its header states 7 × 16384");
    if (syntax == TS::RLELossless) expect_data_error(folder.write("a.dcm", larger), "cannot be decoded");
  }
}

TEST(ReadBadDicom, HostileSizesTakeNoMemory) {
  const TestFolder folder;
  DicomTestFile file = dicom_slice(0);
  file.data.number(0x0028, 0x0010, 65535).number(0x0028, 0x0011, 65535);
  expect_data_error(file.write(folder.path() / "a.dcm"), "truncated: its header states 1 frame of 65535 × 65535");
  file = dicom_slice(0);
  file.data.text(0x0028, 0x0008, gdcm::VR::IS, "2147483647");
  expect_data_error(file.write(folder.path() / "a.dcm"), "2147483647 frames are not a DICOM image");
  file.data.text(0x0028, 0x0008, gdcm::VR::IS, "100000");
  expect_data_error(file.write(folder.path() / "a.dcm"), "truncated: its header states 100000 frames");
}

TEST(ReadBadDicom, HostileSizesOfCompressedFramesTakeNoMemory) {
  const TestFolder folder;
  DicomTestFile file = dicom_slice(0);
  file.syntax = TS::RLELossless;
  file.data.number(0x0028, 0x0010, 65535).number(0x0028, 0x0011, 65535);
  expect_data_error(file.write(folder.path() / "a.dcm"), "too few for its 65535 × 65535 samples");
}

TEST(ReadBadDicom, SamplesThatNoVolumeHas) {
  const TestFolder folder;
  const auto expect_refused = [&](const DicomTestFile& file, const std::string& part) {
    expect_data_error(file.write(folder.path() / "a.dcm"), part);
  };
  DicomTestFile file = dicom_slice(0);
  file.data.text(0x0028, 0x0004, gdcm::VR::CS, "PALETTE COLOR");
  expect_refused(file, "table of colours");
  file = dicom_slice(0);
  file.format = gdcm::PixelFormat(3, 8, 8, 7, 0);
  file.pixels = std::string(3 * nx * ny, '\1');
  file.data.text(0x0028, 0x0004, gdcm::VR::CS, "YBR_FULL");
  expect_refused(file, "stored as YBR_FULL");
  file = dicom_slice(0);
  file.data.text(0x0008, 0x0008, gdcm::VR::CS, "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
  expect_refused(file, "mosaics of slices");
  file = dicom_slice(0);
  file.data.text(0x0028, 0x1053, gdcm::VR::DS, "0");
  expect_refused(file, "RescaleSlope is 0");
  file = dicom_slice(0);
  file.data.text(0x0020, 0x0037, gdcm::VR::DS, "1\\0\\0\\1\\0\\0");
  expect_refused(file, "two perpendicular directions");
  file = dicom_slice(0);
  file.data.text(0x0028, 0x0030, gdcm::VR::DS, "0\\1");
  expect_refused(file, "two numbers above 0");
  file = dicom_slice(0);
  file.data.without(0x0028, 0x0030);
  expect_refused(file, "no PixelSpacing; convert");
}

TEST(ReadBadDicom, ACompressionThatIsNotDecodedIsNamed) {
  const TestFolder folder;
  DicomTestFile file = dicom_slice(0);
  file.syntax = TS::JPEGLSLossless;
  std::string bytes = bytes_of_file(file.write(folder.path() / "a.dcm"));
  const std::string uid = "1.2.840.10008.1.2.4.80";
  bytes.replace(bytes.find(uid), uid.size(), "1.2.840.10008.1.2.4.93");
  expect_data_error(folder.write("a.dcm", bytes), "compressed by JPEG 2000 part 2, which cannot be decoded");
}

TEST(ReadBadDicom, FoldersSayWhatTheyHold) {
  const TestFolder folder;
  for (int n = 0; n < 12; ++n) folder.write(fmt::format("pictures/{}.png", n), "x");
  folder.write("pictures/notes.txt", "x");
  expect_data_error(folder.path() / "pictures", "a folder of 12 .png files and 1 other, and stacks of such pictures");
  std::filesystem::create_directory(folder.path() / "empty");
  expect_data_error(folder.path() / "empty", "an empty folder");
  expect_data_error(folder.path() / "pictures/0.png", "stacks of PNG, JPEG or BMP");
  expect_data_error(folder.write("a.dcm", "no DICOM"), "not a DICOM file");
}

}  // namespace
}  // namespace isobench
