// Segmentations of 3D Slicer.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/packed_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// The pairs of one segment as Slicer writes them.
std::string segment(int n, const std::string& name, const std::string& id, int label, int layer) {
  return fmt::format(
      "Segment{0}_Color:=0.5 0.7 0.6\nSegment{0}_Extent:=0 3 0 1 0 1\nSegment{0}_ID:={2}\nSegment{0}_LabelValue:={3}\n"
      "Segment{0}_Layer:={4}\nSegment{0}_Name:={1}\nSegment{0}_Tags:=Segmentation.Status:inprogress|\n",
      n, name, id, label, layer);
}

/// Labels of 4 × 2 × 2 nodes.
std::string one_layer(const std::string& pairs, const std::string& labels) {
  return "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 2 2\nspace directions: "
         "(1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n" +
         pairs + "\n" + labels;
}

/// The layers lie side by side, as in Slicer's files: the axis of layers is the fastest.
std::string layers(const std::string& pairs, const std::vector<std::string>& labels) {
  std::string data;
  for (std::size_t n = 0; n < labels.front().size(); ++n) {
    for (const std::string& layer : labels) data += layer[n];
  }
  return fmt::format(
             "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: {} 4 2 2\nspace "
             "directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\nspace origin: "
             "(0,0,0)\n",
             labels.size()) +
         pairs + "\n" + data;
}

VolumeChoice chosen(const std::string& name) {
  VolumeChoice choice;
  choice.segment = name;
  return choice;
}

Samples where(const std::string& labels, char label) {
  std::vector<std::uint8_t> inside;
  for (const char c : labels) inside.push_back(c == label ? 1 : 0);
  return inside;
}

Samples as_they_are(const std::string& labels) { return std::vector<std::uint8_t>(labels.begin(), labels.end()); }

const std::string first = {0, 1, 2, 2, 0, 1, 1, 0, 3, 3, 0, 0, 1, 2, 3, 0};
const std::string second = {1, 1, 0, 0, 0, 0, 0, 0, 0, 2, 2, 0, 1, 0, 0, 0};

TEST(NrrdSegments, OneLayerByNameIdLabelOrAsItIs) {
  const TestFolder folder;
  const auto path = folder.write(
      "a.seg.nrrd",
      one_layer(segment(0, "Left femur", "Segment_1", 2, 0) + segment(1, "tibia", "Segment_2", 3, 0), first));
  for (const char* name : {"Left femur", "Segment_1", "2", "2.0"}) {
    const VolumeFile file = read_volume(path, chosen(name));
    EXPECT_TRUE(file.volume.samples == where(first, 2)) << name;
    EXPECT_TRUE(file.notes.empty());
  }
  EXPECT_TRUE(read_volume(path, chosen("layer 0")).volume.samples == as_they_are(first));
  const VolumeFile all = read_volume(path);
  EXPECT_TRUE(all.volume.samples == as_they_are(first));
  expect_notes(all, path, {"its segments are 'Left femur' (2), 'tibia' (3); --segment chooses one"});
}

TEST(NrrdSegments, OverlappingSegmentsLieInLayers) {
  const TestFolder folder;
  const std::string pairs = segment(0, "femur", "S0", 2, 0) + segment(1, "tibia", "S1", 3, 0) +
                            segment(2, "cyst", "S2", 2, 1) + segment(10, "rim", "S10", 1, 1);
  const auto path = folder.write("a.seg.nrrd", layers(pairs, {first, second}));
  EXPECT_TRUE(read_volume(path, chosen("femur")).volume.samples == where(first, 2));
  EXPECT_TRUE(read_volume(path, chosen("cyst")).volume.samples == where(second, 2));
  EXPECT_TRUE(read_volume(path, chosen("S10")).volume.samples == where(second, 1));
  EXPECT_TRUE(read_volume(path, chosen("3")).volume.samples == where(first, 3));
  EXPECT_TRUE(read_volume(path, chosen("layer 1")).volume.samples == as_they_are(second));
  expect_data_error(path, "lie in 2 layers; choose one with --segment");
  expect_data_error(path,
                    "'femur' (2 in layer 0), 'tibia' (3 in layer 0), 'cyst' (2 in layer 1), 'rim' (1 in layer 1)");
  expect_data_error(path, "it has 2 segments '2'; choose one by its ID: 'S0', 'S2'", chosen("2"));
  expect_data_error(path, "it has no segment 'fémur'; did you mean 'femur'?", chosen("fémur"));
  expect_data_error(path, "did you mean 'layer 0'?", chosen("layer 2"));
  expect_data_error(path, "it has no segment 'something else'; its segments are 'femur' (2 in layer 0)",
                    chosen("something else"));
  VolumeChoice component;
  component.component = 1;
  expect_data_error(path, "it is a segmentation; choose with --segment", component);
}

TEST(NrrdSegments, AsSlicerWroteThemBeforeLayersHadLabels) {
  const TestFolder folder;
  const std::string pairs = "Segment0_ID:=A\nSegment0_Name:=one\nSegment1_ID:=B\nSegment1_Name:=two\n";
  const std::string ones = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  const std::string others = {0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1};
  const auto path = folder.write("a.seg.nrrd", layers(pairs, {ones, others}));
  EXPECT_TRUE(read_volume(path, chosen("one")).volume.samples == as_they_are(ones));
  EXPECT_TRUE(read_volume(path, chosen("two")).volume.samples == as_they_are(others));
}

TEST(NrrdSegments, ThatAreDamagedOrNone) {
  const TestFolder folder;
  expect_data_error(folder.write("a.nrrd", one_layer(segment(0, "x", "y", 1, 1), first)), "lies in layer 1");
  expect_data_error(folder.write("b.nrrd", one_layer(segment(0, "x", "y", 1, -1), first)), "lies in layer -1");
  expect_data_error(folder.write("c.nrrd", one_layer("Segment0_LabelValue:=one\n", first)), "numbers are expected");
  expect_data_error(folder.write("d.nrrd", one_layer("", first)), "names no segments", chosen("x"));
  const auto same = folder.write("e.nrrd", one_layer(segment(0, "x", "A", 1, 0) + segment(1, "x", "B", 2, 0), first));
  expect_data_error(same, "it has 2 segments 'x'; choose one by its ID: 'A', 'B'", chosen("x"));
  EXPECT_TRUE(read_volume(same, chosen("B")).volume.samples == where(first, 2));
  std::string many;
  for (int n = 0; n < 1000; ++n) many += segment(n, "a long name of a segment", fmt::format("Segment_{}", n), n, 0);
  const auto long_list = folder.write("f.nrrd", one_layer(many, first));
  EXPECT_LT(read_volume(long_list).notes.front().size(), 1200U);
  expect_data_error(long_list, "and 980 more", chosen("?"));
  // Names have escapes, and other pairs resemble those of segments.
  const auto odd = folder.write(
      "g.nrrd",
      one_layer("Segment_Name:=no\nSegmentation_X:=no\nSegment0x_Name:=no\nSegment-1_Name:=no\nSegment0_Name:=a\\\\b\n",
                first));
  EXPECT_TRUE(read_volume(odd, chosen("a\\b")).volume.samples == where(first, 1));
}

}  // namespace
}  // namespace isobench
