// Where NRRD files put their nodes: spaces, units, spacings and ends of axes; and axes that are no space.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/packed_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// A header of shorts with four axes.
std::string header_of_four(const std::string& sizes, const std::string& more) {
  return fmt::format("NRRD0005\ntype: short\ndimension: 4\nsizes: {}\nendian: little\nencoding: raw\n{}", sizes, more);
}

/// Header lines, and the lattice that they make.
struct PlaceCase {
  const char* fields;
  Eigen::Vector3d spacing;
  Eigen::Vector3d origin;
  const char* space = "";
  std::vector<std::string> notes = {};
};

void expect_place(const PlaceCase& place) {
  const TestFolder folder;
  SCOPED_TRACE(place.fields);
  const auto path = folder.write("a.nrrd", with_data(plain_nrrd(place.fields), shorts));
  const VolumeFile file = read_volume(path);
  EXPECT_EQ(floats_of(file.volume), samples());
  EXPECT_LT((file.volume.lattice.spacing - place.spacing).norm(), 1e-9) << file.volume.lattice.spacing.transpose();
  EXPECT_LT((file.volume.lattice.origin - place.origin).norm(), 1e-9) << file.volume.lattice.origin.transpose();
  EXPECT_EQ(file.volume.lattice.space, place.space);
  expect_notes(file, path, place.notes);
}

const std::string directions = "space directions: (12,0,0) (0,12,0) (0,0,24)\nspace origin: (100,200,300)\n";

TEST(NrrdAxes, UnitsOfLength) {
  const Eigen::Vector3d steps(12.0, 12.0, 24.0);
  const Eigen::Vector3d first(100.0, 200.0, 300.0);
  const auto with = [&](const std::string& fields, double unit) {
    const std::string all = "space dimension: 3\n" + directions + fields;
    expect_place({all.c_str(), unit * steps, unit * first});
  };
  with("space units: \"mm\" \"mm\" \"mm\"\n", 1.0);
  with("space units: \"microns\" \"microns\" \"microns\"\n", 1e-3);
  with("space units: \"micrometer\" \"um\" \"\u00b5m\"\n", 1e-3);
  with("space units: \"\u03bcm\" \"\u03bcm\" \"\u03bcm\"\n", 1e-3);
  with("space units: mm mm mm\n", 1.0);
  with("space units: \"cm\" \"cm\" \"cm\"\n", 10.0);
  with("space units: \"\" \"\" \"\"\n", 1.0);
  // Each axis of the space has its own.
  expect_place({("space: RAS\nspace units: \"cm\" \"mm\" \"m\"\n" + directions).c_str(),
                {120.0, 12.0, 24000.0},
                {1000.0, 200.0, 300000.0},
                "RAS"});
  expect_place({"spacings: 12 12 1\nunits: \"um\" \"um\" \"mm\"\n", {0.012, 0.012, 1.0}, {0.0, 0.0, 0.0}});
  expect_place({"spacings: 0.1 0.1 0.1\nunits: \"cm\" \"cm\" \"cm\"\n", {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}});
  expect_place({"spacings: 12 12 12\nspace: RAS\nspace units: \"cm\" \"cm\" \"um\"\naxis mins: 1 1 1\n",
                {120.0, 120.0, 0.012},
                {10.0, 10.0, 0.001},
                "RAS",
                {"no space directions"}});
  expect_place({("space: LPS\nunits: \"um\" \"um\" \"um\"\n" + directions).c_str(),
                1e-3 * steps,
                1e-3 * first,
                "LPS",
                {"its unit 'um' was taken as that of its space directions"}});
}

