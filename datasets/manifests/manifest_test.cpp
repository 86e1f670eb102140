#include "isobench/datasets/manifests/manifest.h"

#include <gtest/gtest.h>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

const std::string manifest_head = "title = \"T\"\nisovalue = 2.5\n";
const std::string manifest_data = "[data]\nfiles = [ { name = \"v.nrrd\" } ]\n";

Manifest parse(const std::string& text) {
  const TestFolder folder;
  const auto path = folder.write("own.toml", text);
  return read_manifest(path, path.string());
}

/// The message has the place (file:line:) and `part`.
void expect_usage_error(const std::string& text, int line, const std::string& part) {
  try {
    parse(text);
    ADD_FAILURE() << "no error for:\n" << text;
  } catch (const UsageError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("own.toml:" + std::to_string(line) + ":"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(Manifest, SaysFilesStepsAndSurface) {
  const Manifest manifest = parse(
      "title = \"T\"\nlicence = \"L\"\nisovalue = -3\ninside = \"below\"\nkernel = \"catmull-rom\"\n"
      "prepare = [ { step = \"gaussian\", sigma = [1, 2.5, 3] }, { step = \"close-border\" } "
      "]\n"
      "[data]\nfolder = \"f\"\nraw = { size = [4, 5, 6], spacing = 2, type = \"i16\", byte_order = \"big\" }\n"
      "files = [ { name = \"a\" }, { name = \"b\" } ]\n");
  EXPECT_EQ(manifest.name, "own");
  EXPECT_EQ(manifest.isovalue, -3.0);
  EXPECT_EQ(manifest.inside, Inside::below);
  EXPECT_EQ(manifest.kernel, Kernel::catmull_rom);
  ASSERT_EQ(manifest.steps.size(), 2U);
  EXPECT_EQ(std::get<Gaussian>(manifest.steps[0]).sigma, Eigen::Vector3d(1.0, 2.5, 3.0));
  const auto& border = std::get<CloseBorder>(manifest.steps[1]);
  EXPECT_EQ(border.isovalue, -3.0);  // those of the surface
  EXPECT_TRUE(border.object_below);
  ASSERT_TRUE(manifest.raw);
  EXPECT_EQ(manifest.raw->size, (std::array<int, 3>{4, 5, 6}));
  EXPECT_EQ(manifest.raw->spacing, Eigen::Vector3d::Constant(2.0));
  EXPECT_EQ(manifest.raw->order, ByteOrder::big);
  EXPECT_EQ(manifest.files[1].name, "b");
}

TEST(Manifest, SaysHowExactTheIsovalueIsAndHowSmallAComponentMayBe) {
  const Manifest plain = parse(manifest_head + manifest_data);
  EXPECT_FALSE(plain.choices.exact_isovalue);
  EXPECT_EQ(plain.choices.min_component, 0.0);
  const Manifest chosen = parse(manifest_head + "exact-isovalue = true\nmin-component = 2.5\n" + manifest_data);
  EXPECT_TRUE(chosen.choices.exact_isovalue);
  EXPECT_EQ(chosen.choices.min_component, 2.5);
  expect_usage_error(manifest_head + "min-component = -1\n" + manifest_data, 3, "min-component is -1");
  expect_usage_error(manifest_head + "exact-isovalue = 1\n" + manifest_data, 3, "");
}

TEST(Manifest, ErrorsNameTheLineAndTheNearestName) {
  expect_usage_error(manifest_head + "isovalu = 3\n" + manifest_data, 3, "isovalue");
  expect_usage_error(manifest_head + "prepare = [ { step = \"gausian\", sigma = 1 } ]\n" + manifest_data, 3,
                     "gaussian");
  expect_usage_error(manifest_head + "prepare = [ { step = \"gaussian\", sigmas = 1 } ]\n" + manifest_data, 3, "sigma");
  expect_usage_error(manifest_head + "prepare = [ { step = \"gaussian\", sigma = 0 } ]\n" + manifest_data, 3, "> 0");
  expect_usage_error(manifest_head + "prepare = [ { step = \"gaussian\", sigma = [1, 2] } ]\n" + manifest_data, 3,
                     "three");
  expect_usage_error(manifest_head + "prepare = [ { step = \"pad\", voxels = -1 } ]\n" + manifest_data, 3,
                     "at least 0");
  expect_usage_error(manifest_head + "prepare = [ { step = \"close-border\", layers = 2 } ]\n" + manifest_data, 3,
                     "remove 'layers'");
  expect_usage_error(manifest_head + "inside = \"abov\"\n" + manifest_data, 3, "above");
  expect_usage_error(manifest_head + "kernel = \"b-spline\"\n" + manifest_data, 3, "bspline");
  expect_usage_error(manifest_head + "[phantom]\nname = \"spere\"\nnodes = 64\n", 2, "isovalue");
  expect_usage_error("title = \"T\"\n[phantom]\nname = \"spere\"\nnodes = 64\n", 3, "sphere");
  expect_usage_error("title = \"T\"\n[phantom]\nname = \"sphere\"\nnodes = 3\n", 4, "at least");
  expect_usage_error("title = \"T\"\n" + manifest_data, 1, "isovalue");
  expect_usage_error(manifest_head, 1, "[data]");
}

TEST(Manifest, APhantomsOwnLengthsMayBeStated) {
  const std::string sheets = "title = \"T\"\n[phantom]\nname = \"thin-sheets\"\nnodes = 64\n";
  const Manifest manifest = parse(sheets + "gap = 1.5\n");
  EXPECT_EQ(manifest.phantom->parameters, (std::map<std::string, double>{{"gap", 1.5}}));
  EXPECT_NE(manifest_checksum(manifest, {}), manifest_checksum(parse(sheets), {}));
  // Stating the default value changes nothing.
  EXPECT_EQ(manifest_checksum(parse(sheets + "gap = 1\n"), {}), manifest_checksum(parse(sheets), {}));
  expect_usage_error(sheets + "gap = 0\n", 5, "0.01 to 100 mm");
  expect_usage_error(sheets + "gap = inf\n", 5, "0.01 to 100 mm");
  expect_usage_error(sheets + "gab = 1\n", 5, "did you mean 'gap'?");
  expect_usage_error("title = \"T\"\n[phantom]\nname = \"sphere\"\nnodes = 64\ngap = 1\n", 5, "gap");
}

TEST(Manifest, AGeneratedVolumeHasTheNumbersOfItsGenerator) {
  const std::string head = "title = \"T\"\n[generated]\nseed = 7\nsize = [24, 32, 48]\n";
  const std::string mask = head + "generator = \"mask\"\nspacing = [1, 1, 7]\ncorrelation = 1.8\nquantile = 0.7\n";
  const Manifest manifest = parse("inside = \"below\"\n" + mask);
  ASSERT_TRUE(manifest.generated);
  EXPECT_EQ(manifest.inside, Inside::below);
  EXPECT_EQ(manifest.generated->generator, Generator::mask);
  EXPECT_EQ(manifest.generated->size, (std::array<int, 3>{24, 32, 48}));
  EXPECT_EQ(manifest.generated->spacing, Eigen::Vector3d(1.0, 1.0, 7.0));
  EXPECT_EQ(manifest.generated->quantile, 0.7);
  EXPECT_NE(manifest_checksum(parse(mask), {}), manifest_checksum(manifest, {}));
  EXPECT_NE(manifest_checksum(parse("kernel = \"catmull-rom\"\n" + mask), {}), manifest_checksum(parse(mask), {}));
  const Manifest islands = parse(head + "generator = \"islands\"\nislands = 30\nradii = [0.9, 8]\n");
  EXPECT_EQ(islands.generated->radii, (std::array<double, 2>{0.9, 8.0}));
  EXPECT_EQ(parse(head + "generator = \"foam\"\nbubbles = 9\nwall = 2.5\n").generated->bubbles, 9);
}

TEST(Manifest, AGeneratedVolumesMistakesHaveTheirPlace) {
  const std::string head = "title = \"T\"\n[generated]\nsize = 32\n";
  const std::string field = head + "generator = \"random-field\"\n";
  expect_usage_error(head + "generator = \"mas\"\n", 4, "did you mean 'mask'?");
  expect_usage_error(head, 2, "'generator' is missing");
  expect_usage_error(field + "correlation = 2\n", 2, "'quantile' is missing");
  expect_usage_error(field + "correlation = 0.1\nquantile = 0.5\n", 5, "from 0.5 to 50 voxels");
  expect_usage_error(field + "correlation = 2\nquantile = 1\n", 6, "from 0.01 to 0.99");
  expect_usage_error(field + "bubbles = 3\n", 5, "unknown key 'bubbles'");
  expect_usage_error("title = \"T\"\n[generated]\nsize = 8\ngenerator = \"foam\"\nbubbles = 3\n", 3, "at least 16");
  expect_usage_error(head + "generator = \"foam\"\nbubbles = 1\nwall = 2\n", 5, "at least 2");
  expect_usage_error(head + "generator = \"islands\"\nislands = 3\nradii = [4, 2]\n", 6, "the smaller one first");
  expect_usage_error("title = \"T\"\nisovalue = 1\n[generated]\nsize = 32\n", 2,
                     "a generated volume has no 'isovalue'");
  expect_usage_error(manifest_head + manifest_data + "[phantom]\nname = \"sphere\"\nnodes = 64\n", 1, "exactly one of");
}

TEST(Manifest, MayTakeTheFilesOfAnotherOne) {
  const TestFolder folder;
  folder.write("scan.toml", "licence = \"L\"\nsource = \"S\"\n" + manifest_head +
                                "[data]\nfolder = \"f\"\nfiles = [ { name = \"a\" }, { name = \"b\" } ]\n");
  const auto borrowing = [&](const std::string& data) {
    const auto path = folder.write("block.toml", "source = \"own\"\ntitle = \"B\"\nisovalue = 7\n" + data);
    return read_manifest(path, path.string());
  };
  const Manifest block = borrowing("[data]\nof = \"scan\"\n");
  EXPECT_EQ(block.files.size(), 2U);
  EXPECT_EQ(block.folder, "f");
  EXPECT_EQ(block.isovalue, 7.0);
  EXPECT_EQ(block.licence, "L");
  EXPECT_EQ(block.source, "own");
  for (const char* data : {"[data]\nof = \"scam\"\n", "[data]\nof = \"../scan\"\n",
                           "[data]\nof = \"scan\"\nfiles = []\n", "[data]\nof = \"block\"\n"}) {
    EXPECT_THROW(borrowing(data), UsageError) << data;
  }
}

TEST(Manifest, RefusesFilesThatCouldDoHarm) {
  expect_usage_error(manifest_head + "[data]\nfiles = [ { name = \"../v.nrrd\" } ]\n", 4, "..");
  expect_usage_error(manifest_head + "[data]\nfiles = [ { name = \"/etc/v.nrrd\" } ]\n", 4, "relative");
  expect_usage_error(manifest_head + "[data]\naddress = \"https://example.org/\"\nfiles = [ { name = \"v.nrrd\" } ]\n",
                     5, "sha256");
  expect_usage_error(manifest_head + "[data]\nfiles = [ { name = \"v.nrrd\", sha256 = \"12\" } ]\n", 4, "64");
  expect_usage_error(manifest_head + "[data]\nfiles = []\n", 3, "at least one");
}

TEST(ManifestChecksum, CoversAllThatDecidesTheResultAndNothingElse) {
  const std::string steps = "prepare = [ { step = \"gaussian\", sigma = 1.5 } ]\n";
  const auto sum = [](const std::string& text) { return manifest_checksum(parse(text), {"s"}); };
  const std::string reference = sum(manifest_head + steps + manifest_data);
  EXPECT_EQ(sum("licence = \"other\"\nsource = \"x\"\n" + manifest_head + steps + manifest_data), reference);
  EXPECT_NE(sum(manifest_head + manifest_data), reference);
  EXPECT_NE(sum(manifest_head + "prepare = [ { step = \"gaussian\", sigma = 1.500001 } ]\n" + manifest_data),
            reference);
  EXPECT_NE(sum("title = \"T\"\nisovalue = 2.500001\n" + steps + manifest_data), reference);
  EXPECT_NE(sum(manifest_head + "inside = \"below\"\n" + steps + manifest_data), reference);
  EXPECT_NE(sum(manifest_head + "kernel = \"catmull-rom\"\n" + steps + manifest_data), reference);
  EXPECT_NE(sum(manifest_head + "min-component = 5\n" + steps + manifest_data), reference);
  EXPECT_EQ(sum(manifest_head + "min-component = 0\nexact-isovalue = true\n" + steps + manifest_data), reference);
  EXPECT_NE(manifest_checksum(parse(manifest_head + steps + manifest_data), {"t"}), reference);
}

TEST(Manifest, WhatGoesToOtherProgramsIsNoOptionOfTheirs) {
  const std::string sum = "sha256 = \"" + std::string(64, '0') + "\"";
  const auto packaged = [&](const std::string& package, const std::string& archive, const std::string& member) {
    return manifest_head + "[data]\npackage = \"" + package + "\"\narchive = \"" + archive +
           "\"\nfiles = [ { name = \"v.nrrd\", " + sum + ", member = \"" + member + "\" } ]\n";
  };
  EXPECT_EQ(parse(packaged("libcgal-demo", "a.tar.gz", "m/v.nrrd")).package->archive, "a.tar.gz");
  expect_usage_error(packaged("--option=x", "a.tar.gz", "m"), 4, "'--option=x' is not the name of a Debian package");
  expect_usage_error(packaged("libcgal-demo", "/etc/a.tar.gz", "m"), 5, "relative");
  expect_usage_error(packaged("libcgal-demo", "a.tar.gz", "--to-command=x"), 6, "cannot be the path of a file");
  expect_usage_error(manifest_head + "[data]\nfiles = [ { name = \"" + std::string(300, 'n') + "\" } ]\n", 4,
                     "cannot be the path");
}

TEST(Manifest, NumbersBeyondWhatCanBeDoneAreRefused) {
  const auto step = [](const std::string& text) {
    return manifest_head + "prepare = [ { step = " + text + " } ]\n" + manifest_data;
  };
  expect_usage_error("title = \"T\"\n[phantom]\nname = \"sphere\"\nnodes = 2147483647\n", 4, "at most 2048");
  expect_usage_error(step("\"pad\", voxels = 3000000000"), 3, "at most 2147483647");
  expect_usage_error(step("\"pad\", voxels = 1, value = 1e39"), 3, "finite");
  expect_usage_error(step("\"cut\", from = [0, 0], size = 8"), 3, "three numbers");
  expect_usage_error(step("\"cut\", from = [0, 0, -1], size = 8"), 3, "at least 0");
  expect_usage_error(step("\"cut\", from = [0, 0, 0], size = [8, 8]"), 3, "one number or three");
  expect_usage_error(step("\"gaussian\", sigma = 1e9"), 3, "at most 1000 voxels");
}

TEST(Manifest, ItsNameCannotLeaveTheFoldersThatAreNamedAfterIt) {
  const TestFolder folder;
  for (const std::string name : {"...toml", ".hidden.toml", "-option.toml", "a\nb.toml"}) {
    const auto path = folder.write(name, manifest_head + manifest_data);
    EXPECT_THROW(read_manifest(path, path.string()), UsageError) << name;
  }
}

}  // namespace
}  // namespace isobench
