// DICOM series, written by GDCM: every node has its sample and its place, whatever the order and the coding of the
// files.
#include "isobench/datasets/formats/dicom/read_dicom.h"

#include <gtest/gtest.h>

#include <array>

#include "isobench/datasets/formats/dicom/test_dicom_writer.h"
#include "isobench/datasets/formats/testing/volume_choices.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

using TS = gdcm::TransferSyntax;

/// Writes the series under names whose order is not that of the slices.
void write_series(const std::filesystem::path& folder, const std::vector<DicomTestFile>& files) {
  const std::array<const char*, 5> names = {"c", "IM9", "a.dcm", "z.IMA", "IM10"};
  for (std::size_t n = 0; n < files.size(); ++n) files[n].write(folder / names[n]);
}

std::vector<DicomTestFile> dicom_series(const std::string& uid = "1.2.3.4") {
  std::vector<DicomTestFile> files;
  for (int k = 0; k < nz; ++k) files.push_back(dicom_slice(k, uid));
  return files;
}

bool has_note(const VolumeFile& file, const std::string& part) {
  return std::any_of(file.notes.begin(), file.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(ReadDicom, AFolderAndOneFileOfItGiveTheSeries) {
  const TestFolder folder;
  write_series(folder.path() / "scan", dicom_series());
  folder.write("scan/README.txt", "not an image");
  folder.write("scan/.DS_Store", std::string(300, '\1'));
  const VolumeFile whole = read_volume(folder.path() / "scan");
  expect_oblique(whole.volume);
  EXPECT_EQ(whole.volume.lattice.space, "LPS");
  EXPECT_EQ(whole.volume.samples.type(), SampleType::u16);
  EXPECT_TRUE(has_note(whole, "2 files other than DICOM passed over"));
  for (const char* name : {"c", "a.dcm", "z.IMA"}) {
    const VolumeFile from_one = read_volume(folder.path() / "scan" / name);
    expect_oblique(from_one.volume);
    EXPECT_TRUE(has_note(from_one, "the 5 slices of its series"));
  }
}

TEST(ReadDicom, EveryTransferSyntaxGivesTheSameSamples) {
  for (const TS::TSType syntax :
       {TS::ImplicitVRLittleEndian, TS::ExplicitVRLittleEndian, TS::ExplicitVRBigEndian,
        TS::DeflatedExplicitVRLittleEndian, TS::RLELossless, TS::JPEGLosslessProcess14_1, TS::JPEGLSLossless}) {
    SCOPED_TRACE(TS::GetTSString(syntax));
    const TestFolder folder;
    std::vector<DicomTestFile> files = dicom_series();
    for (DicomTestFile& file : files) file.syntax = syntax;
    write_series(folder.path(), files);
    expect_oblique(volume_of(folder.path()));
  }
}

TEST(ReadDicom, SignedAndSmallSamples) {
  for (const TS::TSType syntax : {TS::ExplicitVRLittleEndian, TS::ExplicitVRBigEndian, TS::RLELossless,
                                  TS::JPEGLosslessProcess14_1, TS::JPEGLSLossless}) {
    SCOPED_TRACE(TS::GetTSString(syntax));
    const TestFolder folder;
    std::vector<DicomTestFile> files = dicom_series();
    for (int k = 0; k < nz; ++k) {
      DicomTestFile& file = files[static_cast<std::size_t>(k)];
      file.syntax = syntax;
      file.format = gdcm::PixelFormat(1, 16, 16, 15, 1);
      file.pixels = dicom_pixels<std::int16_t>(k, -100.0);
      file.data.text(0x0028, 0x1052, gdcm::VR::DS, "100");
    }
    write_series(folder.path(), files);
    const Volume volume = volume_of(folder.path());
    EXPECT_EQ(volume.samples.type(), SampleType::i32);  // 32767 + 100 needs it
    expect_oblique(volume);
  }
  for (const TS::TSType syntax : {TS::ExplicitVRLittleEndian, TS::ExplicitVRBigEndian, TS::JPEGLSLossless}) {
    const TestFolder folder;
    std::vector<DicomTestFile> files = dicom_series();
    for (int k = 0; k < nz; ++k) {
      files[static_cast<std::size_t>(k)].syntax = syntax;
      files[static_cast<std::size_t>(k)].format = gdcm::PixelFormat(1, 8, 8, 7, 0);
      files[static_cast<std::size_t>(k)].pixels = dicom_pixels<std::uint8_t>(k);
    }
    write_series(folder.path(), files);
    const Volume volume = volume_of(folder.path());
    EXPECT_EQ(volume.samples.type(), SampleType::u8);
    expect_oblique(volume);
  }
}

/// Larger slices: GDCM's encoder for JPEG 2000 writes beyond its buffer where the header is longer than the samples.
TEST(ReadDicom, Jpeg2000) {
  constexpr int columns = 64;
  constexpr int rows = 48;
  constexpr int slices = 3;
  for (const bool is_signed : {false, true}) {
    for (const bool is_rgb : {false, true}) {
      const TestFolder folder;
      std::vector<float> expected;
      for (int k = slices - 1; k >= 0; --k) {
        DicomTestFile file = dicom_slice(k);
        file.syntax = TS::JPEG2000Lossless;
        file.columns = columns;
        file.rows = rows;
        file.format = is_rgb ? gdcm::PixelFormat(3, 8, 8, 7, 0) : gdcm::PixelFormat(1, 16, 16, 15, is_signed ? 1 : 0);
        file.data.text(0x0028, 0x0004, gdcm::VR::CS, is_rgb ? "RGB" : "MONOCHROME2").number(0x0028, 0x0006, 0);
        file.pixels.clear();
        for (int n = 0; n < columns * rows; ++n) {
          const int value = (n * 37 + n * n % 101 + 1000 * k) % 251 - (is_signed && !is_rgb ? 120 : 0);
          const auto byte = static_cast<char>(value);
          file.pixels +=
              is_rgb ? std::string("\x05") + byte + "\x09" : bytes_of_value(static_cast<std::int16_t>(value));
        }
        file.write(folder.path() / std::to_string(7 - k));
      }
      for (int k = 0; k < slices; ++k) {
        for (int n = 0; n < columns * rows; ++n) {
          expected.push_back(
              static_cast<float>((n * 37 + n * n % 101 + 1000 * k) % 251 - (is_signed && !is_rgb ? 120 : 0)));
        }
      }
      EXPECT_EQ(floats_of(volume_of(folder.path(), is_rgb ? choose_component(1) : VolumeChoice())), expected);
    }
  }
}

TEST(ReadDicom, BitsThatAreNotStoredAreLeftOut) {
  const TestFolder folder;
  std::vector<DicomTestFile> files = dicom_series();
  for (int k = 0; k < nz; ++k) {
    DicomTestFile& file = files[static_cast<std::size_t>(k)];
    file.format = gdcm::PixelFormat(1, 16, 12, 11, 1);
    std::string bytes;
    for (int n = 0; n < nx * ny; ++n) {
      const int value = static_cast<int>(sample_at(n % nx, n / nx, k)) - 128;
      bytes += bytes_of_value(static_cast<std::uint16_t>((static_cast<unsigned>(value) & 0xFFFU) | 0xA000U));
    }
    file.pixels = bytes;
    file.data.text(0x0028, 0x1052, gdcm::VR::DS, "128");
  }
  write_series(folder.path(), files);
  const Volume volume = volume_of(folder.path());
  EXPECT_EQ(volume.samples.type(), SampleType::i16);
  expect_oblique(volume);
}

TEST(ReadDicom, RescalesEachSliceByItsOwnSlope) {
  const TestFolder folder;
  std::vector<DicomTestFile> files = dicom_series();
  for (int k = 0; k < nz; ++k) {
    DicomTestFile& file = files[static_cast<std::size_t>(k)];
    std::string bytes;
    for (int n = 0; n < nx * ny; ++n)
      bytes +=
          bytes_of_value(static_cast<std::uint16_t>(8.0F * sample_at(n % nx, n / nx, k) / (k % 2 == 0 ? 1.0F : 2.0F)));
    file.pixels = bytes;
    file.data.text(0x0028, 0x1053, gdcm::VR::DS, k % 2 == 0 ? "0.125" : "0.25");
    file.data.text(0x0028, 0x1052, gdcm::VR::DS, "0");
  }
  write_series(folder.path(), files);
  const Volume volume = volume_of(folder.path());
  EXPECT_EQ(volume.samples.type(), SampleType::f32);
  expect_oblique(volume);
}

TEST(ReadDicom, MissingAndUnevenSlicesAreRefused) {
  const TestFolder folder;
  std::vector<DicomTestFile> files = dicom_series();
  files.erase(files.begin() + 2);
  write_series(folder.path() / "gap", files);
  expect_data_error(folder.path() / "gap", "1 slice is missing between IM9 at");
  files = dicom_series();
  files[3].data.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(world_of(0, 0, 3) + 0.2 * oblique().col(2)));
  write_series(folder.path() / "uneven", files);
  expect_data_error(folder.path() / "uneven", "not equally far apart: 3.2 mm between a.dcm at");
  files = dicom_series();
  files[3].data.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(world_of(0, 0, 3) + 0.2 * oblique().col(1)));
  write_series(folder.path() / "shifted", files);
  expect_data_error(folder.path() / "shifted", "z.IMA is 0.2 mm from where an equal shift");
  // A third of a per cent is within what writers round.
  files[3].data.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(world_of(0, 0, 3) + 0.01 * oblique().col(2)));
  write_series(folder.path() / "rounded", files);
  EXPECT_TRUE(has_note(read_volume(folder.path() / "rounded"), "differ by up to 0.01 mm"));
}

