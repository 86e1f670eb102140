// NIfTI: which samples of a file are taken, of which type they are, and how they are scaled.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "isobench/datasets/formats/testing/nifti_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// The volume's samples with n · 100 added: what step or component n has.
std::string shorts(int n) {
  std::vector<float> values = samples();
  for (float& value : values) value += 100.0F * static_cast<float>(n);
  return bytes_of_samples<std::int16_t>(values);
}

/// A header of shorts whose sizes after the third are these.
NiftiHeader series(const std::vector<std::int16_t>& sizes) {
  NiftiHeader header = nifti_of_type(4, 16);
  header.put_sform(oblique(), origin);
  header.put<std::int16_t>(40, static_cast<std::int16_t>(3 + sizes.size()));
  for (std::size_t n = 0; n < sizes.size(); ++n) header.put<std::int16_t>(48 + 2 * n, sizes[n]);
  return header;
}

void expect_part(const Volume& volume, int n) {
  const std::vector<float> found = floats_of(volume);
  ASSERT_EQ(found.size(), samples().size());
  for (std::size_t at = 0; at < found.size(); ++at)
    ASSERT_EQ(found[at], samples()[at] + 100.0F * static_cast<float>(n)) << at;
}

TEST(NiftiSteps, OneStepIsAVolumeAndSeveralWantAChoice) {
  const TestFolder folder;
  for (const std::vector<std::int16_t>& sizes :
       {std::vector<std::int16_t>{1}, {0}, {1, 1}, {0, 0}, {1, 1, 1, 1}, {1, 0, 1, 0}}) {
    const auto path = folder.write("one.nii", series(sizes).bytes() + shorts(0));
    expect_oblique(volume_without_note(path));
    expect_oblique(volume_without_note(path, chosen(0, 0)));
    expect_data_error(path, "there is no step 1; it has 1 step", chosen(1));
  }
  const std::string data = shorts(0) + shorts(1) + shorts(2);
  for (const bool compressed : {false, true}) {
    const std::string bytes = series({3}).bytes() + data;
    const auto path = folder.write("three.nii", compressed ? deflated(bytes, true) : bytes);
    expect_data_error(path, "it has 3 steps; choose one with --step 0 to 2");
    expect_data_error(path, "there is no step 3", chosen(3));
    for (const int step : {0, 1, 2})
      expect_part(volume_without_note(path, chosen(static_cast<std::size_t>(step))), step);
  }
  // Every step must be there, also if only the first is wanted.
  expect_data_error(folder.write("cut.nii", series({3}).bytes() + shorts(0) + shorts(1)), "truncated", chosen(0));
  expect_data_error(folder.write("bad.nii", series({-2}).bytes() + data), "-2 steps and 1 components cannot be");
}

TEST(NiftiComponents, VectorsWantAChoice) {
  const TestFolder folder;
  const std::string data = shorts(0) + shorts(1) + shorts(2) + shorts(3) + shorts(4) + shorts(5);
  const auto vectors = folder.write("vectors.nii", series({1, 6}).bytes() + data);
  expect_data_error(vectors, "it has 6 components; choose one with --component 0 to 5");
  expect_part(volume_without_note(vectors, chosen({}, 4)), 4);
  // Two steps of vectors of three: the steps are together.
  const auto both = folder.write("both.nii", series({2, 3}).bytes() + data);
  expect_data_error(both, "it has 3 components", chosen(1));
  expect_part(volume_without_note(both, chosen(1, 2)), 5);
  // A matrix of 2 × 3.
  expect_part(volume_without_note(folder.write("m.nii", series({1, 2, 3}).bytes() + data), chosen({}, 3)), 3);
  // Vectors that a program has put where steps belong, and says so.
  NiftiHeader intent = series({6});
  intent.put<std::int16_t>(68, 1007);
  const auto named = folder.write("intent.nii", intent.bytes() + data);
  expect_data_error(named, "it has 6 components");
  expect_part(volume_without_note(named, chosen({}, 1)), 1);
}

TEST(NiftiComponents, ValuesOfASinglePlaceAreNoVolume) {
  const TestFolder folder;
  NiftiHeader header = series({1, 7, 30});
  for (const std::size_t at : {42U, 44U, 46U}) header.put<std::int16_t>(at, 1);
  expect_data_error(folder.write("a.dscalar.nii", header.bytes() + shorts(0)), "as CIFTI files do", chosen(0, 0));
}

TEST(NiftiColours, APartOfThemIsChosen) {
  const TestFolder folder;
  for (const std::size_t parts : {3U, 4U}) {
    NiftiHeader header =
        nifti_of_type(static_cast<std::int16_t>(parts == 3 ? 128 : 2304), static_cast<std::int16_t>(8 * parts));
    header.put_sform(oblique(), origin);
    header.put<float>(112, 3.0F);  // colours are not scaled
    std::string data;
    for (const float sample : samples()) {
      for (std::size_t part = 0; part < parts; ++part)
        data += static_cast<char>(static_cast<unsigned char>(part == 1 ? sample : 255.0F - sample));
    }
    const auto path = folder.write("colours.nii", header.bytes() + data);
    expect_data_error(path, "its samples are colours; choose a part of them with --component: 0 red");
    expect_oblique(volume_without_note(path, chosen({}, 1)));
    EXPECT_EQ(volume_without_note(path, chosen({}, 0)).samples.as<std::uint8_t>()[0], 255);
    expect_data_error(path, "there is no component", chosen({}, parts));
    header.put<std::int16_t>(40, 5);
    header.put<std::int16_t>(50, 2);
    expect_data_error(folder.write("vectors.nii", header.bytes() + data), "vectors of colours", chosen({}, 0));
  }
}