TEST(NrrdAxes, PlacesByAxisMinsMaxsSpacingsAndThicknesses) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  // The lattice has 7, 6 and 5 samples.
  expect_place({"spacings: 12 12 12\naxis mins: 100 200 300\n", {12.0, 12.0, 12.0}, {100.0, 200.0, 300.0}});
  expect_place({"spacings: 12 12 12\naxismins: 0.1 0.2 0.3\nunits: \"cm\" \"cm\" \"cm\"\n",
                {120.0, 120.0, 120.0},
                {1.0, 2.0, 3.0}});
  expect_place({"spacings: 2 2 2\naxis mins: 1 1 1\ncenters: cell node ???\n", {2.0, 2.0, 2.0}, {2.0, 1.0, 1.0}});
  expect_place(
      {"axis mins: 0 0 0\naxis maxs: 14 12 10\ncenterings: cell cell cell\n", {2.0, 2.0, 2.0}, {1.0, 1.0, 1.0}});
  expect_place({"axismins: 0 0 0\naxismaxs: 12 10 8\ncenterings: node node node\n", {2.0, 2.0, 2.0}, none});
  // With spacings, the ends tell nodes from cells.
  expect_place({"spacings: 2 2 2\naxis mins: 0 0 0\naxis maxs: 14 10 10\n", {2.0, 2.0, 2.0}, {1.0, 0.0, 1.0}});
  expect_place(
      {"spacings: 2 2 2\naxis maxs: 14 12 10\ncenterings: cell cell node\n", {2.0, 2.0, 2.0}, {1.0, 1.0, 2.0}});
  expect_place({"axis mins: 0 0 0\naxis maxs: 14 12 10\ncenterings: cell cell ???\n",
                {2.0, 2.0, 2.0},
                {1.0, 1.0, 1.0},
                "",
                {"axis 2: its header does not say whether its samples are nodes or cells"}});
  expect_place({"spacings: 2 2 2\naxis mins: 0 0 0\naxis maxs: 14 12 20\ncenterings: cell cell cell\n",
                {2.0, 2.0, 2.0},
                {1.0, 1.0, 1.0},
                "",
                {"axis 2: its spacing 2 mm does not fit its ends 0 and 20"}});
  expect_place({"spacings: 2 NaN 2\nthicknesses: NaN 5 NaN\n",
                {2.0, 5.0, 2.0},
                none,
                "",
                {"axis 1: its header has no spacing; its thickness 5 mm was taken"}});
  expect_place(
      {"spacings: 2 2 nan\n", {2.0, 2.0, 1.0}, none, "", {"axis 2: its header has no spacing; 1 mm was taken"}});
  expect_place({"spacings: 2 2 2\nspace: RAS\nspace origin: (1,2,3)\n",
                {2.0, 2.0, 2.0},
                {1.0, 2.0, 3.0},
                "RAS",
                {"no space directions"}});
  expect_place({"space dimension: 3\nspace directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (nan,nan,nan)\n",
                {2.0, 2.0, 2.0},
                none,
                "",
                {"its origin is not known"}});
}

TEST(NrrdAxes, NegativeSpacingsRunBackwards) {
  const TestFolder folder;
  const Volume volume = volume_of(folder.write(
      "a.nrrd", plain_nrrd("axis mins: 14 0 0\naxis maxs: 0 12 10\ncenterings: cell cell cell\n\n") + shorts));
  EXPECT_LT((volume.lattice.to_world({2.0, 0.0, 0.0}) - Eigen::Vector3d(11.0, 1.0, 1.0)).norm(), 1e-12);
  EXPECT_FALSE(volume.lattice.right_handed());
}

TEST(NrrdAxes, NamesOfSpaces) {
  const TestFolder folder;
  const std::string three = "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (1,2,3)\n";
  const std::string four = "space directions: (2,0,0,0) (0,2,0,0) (0,0,2,0)\nspace origin: (1,2,3,0)\n";
  const Eigen::Vector3d two(2.0, 2.0, 2.0);
  for (const char* name : {"right-anterior-superior", "RAS", "Right-Anterior-Superior"})
    expect_place({fmt::format("space: {}\n{}", name, three).c_str(), two, {1.0, 2.0, 3.0}, "RAS"});
  for (const char* name : {"left-posterior-superior", "LPS"})
    expect_place({fmt::format("space: {}\n{}", name, three).c_str(), two, {1.0, 2.0, 3.0}, "LPS"});
  for (const char* name : {"left-anterior-superior", "LAS"})
    expect_place({fmt::format("space: {}\n{}", name, three).c_str(), two, {-1.0, 2.0, 3.0}, "RAS"});
  for (const char* name : {"scanner-xyz", "3D-right-handed"})
    expect_place({fmt::format("space: {}\n{}", name, three).c_str(), two, {1.0, 2.0, 3.0}, ""});
  for (const char* name : {"right-anterior-superior-time", "RAST"})
    expect_place({fmt::format("space: {}\n{}", name, four).c_str(), two, {1.0, 2.0, 3.0}, "RAS"});
  expect_place({("space: LPST\n" + four).c_str(), two, {1.0, 2.0, 3.0}, "LPS"});
  expect_place({("space: LAST\n" + four).c_str(), two, {-1.0, 2.0, 3.0}, "RAS"});
  expect_place({("space: scanner-xyz-time\n" + four).c_str(), two, {1.0, 2.0, 3.0}, ""});
  expect_place({("space: 3D-left-handed\n" + three).c_str(), two, {1.0, 2.0, 3.0}, "", {"its space is left-handed"}});
  expect_place({("space: ijk\n" + three).c_str(), two, {1.0, 2.0, 3.0}, "", {"'ijk' is none of the format's"}});
  expect_place({("space: LPS\nspace dimension: 3\nmeasurement frame: (1,0,0) (0,1,0) (0,0,1)\n" + three).c_str(),
                two,
                {1.0, 2.0, 3.0},
                "LPS"});
}