TEST(ReadDicom, ATiltedGantryGivesAShearedLattice) {
  const TestFolder folder;
  std::vector<DicomTestFile> files = dicom_series();
  const Eigen::Vector3d step = spacing[2] * oblique().col(2) + 0.8 * oblique().col(1);
  for (int k = 0; k < nz; ++k) {
    files[static_cast<std::size_t>(k)].data.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(origin + k * step));
  }
  write_series(folder.path(), files);
  const VolumeFile file = read_volume(folder.path());
  EXPECT_TRUE(has_note(file, "14.9° (a tilted gantry)"));
  const Lattice& lattice = file.volume.lattice;
  EXPECT_EQ(floats_of(file.volume), samples());
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Eigen::Vector3d world = lattice.to_world(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)));
        const Eigen::Vector3d expected = world_of(i, j, 0) + k * step;
        EXPECT_LT((world - expected).norm(), 1e-5);
      }
    }
  }
}

TEST(ReadDicom, OneOfSeveralSeriesIsChosen) {
  const TestFolder folder;
  write_series(folder.path() / "1", dicom_series());
  std::vector<DicomTestFile> others = dicom_series("1.2.3.9");
  for (DicomTestFile& file : others) {
    file.data.text(0x0020, 0x0011, gdcm::VR::IS, "12").text(0x0008, 0x103E, gdcm::VR::LO, "Bone");
    file.data.text(0x0028, 0x1052, gdcm::VR::DS, "1000");
  }
  write_series(folder.path() / "2", others);
  const auto& path = folder.path();
  expect_data_error(path, "2 series of images can be meant");
  expect_data_error(path, "#1 number 7 'Thorax thin' UID 1.2.3.4 (5 slices of 7 × 6), #2 number 12 'Bone'");
  expect_data_error(path, "there is no series '3'", choose_series_named("3"));
  for (const char* choice : {"7", "#1", "1.2.3.4", "thorax"})
    expect_oblique(volume_of(path, choose_series_named(choice)));
  for (const char* choice : {"12", "#2", "1.2.3.9", "Bone"})
    EXPECT_EQ(floats_of(volume_of(path, choose_series_named(choice))).front(), samples().front() + 1000.0F);
}

