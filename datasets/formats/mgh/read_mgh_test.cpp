#include <gtest/gtest.h>

#include "isobench/datasets/formats/testing/mgh_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

std::string mgh_floats() { return bytes_of_samples<float>(samples(), true); }

TEST(ReadMgh, KeepsNodesInPlaceInEveryTypePlainOrCompressed) {
  const TestFolder folder;
  const std::tuple<int, std::string, SampleType> types[] = {
      {0, bytes_of_samples<std::uint8_t>(samples()), SampleType::u8},
      {1, bytes_of_samples<std::int32_t>(samples(), true), SampleType::i32},
      {3, mgh_floats(), SampleType::f32},
      {4, bytes_of_samples<std::int16_t>(samples(), true), SampleType::i16},
      {10, bytes_of_samples<std::uint16_t>(samples(), true), SampleType::u16}};
  for (const auto& [code, data, type] : types) {
    // Records about the image may follow the samples.
    const std::string bytes = mgh_header(code) + data + std::string(100, '\x03');
    for (const char* name : {"a.mgh", "a.mgz", "a.mgh.gz"}) {
      for (const bool compressed : {false, true}) {
        const Volume volume = volume_without_note(folder.write(name, compressed ? deflated(bytes, true) : bytes));
        expect_oblique(volume);
        EXPECT_EQ(volume.samples.type(), type);
        EXPECT_EQ(volume.lattice.space, "RAS");
      }
    }
  }
}

TEST(ReadMgh, AnIntentInTheVersionDoesNotMatter) {
  const TestFolder folder;
  std::string header = mgh_header(3);
  put_mgh(header, 0, 0x0201);
  expect_oblique(volume_without_note(folder.write("a.mgh", header + mgh_floats())));
  for (const int version : {0, 2, 0x10001, 0x01000000}) {
    put_mgh(header, 0, version);
    expect_data_error(folder.write("a.mgh", header + mgh_floats()), "not a volume of FreeSurfer");
  }
}

TEST(ReadMgh, WithoutAPlaceItLiesAsFreeSurferPutsIt) {
  const TestFolder folder;
  std::string header = mgh_header(3);
  put_mgh(header, 28, std::int16_t{0});
  const Lattice lattice =
      volume_with_note(folder.write("a.mgh", header + mgh_floats()), "coronal slices of 1 mm").lattice;
  EXPECT_EQ(lattice.spacing, Eigen::Vector3d::Ones());
  // Node (i, j, k) lies at (nx/2 - i, k - nz/2, ny/2 - j).
  EXPECT_EQ(lattice.to_world(Eigen::Vector3d::Zero()), Eigen::Vector3d(3.5, -2.5, 3.0));
  EXPECT_EQ(lattice.to_world(Eigen::Vector3d(1.0, 2.0, 4.0)), Eigen::Vector3d(2.5, 1.5, 1.0));
}

TEST(ReadMgh, FramesAreSteps) {
  const TestFolder folder;
  std::vector<float> other = samples();
  for (float& value : other) value += 1.0F;
  const std::string bytes = mgh_header(3, 2) + bytes_of_samples<float>(other, true) + mgh_floats();
  for (const bool compressed : {false, true}) {
    const auto path = folder.write("a.mgz", compressed ? deflated(bytes, true) : bytes);
    expect_data_error(path, "it has 2 steps; choose one with --step 0 to 1");
    expect_oblique(volume_without_note(path, chosen(1)));
    EXPECT_EQ(floats_of(volume_without_note(path, chosen(0))), other);
    expect_data_error(path, "there is no step 2", chosen(2));
    expect_data_error(path, "leave out --component", chosen({}, 0));
  }
}

TEST(ReadMgh, DamagedAndHostileFiles) {
  const TestFolder folder;
  const std::string whole = mgh_header(3) + mgh_floats();
  for (const std::string& bytes : {whole, deflated(whole, true)}) {
    for (const std::size_t length : {bytes.size() - 1, bytes.size() / 2, std::size_t{100}, std::size_t{3}})
      expect_data_error(folder.write("cut.mgz", bytes.substr(0, length)), "");
  }
  expect_data_error(folder.write("header.mgh", whole.substr(0, 283)), "truncated in its header");
  expect_data_error(folder.write("foreign.mgz", std::string(2000, 'x')), "not a volume of FreeSurfer");
  const std::tuple<std::size_t, int, const char*> changes[] = {{4, 0, "its size"},
                                                               {8, -6, "its size"},
                                                               {12, 2147483647, "truncated"},
                                                               {16, 0, "0 frames"},
                                                               {16, -1, "-1 frames"},
                                                               {20, 6, "samples of type 6 cannot be read"},
                                                               {30, 0, "its spacing"},
                                                               {34, 0x7fc00000, "its spacing"},
                                                               {78, 0x7f800000, "origin"}};
  for (const auto& [at, value, message] : changes) {
    std::string header = mgh_header(3);
    put_mgh(header, at, value);
    expect_data_error(folder.write("a.mgh", header + mgh_floats()), message);
  }
  std::string large = mgh_header(3, 2147483647);
  for (const std::size_t at : {4U, 8U}) put_mgh(large, at, 1 << 20);
  put_mgh(large, 12, 1);
  expect_data_error(folder.write("large.mgh", large + mgh_floats()), "the header is damaged");
  std::string flat = mgh_header(3);
  for (std::size_t n = 0; n < 12; ++n) flat[66 + n] = flat[54 + n];  // two equal directions
  expect_data_error(folder.write("flat.mgh", flat + mgh_floats()), "nearly in a plane");
}

}  // namespace
}  // namespace isobench