TEST(NiftiTypes, WhatCannotBeReadIsNamed) {
  const TestFolder folder;
  const std::tuple<std::int16_t, std::int16_t, const char*> types[] = {
      {32, 64, "its samples are complex numbers"},
      {1792, 128, "its samples are complex numbers"},
      {2048, 256, "its samples are complex numbers"},
      {1536, 128, "its samples are floating-point numbers of 128 bits"},
      {1, 1, "its samples are single bits"},
      {0, 8, "its samples are of datatype 0"},
      {4711, 8, "its samples are of datatype 4711"},
      {16, 16, "its samples have 16 bits, which does not fit its datatype 16"},
      {4, 8, "its samples have 8 bits"},
      {4, -16, "its samples have -16 bits"}};
  const std::string data(std::size_t{32} * nx * ny * nz, '\0');
  for (const auto& [code, bits, message] : types)
    expect_data_error(folder.write("a.nii", nifti_of_type(code, bits).bytes() + data), message);
  const Volume volume = volume_with_note(folder.write("b.nii", nifti_of_type(4, 0).bytes() + shorts(0)),
                                         "samples of 0 bits; those of its datatype 4");
  EXPECT_EQ(volume.samples.type(), SampleType::i16);
}

/// What becomes of a volume of u16 that has the samples 7, 0 and 40000.
Samples scaled(float slope, float intercept, SampleType type = SampleType::u16) {
  static const TestFolder folder;
  NiftiHeader header = nifti_of_type(512, 16);
  if (type == SampleType::i32) header = nifti_of_type(8, 32);
  header.put<float>(112, slope);
  header.put<float>(116, intercept);
  std::string data;
  for (int n = 0; n < nx * ny * nz; ++n) {
    const int value = n == 1 ? 0 : n == 2 ? 40000 : 7;
    data += type == SampleType::i32 ? bytes_of_value(value) : bytes_of_value(static_cast<std::uint16_t>(value));
  }
  return volume_of(folder.write("a.nii", header.bytes() + data)).samples;
}

TEST(NiftiScale, LabelsStayIntegers) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  struct Case {
    float slope, intercept;
    SampleType type;  // of the result
    double first, second, third;
  };
  const Case cases[] = {
      {0.0F, 5.0F, SampleType::u16, 7, 0, 40000},
      {nan, 5.0F, SampleType::u16, 7, 0, 40000},
      {infinity, 5.0F, SampleType::u16, 7, 0, 40000},
      {1.0F, 0.0F, SampleType::u16, 7, 0, 40000},
      {1.0F, nan, SampleType::u16, 7, 0, 40000},
      {1.0F, 100.0F, SampleType::u16, 107, 100, 40100},
      {1.0F, -1024.0F, SampleType::i32, -1017, -1024, 38976},
      {1.0F, -30000.0F, SampleType::i16, -29993, -30000, 10000},
      {2.0F, 0.0F, SampleType::i32, 14, 0, 80000},
      {-1.0F, 0.0F, SampleType::i32, -7, 0, -40000},
      {1e6F, 0.0F, SampleType::i64, 7e6, 0, 4e10},
      {0.5F, 0.25F, SampleType::f32, 3.75, 0.25, 20000.25},
      {0.5F, 1e9F, SampleType::f64, 1000000003.5, 1e9, 1000020000.0},
      {1e37F, 0.5F, SampleType::f64, 7.0 * static_cast<double>(1e37F), 0.5, 4e4 * static_cast<double>(1e37F)}};
  for (const Case& one : cases) {
    SCOPED_TRACE(fmt::format("{} {}", one.slope, one.intercept));
    const Samples found = scaled(one.slope, one.intercept);
    EXPECT_EQ(to_string(found.type()), to_string(one.type));
    found.visit([&](const auto& values) {
      EXPECT_EQ(static_cast<double>(values[0]), one.first);
      EXPECT_EQ(static_cast<double>(values[1]), one.second);
      EXPECT_EQ(static_cast<double>(values[2]), one.third);
    });
  }
  EXPECT_EQ(scaled(1.0F, -1024.0F, SampleType::i32).type(), SampleType::i32);
  EXPECT_EQ(scaled(0.5F, 0.0F, SampleType::i32).type(), SampleType::f64);
}

TEST(NiftiScale, AnInterceptThatIsNoNumberIsLeftOut) {
  const TestFolder folder;
  NiftiHeader header = nifti_of_type(4, 16);
  header.put<float>(112, 2.0F);
  header.put<float>(116, std::numeric_limits<float>::quiet_NaN());
  const Volume volume = volume_with_note(folder.write("a.nii", header.bytes() + shorts(0)), "intercept");
  EXPECT_EQ(floats_of(volume)[1], 2.0F * samples()[1]);
}

TEST(NiftiScale, LargeLabelsAreNotRounded) {
  const TestFolder folder;
  NiftiHeader header = nifti_of_type(8, 32);
  header.put<float>(112, 1.0F);
  std::string data;
  for (int n = 0; n < nx * ny * nz; ++n) data += bytes_of_value(n % 2 == 0 ? 312782546 : 312782574);
  const auto labels = [&] {
    return volume_of(folder.write("a.nii", header.bytes() + data)).samples.as<std::int32_t>();
  };
  EXPECT_EQ(labels()[0], 312782546);
  header.put<float>(116, 1.0F);
  EXPECT_EQ(labels()[1], 312782575);
}

}  // namespace
}  // namespace isobench