TEST(ReadDicom, ALocalizerInTheSeriesIsASeriesOfItsOwn) {
  const TestFolder folder;
  write_series(folder.path(), dicom_series());
  DicomTestFile localizer = dicom_slice(9);
  localizer.data.text(0x0008, 0x0008, gdcm::VR::CS, "ORIGINAL\\PRIMARY\\LOCALIZER");
  localizer.data.text(0x0020, 0x0037, gdcm::VR::DS, "1\\0\\0\\0\\0\\-1");
  localizer.write(folder.path() / "scout");
  expect_data_error(folder.path(), "(1 slice of 7 × 6)");
  expect_oblique(volume_of(folder.path(), choose_series_named("#1")));
  expect_oblique(volume_of(folder.path() / "a.dcm"));
}

TEST(ReadDicom, CopiesAreDroppedAndPhasesAreSteps) {
  const TestFolder folder;
  write_series(folder.path() / "copies", dicom_series());
  dicom_slice(1).write(folder.path() / "copies/again");
  DicomTestFile renamed = dicom_slice(2);
  renamed.data.text(0x0008, 0x0018, gdcm::VR::UI, "1.2.3.4.77");
  renamed.write(folder.path() / "copies/renamed");
  const VolumeFile copies = read_volume(folder.path() / "copies");
  expect_oblique(copies.volume);
  EXPECT_TRUE(has_note(copies, "2 copies of slices were left out"));

  for (int phase = 0; phase < 3; ++phase) {
    std::vector<DicomTestFile> files = dicom_series();
    for (int k = 0; k < nz; ++k) {
      DicomTestFile& file = files[static_cast<std::size_t>(k)];
      file.pixels = dicom_pixels(k, 1000.0 * phase);
      file.data.text(0x0008, 0x0018, gdcm::VR::UI, fmt::format("1.2.3.4.{}.{}", phase, k));
      file.data.text(0x0020, 0x0100, gdcm::VR::IS, std::to_string(10 + phase));
    }
    write_series(folder.path() / "phases" / std::to_string(9 - phase), files);
  }
  const auto phases = folder.path() / "phases";
  expect_data_error(phases, "3 steps; choose one with --step 0 to 2");
  expect_data_error(phases, "there is no step 3", choose_step(3));
  for (std::size_t phase = 0; phase < 3; ++phase) {
    const VolumeFile file = read_volume(phases, choose_step(phase));
    std::vector<float> expected = samples();
    for (float& value : expected) value += 1000.0F * static_cast<float>(phase);
    EXPECT_EQ(floats_of(file.volume), expected);
    EXPECT_TRUE(has_note(file, "in the order of TemporalPositionIdentifier"));
  }
  std::filesystem::remove(phases / "8" / "IM9");
  expect_data_error(phases, "3 slices lie at", choose_step(0));
}

