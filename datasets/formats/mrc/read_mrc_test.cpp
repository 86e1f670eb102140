// MRC and CCP4 maps: their samples. Where they lie is in mrc_placement_test.cpp.
#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMRCReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

#include "isobench/datasets/formats/testing/mrc_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

std::string mrc_floats(bool swapped = false) { return bytes_of_samples<float>(samples(), swapped); }

/// The notes but for the one on the unit, which every file has, as one text.
std::string other_notes(const VolumeFile& file) {
  std::string text;
  for (const std::string& note : file.notes) {
    if (note.find("1 Å is 1e-7 mm") == std::string::npos) text += note + "\n";
  }
  return text;
}

TEST(ReadMrc, EveryModeInBothByteOrdersPlainOrCompressed) {
  const TestFolder folder;
  // Half floats of whole numbers up to 255: 16 bits with 5 for the exponent.
  std::vector<float> halves;
  for (const float sample : samples()) {
    int exponent = 0;
    const float mantissa = std::frexp(sample, &exponent);
    halves.push_back(sample == 0.0F ? 0.0F
                                    : static_cast<float>((exponent + 14) * 1024) + (mantissa * 2.0F - 1.0F) * 1024.0F);
  }
  for (const bool swapped : {false, true}) {
    const std::tuple<int, std::string, SampleType> modes[] = {
        {0, bytes_of_samples<std::int8_t>(std::vector<float>(samples().size(), -3.0F)), SampleType::i8},
        {1, bytes_of_samples<std::int16_t>(samples(), swapped), SampleType::i16},
        {2, mrc_floats(swapped), SampleType::f32},
        {6, bytes_of_samples<std::uint16_t>(samples(), swapped), SampleType::u16},
        {12, bytes_of_samples<std::uint16_t>(halves, swapped), SampleType::f32}};
    for (const auto& [mode, data, type] : modes) {
      const std::string bytes = MrcFileHeader(mode, swapped).bytes() + data;
      for (const char* name : {"a.mrc", "a.map", "a.ccp4", "a.rec", "a.st", "a.mrc.gz", "a.map.gz", "a.ccp4.gz"}) {
        const bool compressed = std::string(name).ends_with(".gz");
        const Volume volume = volume_with_note(folder.write(name, compressed ? deflated(bytes, true) : bytes),
                                               "its voxels measure 0.5 × 1.25 × 3 Å");
        EXPECT_EQ(volume.samples.type(), type) << mode;
        EXPECT_EQ(volume.lattice.size, (std::array<int, 3>{nx, ny, nz}));
        EXPECT_EQ(floats_of(volume), mode == 0 ? std::vector<float>(samples().size(), -3.0F) : samples()) << mode;
      }
    }
  }
}

TEST(ReadMrc, SamplesAreAsVtkReadsThem) {
  const TestFolder folder;
  const auto path = folder.write("a.mrc", MrcFileHeader().put(92, 80).bytes() + std::string(80, 'x') + mrc_floats());
  vtkNew<vtkMRCReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const Volume volume = volume_of(path);
  vtkDataArray* array = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(volume.samples.size()));
  for (std::size_t n = 0; n < volume.samples.size(); ++n)
    EXPECT_EQ(volume.samples.as<float>()[n], array->GetComponent(static_cast<vtkIdType>(n), 0));
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(1e7 * volume.lattice.spacing[axis], reader->GetOutput()->GetSpacing()[axis], 1e-6);
}

TEST(ReadMrc, HalfFloatsOfEveryKind) {
  const TestFolder folder;
  const std::pair<std::uint16_t, float> halves[] = {{0x0001, 0x1p-24F}, {0x03ff, 1023 * 0x1p-24F},
                                                    {0x3c00, 1.0F},     {0xc000, -2.0F},
                                                    {0x7bff, 65504.0F}, {0x3555, 0.333251953125F}};
  std::string data(std::size_t{2} * nx * ny * nz, '\0');
  for (std::size_t n = 0; n < std::size(halves); ++n) data.replace(2 * n, 2, bytes_of_value(halves[n].first));
  const Volume volume = volume_of(folder.write("a.mrc", MrcFileHeader(12).bytes() + data));
  for (std::size_t n = 0; n < std::size(halves); ++n) EXPECT_EQ(volume.samples.as<float>()[n], halves[n].second);
}

TEST(ReadMrc, BytesAreSignedUnlessTheFileSaysOtherwise) {
  const TestFolder folder;
  struct Case {
    MrcFileHeader header;
    SampleType type;
    const char* note;
  };
  const float most = 200.0F;
  const Case cases[] = {
      {MrcFileHeader(0), SampleType::i8, ""},
      {MrcFileHeader(0).make_old(), SampleType::i8, "are taken as signed"},
      {MrcFileHeader(0).make_old().put(76, -128.0F).put(80, 127.0F), SampleType::i8, ""},
      {MrcFileHeader(0).make_old().put(80, most), SampleType::u8, "because its header states that they go up to 200"},
      {MrcFileHeader(0).put(80, most), SampleType::u8, "unsigned bytes"},
      {MrcFileHeader(0).mark_as_imod(0), SampleType::u8, "the mark of IMOD"},
      {MrcFileHeader(0).make_old().mark_as_imod(1).put(80, most), SampleType::i8, ""}};
  const std::string data(std::size_t{nx} * ny * nz, '\x90');
  for (const Case& one : cases) {
    const VolumeFile file = read_volume(folder.write("a.mrc", one.header.bytes() + data));
    EXPECT_EQ(to_string(file.volume.samples.type()), to_string(one.type)) << one.note;
    EXPECT_EQ(floats_of(file.volume)[0], one.type == SampleType::u8 ? 144.0F : -112.0F);
    const std::string notes = other_notes(file);
    EXPECT_NE(notes.find(one.note), std::string::npos) << notes;
    EXPECT_EQ(notes.empty(), std::string(one.note).empty()) << notes;
  }
  expect_data_error(folder.write("a.mrc", MrcFileHeader(0).mark_as_imod(16).bytes() + data), "of 4 bits");
}

