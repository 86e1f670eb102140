// What MetaImage files state, in every form that the format has.
#include <gtest/gtest.h>

#include <algorithm>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/packed_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/text.h"

namespace isobench {
namespace {

constexpr std::size_t bytes_a_slice = std::size_t{2} * nx * ny;
const std::string short_type = "ElementType = MET_SHORT\n";

std::filesystem::path mhd(const TestFolder& folder, const std::string& more, const std::string& files) {
  return folder.write("a.mhd", metaimage_header(more + short_type + "ElementDataFile = " + files));
}

/// A header without a matrix.
std::string bare(int dimensions, const std::string& sizes, const std::string& more) {
  return fmt::format("NDims = {}\nDimSize = {}\n{}", dimensions, sizes, more);
}

TEST(MetaImage, KeysInOtherSpellingsAndComments) {
  const TestFolder folder;
  std::string header = metaimage_header(
      "Comment = one = two\nComment=two\n# a comment\n// another\n\nelementtype=met_short\n"
      "CENTEROFROTATION = 1 2 3\nSomeKeyOfMine = 7\nElementDataFile=Local");
  for (const char* key : {"NDims = ", "DimSize = ", "Offset = "}) {
    std::string other = lower_case(key);
    other.erase(std::remove(other.begin(), other.end(), ' '), other.end());
    header.replace(header.find(key), std::string(key).size(), other);
  }
  const auto path = folder.write("a.mha", header + shorts);
  expect_oblique(volume_of(path));
  expect_notes(read_volume(path), path, {});
  std::string windows;
  for (const char c : header) windows += c == '\n' ? "\r\n" : std::string(1, c);
  expect_oblique(volume_of(folder.write("b.mha", windows + shorts)));
}

TEST(MetaImage, NamesOfPlaceAndOrientation) {
  const TestFolder folder;
  for (const char* offset : {"Offset", "Position", "Origin"}) {
    for (const char* matrix : {"TransformMatrix", "Orientation", "Rotation"}) {
      std::string header = metaimage_header(short_type + "ElementDataFile = LOCAL");
      header.replace(header.find("Offset"), 6, offset);
      header.replace(header.find("TransformMatrix"), 15, matrix);
      expect_oblique(volume_of(folder.write("a.mha", header + shorts)));
    }
  }
}

TEST(MetaImage, SpacingSizeAndUnits) {
  const TestFolder folder;
  const std::string end = short_type + "ElementDataFile = LOCAL\n";
  const auto read = [&](const std::string& more, const Eigen::Vector3d& expected,
                        const std::vector<std::string>& notes) {
    SCOPED_TRACE(more);
    const auto path = folder.write("a.mha", bare(3, "7 6 5", more) + end + shorts);
    const VolumeFile file = read_volume(path);
    EXPECT_LT((file.volume.lattice.spacing - expected).norm(), 1e-12);
    expect_notes(file, path, notes);
  };
  read("ElementSpacing = 1 2 3\nElementSize = 4 5 6\n", {1.0, 2.0, 3.0}, {});
  read("ElementSize = 4 5 6\n", {4.0, 5.0, 6.0}, {"its ElementSize was taken"});
  read("", {1.0, 1.0, 1.0}, {"has no ElementSpacing; 1 was taken"});
  read("ElementSpacing = 1 2 3\nDistanceUnits = um\n", {0.001, 0.002, 0.003}, {});
  read("ElementSpacing = 1 2 3\nDistanceUnits = cm\n", {10.0, 20.0, 30.0}, {});
  read("ElementSpacings = 1 2 3\n", {1.0, 1.0, 1.0},
       {"key 'elementspacings' is not known and was not used; did you mean 'ElementSpacing'?", "1 was taken"});
}

TEST(MetaImage, LettersOfTheOrientationAreCheckedOnly) {
  const TestFolder folder;
  const std::string end = "ElementSpacing = 1 1 1\n" + short_type + "ElementDataFile = LOCAL\n";
  const auto notes = [&](const std::string& more) {
    return read_volume(folder.write("a.mha", bare(3, "7 6 5", more) + end + shorts)).notes;
  };
  for (const char* letters : {"RAI", "LPS", "rai", "???", ""})
    EXPECT_TRUE(notes(fmt::format("AnatomicalOrientation = {}\n", letters)).empty()) << letters;
  EXPECT_EQ(notes("AnatomicalOrientation = RAS\n").size(), 1U);
  EXPECT_TRUE(notes("AnatomicalOrientation = ASL\nTransformMatrix = 0 1 0 0 0 -1 -1 0 0\n").empty());
  const auto turned = notes("AnatomicalOrientation = RAI\nTransformMatrix = 0 1 0 0 0 -1 -1 0 0\n");
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NE(turned[0].find("RAI does not fit its TransformMatrix, whose axes come from ASL"), std::string::npos);
}

TEST(MetaImage, TypesUnderAllTheirNames) {
  const TestFolder folder;
  const auto type_of = [&](const std::string& name, std::size_t bytes) {
    return volume_of(folder.write("a.mha", bare(3, "2 1 1", "ElementType = " + name + "\nElementDataFile = LOCAL\n") +
                                               std::string(2 * bytes, '\0')))
        .samples.type();
  };
  EXPECT_EQ(type_of("MET_LONG", 4), SampleType::i32);
  EXPECT_EQ(type_of("MET_ULONG", 4), SampleType::u32);
  EXPECT_EQ(type_of("MET_LONG_LONG", 8), SampleType::i64);
  EXPECT_EQ(type_of("MET_UCHAR_ARRAY", 1), SampleType::u8);
  EXPECT_EQ(type_of("MET_LONG_ARRAY", 4), SampleType::i32);
  EXPECT_EQ(type_of("Met_Double", 8), SampleType::f64);
  for (const char* name : {"MET_STRING", "float", "MET_FLOAT_MATRIX", "MET_OTHER", ""}) {
    expect_data_error(
        folder.write("a.mha",
                     bare(3, "1 1 1", fmt::format("ElementType = {}\nElementDataFile = LOCAL\n", name)) + "1234"),
        "cannot be read");
  }
}

TEST(MetaImage, ChannelsAndSteps) {
  const TestFolder folder;
  const std::string end = "ElementSpacing = 0.5 1.25 3\n" + short_type + "ElementDataFile = LOCAL\n";
  const auto colours =
      folder.write("a.mha", bare(3, "7 6 5", "ElementNumberOfChannels = 3\n" + end) + bytes_with_axis(0, 3));
  const std::string four =
      "ElementSpacing = 0.5 1.25 3 9\nOffset = 1 2 3 4\nTransformMatrix = 0 1 0 0 1 0 0 0 0 0 1 0 0 0 0 1\n";
  const auto series = folder.write(
      "b.mha", bare(4, "7 6 5 3", four + short_type + "ElementDataFile = LOCAL\n") + bytes_with_axis(3, 3));
  for (std::size_t n = 0; n < 3; ++n) {
    VolumeChoice component;
    component.component = n;
    EXPECT_EQ(floats_of(volume_of(colours, component)), samples_at(static_cast<int>(n)));
    VolumeChoice step;
    step.step = n;
    const Volume volume = volume_of(series, step);
    EXPECT_EQ(floats_of(volume), samples_at(static_cast<int>(n)));
    EXPECT_EQ(volume.lattice.origin, Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_EQ(volume.lattice.direction.col(0), Eigen::Vector3d(0.0, 1.0, 0.0));
    EXPECT_EQ(volume.lattice.spacing, spacing);
  }
  expect_data_error(colours, "it has 3 components; choose one with --component 0 to 2");
  expect_data_error(series, "it has 3 steps; choose one with --step 0 to 2");
  VolumeChoice step;
  step.step = 0;
  expect_data_error(colours, "it has no steps but 3 components", step);
  const auto one = folder.write("c.mha", bare(4, "7 6 5 1",
                                              "ElementSpacing = 1 1 1 1\nElementNumberOfChannels = 1\n" + short_type +
                                                  "ElementDataFile = LOCAL\n") +
                                             shorts);
  EXPECT_EQ(floats_of(volume_of(one)), samples());
}

TEST(MetaImage, ImagesOfTwoDimensionsAreOneSlice) {
  const TestFolder folder;
  const auto path = folder.write("a.mha", bare(2, "7 6",
                                               "ElementSpacing = 4 9\nOffset = 1 2\nTransformMatrix = 0 1 -1 0\n" +
                                                   short_type + "ElementDataFile = LOCAL\n") +
                                              shorts.substr(0, bytes_a_slice));
  const VolumeFile file = read_volume(path);
  EXPECT_EQ(file.volume.lattice.size, (std::array<int, 3>{nx, ny, 1}));
  EXPECT_LT((file.volume.lattice.spacing - Eigen::Vector3d(4.0, 9.0, 6.0)).norm(), 1e-12);
  EXPECT_EQ(file.volume.lattice.direction.col(0), Eigen::Vector3d(0.0, 1.0, 0.0));
  EXPECT_EQ(file.volume.lattice.origin, Eigen::Vector3d(1.0, 2.0, 0.0));
  expect_notes(file, path, {"it is one 2-D slice; 6 mm were taken as its thickness"});
}

TEST(MetaImage, DataFilesListsAndPatterns) {
  const TestFolder folder;
  for (int k = 0; k < nz; ++k) {
    const std::string slice = shorts.substr(bytes_a_slice * static_cast<std::size_t>(k), bytes_a_slice);
    folder.write(fmt::format("s{:02d}.raw", k), slice);
    folder.write(fmt::format("t{}.raw", k + 1), slice);
    folder.write(fmt::format("r{}", 20 - 5 * k), slice);
    folder.write(fmt::format("sub/h{}.raw", k), "header" + slice);
    folder.write(fmt::format("z{}.gz", k), deflated(slice, k % 2 == 0));
  }
  expect_oblique(volume_of(mhd(folder, "", "s%02d.raw 0 4 1")));
  expect_oblique(volume_of(mhd(folder, "", "t%d.raw")));  // from 1 to the number of slices
  expect_oblique(volume_of(mhd(folder, "", "t%d.raw 1 5")));
  expect_oblique(volume_of(mhd(folder, "", "r%d 20 0 -5")));
  expect_oblique(volume_of(mhd(folder, "HeaderSize = 6\n", "sub/h%d.raw 0 4 1")));
  expect_oblique(volume_of(mhd(folder, "HeaderSize = -1\n", "sub\\h%d.raw 0 4 1")));
  expect_oblique(volume_of(mhd(folder, "CompressedData = True\n", "z%d.gz 0 4 1")));
  const std::string list = "\ns00.raw\nt2.raw\ns02.raw\ns03.raw\ns04.raw\n";
  for (const char* name : {"LIST", "LIST 2", "LIST 2D", "list"})
    expect_oblique(volume_of(mhd(folder, "", name + list)));
  expect_data_error(mhd(folder, "", "LIST\ns00.raw\n"), "it names 1 data file, but its sizes make 5");
  expect_data_error(mhd(folder, "", "LIST\n"), "list of data files is empty");
  expect_data_error(mhd(folder, "", "LIST 4" + list), "its data files cannot have 4 of its 3 dimensions");
  expect_data_error(mhd(folder, "", "LIST -1" + list), "of its 3 dimensions");
  expect_data_error(mhd(folder, "", "s%02d.raw 0 3 1"), "it names 4 data files");
  expect_data_error(mhd(folder, "", "s%02d.raw 0 1000000000 1"), "it names 1000000001 data files");
  expect_data_error(mhd(folder, "", "t%d.raw 0 4 1"), "its data file 't0.raw', 1 of 5, is missing");
  for (const char* pattern : {"%s", "%n", "%d%d", "%", "%-3d"})
    expect_data_error(mhd(folder, "", std::string(pattern) + " 0 4 1"), "is not understood");
  expect_data_error(mhd(folder, "", "sub/h%d.raw 0 4 1"), "'h0.raw' is 6 bytes longer than its samples");
}

TEST(MetaImage, FilesOfSeriesAndOfChannels) {
  const TestFolder folder;
  const std::string all = bytes_with_axis(3, 3);
  std::string lists;
  std::string slices;
  for (std::size_t n = 0; n < 3; ++n) {
    folder.write(fmt::format("step{}", n), all.substr(shorts.size() * n, shorts.size()));
    lists += fmt::format("step{}\n", n);
  }
  for (std::size_t n = 0; n < 15; ++n) {
    folder.write(fmt::format("slice{}", n), all.substr(bytes_a_slice * n, bytes_a_slice));
    slices += fmt::format("slice{}\n", n);
  }
  VolumeChoice step;
  step.step = 2;
  for (const std::string& files :
       {"LIST\n" + lists, "LIST 3\n" + lists, "LIST 2\n" + slices, std::string("step%d 0 2 1")}) {
    SCOPED_TRACE(files.substr(0, 6));
    const auto path =
        folder.write("a.mhd", bare(4, "7 6 5 3", fmt::format("ElementType = MET_SHORT\nElementDataFile = {}", files)));
    EXPECT_EQ(floats_of(volume_of(path, step)), samples_at(2));
  }
  const std::string colours = bytes_with_axis(0, 2);
  for (std::size_t k = 0; k < nz; ++k)
    folder.write(fmt::format("rgb{}", k), colours.substr(2 * bytes_a_slice * k, 2 * bytes_a_slice));
  VolumeChoice component;
  component.component = 1;
  const auto path = folder.write(
      "b.mhd", bare(3, "7 6 5", "ElementNumberOfChannels = 2\n" + short_type + "ElementDataFile = rgb%d 0 4 1\n"));
  EXPECT_EQ(floats_of(volume_of(path, component)), samples_at(1));
}

TEST(MetaImage, HeaderSizesAndDataThatAreLonger) {
  const TestFolder folder;
  folder.write("long.raw", "header" + shorts);
  expect_oblique(volume_of(mhd(folder, "HeaderSize = 6\n", "long.raw")));
  expect_oblique(volume_of(mhd(folder, "HeaderSize = -1\n", "long.raw")));
  expect_data_error(mhd(folder, "", "long.raw"), "write 'HeaderSize = -1' into the header if they are its last bytes");
  folder.write("tail.raw", shorts + "xx");
  const auto stated = mhd(folder, "HeaderSize = 0\n", "tail.raw");
  expect_oblique(volume_of(stated));
  expect_notes(read_volume(stated), stated, {"'tail.raw' has 2 bytes after its samples, which were not used"});
  // A header over a .nii.gz.
  folder.write("v.nii.gz", deflated(std::string(352, 'h') + shorts, true));
  expect_oblique(volume_of(mhd(folder, "CompressedData = True\nHeaderSize = -1\n", "v.nii.gz")));
  expect_data_error(mhd(folder, "CompressedData = True\n", "v.nii.gz"), "is 352 bytes longer than its samples");
  folder.write("text.txt", "header" + text_of_samples());
  std::string text = metaimage_header("HeaderSize = 6\n" + short_type + "ElementDataFile = text.txt");
  text.replace(text.find("BinaryData = True"), 17, "BinaryData = False");
  expect_oblique(volume_of(folder.write("text.mhd", text)));
}

TEST(MetaImage, HeadersThatAreWrong) {
  struct Wrong {
    std::string header;
    const char* message;
  };
  const std::string end = short_type + "ElementDataFile = LOCAL\n";
  const std::vector<Wrong> wrongs = {
      {bare(1, "7", end), "its NDims is 1"},
      {bare(11, "7 6 5", end), "its NDims '11' is not a whole number from 1 to 10"},
      {bare(0, "", end), "its NDims '0'"},
      {"NDims = 3\n" + end, "has no DimSize"},
      {bare(3, "7 6", end), "3 numbers are expected"},
      {bare(3, "7 6 -5", end), "is not that of a 3-D volume"},
      {bare(3, "1000000000 1000000000 1000000000", end), "is not that of a 3-D volume"},
      {bare(4, "7 6 5 1000000000", end), "it has 1000000000 steps"},
      {bare(4, "100000 100000 5 1000000000", end), "is not that of a volume"},
      {bare(5, "7 6 5 2 2", end), "it has two axes of steps"},
      {bare(3, "7 6 5", "ElementNumberOfChannels = 1e300\n" + end), "ElementNumberOfChannels '1e300'"},
      {bare(3, "7 6 5", "ElementNumberOfChannels = 0\n" + end), "ElementNumberOfChannels '0'"},
      {bare(3, "7 6 5", "ElementNumberOfChannels = 1000000000\n" + end), "it has 1000000000 components"},
      {bare(3, "7 6 5", "CompressedData = maybe\n" + end), "neither True nor False"},
      {bare(3, "7 6 5", "HeaderSize = -2\n" + end), "its HeaderSize '-2'"},
      {bare(3, "7 6 5", "HeaderSize = 1e300\n" + end), "its HeaderSize '1e300'"},
      {bare(3, "7 6 5", "HeaderSize = 1000000000\n" + end), "truncated"},
      {bare(3, "7 6 5", "BinaryData = False\nHeaderSize = -1\n" + end), "not possible for text"},
      {bare(3, "7 6 5", "DistanceUnits = ell\n" + end), "'ell' is not known"},
      {bare(3, "7 6 5", "TransformMatrix = 1 0 0 1\n" + end), "9 numbers are expected"},
      {bare(3, "7 6 5", "ElementSpacing = 1 1 0\n" + end), "must be > 0"},
      {bare(4, "7 6 5 1", "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1\n" + end), "mixes the axes of space"},
      {bare(3, "7 6 5", short_type + "ElementDataFile = none.raw\n"), "its data file 'none.raw' is missing"},
      {bare(3, "7 6 5", short_type + "ElementDataFile =\n"), "its data file ''"},
      {bare(3, "7 6 5", short_type), "no ElementDataFile"},
  };
  const TestFolder folder;
  for (const Wrong& wrong : wrongs) {
    SCOPED_TRACE(wrong.header);
    expect_data_error(folder.write("a.mha", wrong.header + shorts), wrong.message);
  }
  const auto scaled = folder.write(
      "b.mha", bare(3, "7 6 5", "ElementSpacing = 1 1 1\nElementToIntensityFunctionSlope = 2\n" + end) + shorts);
  expect_notes(read_volume(scaled), scaled, {"was not applied"});
  const auto twice =
      folder.write("c.mha", bare(3, "7 6 4", "ElementSpacing = 1 1 1\nDimSize = 7 6 5\nNDims = 3\n" + end) + shorts);
  EXPECT_EQ(floats_of(volume_of(twice)), samples());
  expect_notes(read_volume(twice), twice, {"has the key 'dimsize' twice; '7 6 5' was taken, not '7 6 4'"});
}

}  // namespace
}  // namespace isobench