/// All slices in one file, in reverse.
DicomTestFile frames_in_reverse() {
  DicomTestFile file = dicom_slice(0);
  file.frames = nz;
  file.pixels.clear();
  for (int k = nz - 1; k >= 0; --k) file.pixels += dicom_pixels(k);
  return file;
}

TEST(ReadDicom, FramesOfOneFileWithTheirOwnPlaces) {
  const TestFolder folder;
  std::vector<DicomTestItem> groups;
  for (int k = nz - 1; k >= 0; --k) {
    DicomTestItem position;
    position.text(0x0020, 0x0032, gdcm::VR::DS, dicom_text(world_of(0, 0, k)));
    DicomTestItem rescale;
    rescale.text(0x0028, 0x1053, gdcm::VR::DS, "1").text(0x0028, 0x1052, gdcm::VR::DS, std::to_string(k));
    DicomTestItem group;
    groups.push_back(group.sequence(0x0020, 0x9113, {position}).sequence(0x0028, 0x9145, {rescale}));
  }
  DicomTestItem orientation;
  orientation.text(0x0020, 0x0037, gdcm::VR::DS, dicom_text(oblique().col(0)) + "\\" + dicom_text(oblique().col(1)));
  DicomTestItem measures;
  measures.text(0x0028, 0x0030, gdcm::VR::DS, fmt::format("{}\\{}", spacing[1], spacing[0]));
  DicomTestItem shared;
  shared.sequence(0x0020, 0x9116, {orientation}).sequence(0x0028, 0x9110, {measures});
  for (const TS::TSType syntax : {TS::ExplicitVRLittleEndian, TS::ImplicitVRLittleEndian, TS::ExplicitVRBigEndian,
                                  TS::DeflatedExplicitVRLittleEndian, TS::RLELossless}) {
    SCOPED_TRACE(TS::GetTSString(syntax));
    DicomTestFile file = frames_in_reverse();
    file.syntax = syntax;
    file.data.without(0x0020, 0x0032).without(0x0020, 0x0037).without(0x0028, 0x0030);
    file.data.sequence(0x5200, 0x9229, {shared}).sequence(0x5200, 0x9230, groups);
    Volume volume = volume_of(file.write(folder.path() / "enhanced.dcm"));
    volume.samples.visit([](auto& values) {
      for (std::size_t n = 0; n < values.size(); ++n) {
        using T = SampleOf<decltype(values)>;
        const std::size_t k = n / (nx * ny);
        values[n] = static_cast<T>(values[n] - static_cast<T>(k));
      }
    });
    expect_oblique(volume);
  }
}

