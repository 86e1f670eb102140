#include "isobench/methods/external/points_file.h"

#include <gtest/gtest.h>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench::external {
namespace {

const std::vector<Eigen::Vector3d> expected = {{1.0, 2.0, 3.0}, {0.1, -2.5, 1e3}};

TEST(PointsFile, EveryFormatGivesTheSamePoints) {
  const TestFolder folder;
  const std::string header =
      "NRRD0001\n# a comment\ntype: double\ndimension: 2\nsizes: 4 2\nendian: little\nencoding: ";
  const std::vector<double> rows = {1.0, 2.0, 3.0, 0.0, 0.1, -2.5, 1e3, 0.0};
  const std::string raw(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(double));
  folder.write("apart.raw", raw);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  const std::vector<std::filesystem::path> files = {
      folder.write("a.nrrd", header + "raw\n\n" + raw),
      folder.write("b.nrrd", header + "ascii\n\n1 2 3 0\n0.1 -2.5 1000 0\n"),
      folder.write("c.nhdr", header + "raw\ndata file: apart.raw\n"),
      folder.write("d.xyz", "# two points\n1 2 3\n0.1 -2.5 1e3 the rest is ignored\n"),
      folder.write("e.txt", "1 2 3\n\n0.1 -2.5 1000\n"),
      folder.write("f.ply", ply + "1 2 3\n0.1 -2.5 1000\n"),
      folder.write("g.obj", "v 1 2 3\nv 0.1 -2.5 1000\n"),
      folder.write("h.off", "OFF\n2 0 0\n1 2 3\n0.1 -2.5 1000\n")};
  for (const auto& file : files) EXPECT_EQ(read_points(file), expected) << file;
}

TEST(PointsFile, WhatIsNoSetOfPointsIsRefusedByName) {
  const TestFolder folder;
  const std::string header = "NRRD0001\ntype: float\ndimension: 2\nsizes: 3 1000000000\nencoding: ";
  const std::vector<std::pair<std::filesystem::path, std::string>> bad = {
      {folder.path() / "missing.nrrd", "cannot be opened"},
      {folder.write("empty.xyz", ""), "empty"},
      {folder.write("no.xyz", "# nothing\n"), "no points"},
      {folder.write("words.xyz", "1 2 three\n"), "words.xyz:1"},
      {folder.write("two.xyz", "1 2\n"), "two.xyz:1"},
      {folder.write("nan.xyz", "1 2 3\nnan 2 3\n"), "nan.xyz"},
      {folder.write("other.nrrd", "hello\n"), "not an NRRD"},
      {folder.write("short.nrrd", header + "raw\n\n123456789012"), "holds 1 of 1000000000 points"},
      {folder.write("text.nrrd", header + "ascii\n\n1 2 3 4"), "holds 1 of"},
      {folder.write("bz.nrrd", header + "bzip2\n\n"), "bzip2"},
      {folder.write("3d.nrrd", "NRRD0001\ntype: float\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n\n1234"), "two axes"},
      {folder.write("flat.nrrd", "NRRD0001\ntype: float\ndimension: 2\nsizes: 2 1\nencoding: raw\n\n12345678"),
       "a point cannot have 2 numbers"},
      {folder.write("half.nrrd", "NRRD0001\ntype: float\nencoding: raw\n\n"), "'dimension'"}};
  for (const auto& [path, part] : bad) {
    try {
      read_points(path);
      ADD_FAILURE() << path << " was read";
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace isobench::external