/// An axis that is no space, in every position, marked in several ways.
TEST(NrrdAxes, AxesThatAreNoSpaceInAnyPosition) {
  const TestFolder folder;
  constexpr int places = 3;
  for (int position = 0; position < 4; ++position) {
    const auto at = [&](const std::string& space, const std::string& other) {
      std::string words;
      for (int n = 0; n < 4; ++n) words += (n == 0 ? "" : " ") + (n == position ? other : space);
      return words;
    };
    std::vector<std::string> steps = {"(0.5,0,0)", "(0,1.25,0)", "(0,0,3)"};
    std::vector<std::string> spacings = {"0.5", "1.25", "3"};
    std::vector<std::string> sizes = {"7", "6", "5"};
    steps.insert(steps.begin() + position, "none");
    spacings.insert(spacings.begin() + position, "nan");
    sizes.insert(sizes.begin() + position, std::to_string(places));
    const std::string by_directions = fmt::format("space: LPS\nspace directions: {}\n", fmt::join(steps, " "));
    const std::string by_spacings = fmt::format("spacings: {}\n", fmt::join(spacings, " "));
    const std::string kinds = "kinds: ";
    struct Mark {
      std::string fields;
      bool is_step;
    };
    const std::vector<Mark> marks = {
        {by_directions, position == 3},
        {by_spacings, position == 3},
        {by_directions + kinds + at("domain", "list") + "\n", false},
        {by_directions + kinds + at("space", "vector") + "\n", false},
        {by_directions + kinds + at("domain", "RGB-color") + "\n", false},
        {by_spacings + kinds + at("domain", "3-vector") + "\n", false},
        {by_spacings + kinds + at("???", "3D-symmetric-matrix") + "\n", false},
        {by_spacings + kinds + at("domain", "time") + "\n", true},
        {by_directions + kinds + at("domain", "TIME") + "\n", true},
    };
    for (const Mark& mark : marks) {
      SCOPED_TRACE(fmt::format("{} {}", position, mark.fields));
      const auto path = folder.write("a.nrrd", header_of_four(fmt::format("{}", fmt::join(sizes, " ")), mark.fields) +
                                                   "\n" + bytes_with_axis(position, places));
      for (std::size_t place = 0; place < places; ++place) {
        VolumeChoice choice;
        (mark.is_step ? choice.step : choice.component) = place;
        const Volume volume = volume_of(path, choice);
        EXPECT_EQ(floats_of(volume), samples_at(static_cast<int>(place)));
        EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-12);
      }
      const std::string name = mark.is_step ? "step" : "component";
      expect_data_error(path, fmt::format("it has 3 {}s; choose one with --{} 0 to 2", name, name));
      VolumeChoice other;
      (mark.is_step ? other.component : other.step) = 0;
      expect_data_error(path, fmt::format("choose one with --{} 0 to 2", name), other);
      VolumeChoice beyond;
      (mark.is_step ? beyond.step : beyond.component) = 3;
      expect_data_error(path, fmt::format("there is no {} 3", name), beyond);
    }
  }
}

TEST(NrrdAxes, FourAxesWithoutAWordOfWhichAreSpace) {
  const TestFolder folder;
  const auto colours =
      folder.write("a.nrrd", header_of_four("3 7 6 5", "spacings: 1 0.5 1.25 3\n\n") + bytes_with_axis(0, 3));
  VolumeChoice component;
  component.component = 2;
  const VolumeFile colour = read_volume(colours, component);
  EXPECT_EQ(floats_of(colour.volume), samples_at(2));
  EXPECT_LT((colour.volume.lattice.spacing - spacing).norm(), 1e-12);
  expect_notes(colour, colours, {"the first was taken as components"});
  const auto series =
      folder.write("b.nrrd", header_of_four("7 6 5 2", "spacings: 0.5 1.25 3 1\n\n") + bytes_with_axis(3, 2));
  VolumeChoice step;
  step.step = 1;
  EXPECT_EQ(floats_of(volume_of(series, step)), samples_at(1));
  expect_notes(read_volume(series, step), series, {"the first three were taken"});
}