TEST(ReadMrc, TheByteOrderThatMakesSenseIsTaken) {
  const TestFolder folder;
  for (const bool swapped : {false, true}) {
    // Without a stamp, as old programs leave it.
    VolumeFile file =
        read_volume(folder.write("a.mrc", MrcFileHeader(2, swapped).make_old().bytes() + mrc_floats(swapped)));
    EXPECT_EQ(floats_of(file.volume), samples());
    EXPECT_EQ(other_notes(file), "");
    std::string wrong = MrcFileHeader(2, swapped).bytes();
    wrong.replace(212, 2, swapped ? "\x44\x44" : "\x11\x11");
    file = read_volume(folder.write("b.mrc", wrong + mrc_floats(swapped)));
    EXPECT_EQ(floats_of(file.volume), samples());
    EXPECT_NE(other_notes(file).find("states the wrong byte order"), std::string::npos);
  }
}

TEST(ReadMrc, AnExtendedHeaderIsSkipped) {
  const TestFolder folder;
  const std::string header = MrcFileHeader().put(92, 160).bytes();
  EXPECT_EQ(floats_of(volume_of(folder.write("a.map", header + std::string(160, 'x') + mrc_floats()))), samples());
  expect_data_error(folder.write("b.map", header + mrc_floats()), "truncated");
  expect_data_error(folder.write("c.map", MrcFileHeader().put(92, -4).bytes() + mrc_floats()),
                    "an extension of -4 bytes");
  expect_data_error(folder.write("d.map", MrcFileHeader().put(92, 2147483647).bytes() + mrc_floats()), "truncated");
}

TEST(ReadMrc, StacksOfVolumesAndOfImages) {
  const TestFolder folder;
  const std::string data = bytes_of_samples<float>(std::vector<float>(samples().size(), 1.0F)) + mrc_floats();
  const auto stack = [&](int group, int sections, int each) {
    return folder.write("a.mrc", MrcFileHeader().put(88, group).put(8, sections).put(36, each).bytes() + data);
  };
  expect_data_error(stack(401, 2 * nz, nz), "it has 2 steps; choose one with --step 0 to 1");
  const Volume second = volume_of(stack(401, 2 * nz, nz), chosen(1));
  EXPECT_EQ(floats_of(second), samples());
  EXPECT_EQ(second.lattice.size[2], nz);
  expect_data_error(stack(401, 2 * nz, 3), "volumes of 3 sections each, but 10 sections in all");
  EXPECT_EQ(volume_of(stack(1, 2 * nz, nz)).lattice.size[2], 2 * nz);
  EXPECT_NE(other_notes(read_volume(stack(0, 2 * nz, 1))).find("a stack of images"), std::string::npos);
  EXPECT_EQ(other_notes(read_volume(stack(0, 2 * nz, 2 * nz))), "");
}

TEST(ReadMrc, DamagedForeignAndHostileFiles) {
  const TestFolder folder;
  const std::string whole = MrcFileHeader().bytes() + mrc_floats();
  for (const std::string& bytes : {whole, deflated(whole, true)}) {
    for (const std::size_t length : {bytes.size() - 1, bytes.size() / 2, std::size_t{100}, std::size_t{3}})
      expect_data_error(folder.write("cut.mrc", bytes.substr(0, length)), "");
  }
  expect_data_error(folder.write("text.map", std::string(3000, 'x')), "none of an MRC or CCP4 map");
  expect_data_error(folder.write("zero.map", std::string(3000, '\0')), "none of an MRC or CCP4 map");
  const std::pair<int, const char*> modes[] = {{3, "complex numbers"}, {4, "complex numbers"}, {16, "colours"},
                                               {101, "of 4 bits"},     {5, "of mode 5"},       {7, "of mode 7"}};
  for (const auto& [mode, message] : modes)
    expect_data_error(folder.write("mode.mrc", MrcFileHeader(mode).bytes() + mrc_floats() + mrc_floats()), message);
  expect_data_error(folder.write("mode.mrc", MrcFileHeader(-1).bytes() + mrc_floats()), "none of an MRC");
  expect_data_error(folder.write("a.mrc", MrcFileHeader().put(4, 0).bytes() + mrc_floats()), "none of an MRC");
  expect_data_error(folder.write("b.mrc", MrcFileHeader().put(8, -5).bytes() + mrc_floats()), "none of an MRC");
  expect_data_error(folder.write("c.mrc", MrcFileHeader().put_three(0, 9000, 9000, 9000).bytes() + mrc_floats()),
                    "truncated");
  expect_data_error(folder.write("d.mrc", MrcFileHeader().put_three(0, 1 << 30, 1 << 13, 1).bytes() + mrc_floats()),
                    "");
  expect_data_error(folder.write("e.mrc", MrcFileHeader().put(64, 2).bytes() + mrc_floats()), "none of an MRC");
}

}  // namespace
}  // namespace isobench