TEST(ReadDicom, FramesOfOneFileByTheirDistance) {
  const TestFolder folder;
  DicomTestFile file = frames_in_reverse();
  file.pixels.clear();
  for (int k = 0; k < nz; ++k) file.pixels += dicom_pixels(k);
  expect_data_error(file.write(folder.path() / "without.dcm"), "no distance between them");
  std::filesystem::remove(folder.path() / "without.dcm");
  file.data.text(0x0018, 0x0088, gdcm::VR::DS, "3");
  expect_oblique(volume_of(file.write(folder.path() / "frames.dcm")));
  file.data.without(0x0018, 0x0088).text(0x3004, 0x000C, gdcm::VR::DS, "0\\3\\6\\9\\12");
  file.data.text(0x3004, 0x000E, gdcm::VR::DS, "0.5");
  const Volume dose = volume_of(file.write(folder.path() / "frames.dcm"));
  EXPECT_EQ(floats_of(dose)[10], 0.5F * samples()[10]);
  EXPECT_NEAR(dose.lattice.spacing[2], 3.0, 1e-6);
}

TEST(ReadDicom, ColoursAreChosenByComponent) {
  for (const TS::TSType syntax : {TS::ExplicitVRLittleEndian, TS::RLELossless}) {
    for (const bool is_planar : {false, true}) {
      if (is_planar && syntax != TS::ExplicitVRLittleEndian) continue;
      SCOPED_TRACE(TS::GetTSString(syntax));
      const TestFolder folder;
      std::vector<DicomTestFile> files = dicom_series();
      for (int k = 0; k < nz; ++k) {
        DicomTestFile& file = files[static_cast<std::size_t>(k)];
        file.syntax = syntax;
        file.format = gdcm::PixelFormat(3, 8, 8, 7, 0);
        file.data.text(0x0028, 0x0004, gdcm::VR::CS, "RGB").number(0x0028, 0x0006, is_planar ? 1 : 0);
        const std::string green = dicom_pixels<std::uint8_t>(k);
        std::string interleaved;
        for (const char value : green) interleaved += std::string("\x01") + value + "\x02";
        file.pixels =
            is_planar ? std::string(green.size(), '\1') + green + std::string(green.size(), '\2') : interleaved;
      }
      write_series(folder.path(), files);
      expect_data_error(folder.path(), "choose one with --component 0 to 2");
      expect_oblique(volume_of(folder.path(), choose_component(1)));
      EXPECT_EQ(floats_of(volume_of(folder.path(), choose_component(2))), std::vector<float>(nx * ny * nz, 2.0F));
    }
  }
}

TEST(ReadDicom, SaysWhatItTookWhereTheHeaderLacksIt) {
  const TestFolder folder;
  const auto read_changed = [&](auto&& change) {
    std::vector<DicomTestFile> files = dicom_series();
    for (int k = 0; k < nz; ++k) change(files[static_cast<std::size_t>(k)].data, k);
    write_series(folder.path(), files);
    return read_volume(folder.path());
  };
  const VolumeFile imager = read_changed([](DicomTestItem& data, int) {
    data.without(0x0028, 0x0030).text(0x0018, 0x1164, gdcm::VR::DS, fmt::format("{}\\{}", spacing[1], spacing[0]));
  });
  EXPECT_TRUE(has_note(imager, "ImagerPixelSpacing"));
  expect_oblique(imager.volume);
  const VolumeFile located = read_changed([](DicomTestItem& data, int k) {
    data.without(0x0020, 0x0032).text(0x0020, 0x1041, gdcm::VR::DS, std::to_string(5 + 2 * k));
  });
  EXPECT_TRUE(has_note(located, "SliceLocation"));
  EXPECT_NEAR(located.volume.lattice.spacing[2], 2.0, 1e-9);
  EXPECT_EQ(floats_of(located.volume), samples());
  const VolumeFile inverse = read_changed([](DicomTestItem& data, int) {
    data.text(0x0028, 0x0004, gdcm::VR::CS, "MONOCHROME1").number(0x0028, 0x0120, 0);
  });
  EXPECT_TRUE(has_note(inverse, "MONOCHROME1"));
  EXPECT_TRUE(has_note(inverse, "PixelPaddingValue"));
  expect_oblique(inverse.volume);
  EXPECT_THROW(read_changed([](DicomTestItem& data, int) { data.without(0x0028, 0x0030); }), DataError);
  EXPECT_THROW(read_changed([](DicomTestItem& data, int) { data.without(0x0020, 0x0032); }), DataError);
}

TEST(ReadDicom, ADicomdirLeadsToTheFoldersBesideIt) {
  const TestFolder folder;
  write_series(folder.path() / "IMAGES/S1", dicom_series());
  DicomTestFile index = dicom_slice(0);
  index.write(folder.path() / "DICOMDIR");
  expect_oblique(volume_of(folder.path()));
  expect_oblique(volume_of(folder.path() / "DICOMDIR"));
}

}  // namespace
}  // namespace isobench