TEST(NrrdAxes, ASpaceOfFourDimensionsHasTime) {
  const TestFolder folder;
  const std::string fields =
      "{}\nspace directions: (0.5,0,0,0) (0,1.25,0,0) (0,0,3,0) (0,0,0,2)\nspace origin: (1,2,3,9)\nspace units: "
      "\"mm\" "
      "\"mm\" \"mm\" \"s\"\n\n";
  for (const char* space : {"space dimension: 4", "space: RAST"}) {
    const auto path = folder.write(
        "a.nrrd", header_of_four("7 6 5 2", fmt::format(fmt::runtime(fields), space)) + bytes_with_axis(3, 2));
    VolumeChoice choice;
    choice.step = 1;
    const Volume volume = volume_of(path, choice);
    EXPECT_EQ(floats_of(volume), samples_at(1));
    EXPECT_LT((volume.lattice.origin - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-12);
    expect_data_error(path, "--step 0 to 1");
  }
  expect_data_error(
      folder.write("b.nrrd", header_of_four("7 6 5 1",
                                            "space dimension: 4\nspace directions: (0.5,0,0,1) (0,1.25,0,0) "
                                            "(0,0,3,0) (0,0,0,2)\n\n") +
                                 shorts),
      "both in space and in time");
}

TEST(NrrdAxes, FiveAxesAndOnesOfOnePlace) {
  const TestFolder folder;
  const std::string fields =
      "NRRD0005\ntype: short\ndimension: 5\nendian: little\nencoding: raw\nspace: LPS\nspace directions: none "
      "(0.5,0,0) (0,1.25,0) (0,0,3) none\n";
  const std::string twice = bytes_with_axis(0, 2) + bytes_with_axis(0, 2);
  VolumeChoice choice;
  choice.component = 1;
  choice.step = 1;
  EXPECT_EQ(floats_of(volume_of(folder.write("a.nrrd", fields + "sizes: 2 7 6 5 2\n\n" + twice), choice)),
            samples_at(1));
  EXPECT_EQ(floats_of(volume_of(folder.write("b.nrrd", fields + "sizes: 1 7 6 5 1\n\n" + shorts))), samples());
  const auto lists =
      folder.write("c.nrrd", fields + "kinds: vector space space space list\nsizes: 2 7 6 5 2\n\n" + twice);
  EXPECT_EQ(floats_of(volume_of(lists, choice)), samples_at(1));
  expect_notes(read_volume(lists, choice), lists, {"axis 4 of its array is chosen with --step"});
}

TEST(NrrdAxes, ImagesOfTwoDimensionsAreOneSlice) {
  const TestFolder folder;
  const std::string slice = shorts.substr(0, std::size_t{2} * nx * ny);
  const std::string fields = "NRRD0004\ntype: short\ndimension: 2\nsizes: 7 6\nendian: little\nencoding: raw\n";
  for (const char* place : {"spacings: 4 9\n", "space dimension: 2\nspace directions: (4,0) (0,9)\n",
                            "space: LPS\nspace directions: (4,0,0) (0,9,0)\n"}) {
    SCOPED_TRACE(place);
    const auto path = folder.write("a.nrrd", with_data(fields + place, slice));
    const VolumeFile file = read_volume(path);
    EXPECT_EQ(file.volume.lattice.size, (std::array<int, 3>{nx, ny, 1}));
    EXPECT_LT((file.volume.lattice.spacing - Eigen::Vector3d(4.0, 9.0, 6.0)).norm(), 1e-12);
    EXPECT_TRUE(file.volume.lattice.right_handed());
    expect_notes(file, path, {"it is one 2-D slice; 6 mm were taken as its thickness"});
  }
  const auto colours = folder.write("b.nrrd",
                                    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 2\nencoding: raw\nkinds: "
                                    "RGB-color domain domain\nspacings: nan 1 1\n\nabcdefghijkl");
  VolumeChoice choice;
  choice.component = 1;
  EXPECT_EQ(floats_of(volume_of(colours, choice)), (std::vector<float>{'b', 'e', 'h', 'k'}));
  expect_data_error(folder.write("c.nrrd", "NRRD0001\ntype: uchar\ndimension: 1\nsizes: 3\nencoding: raw\n\nabc"),
                    "1 of the 1 axes of its array is space");
}

}  // namespace
}  // namespace isobench
