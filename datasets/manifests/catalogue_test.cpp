#include "isobench/datasets/manifests/catalogue.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "isobench/datasets/manifests/file_surface.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/sha256.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_variable.h"

namespace isobench {
namespace {

/// An NRRD file of a ball of radius 4 voxels in 16³ nodes 2 mm apart. Values fall by 1 per voxel and are 10 at the
/// radius.
std::string ball_nrrd(double centre = 7.5) {
  std::vector<float> samples;
  for (int k = 0; k < 16; ++k) {
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 16; ++i) {
        const double radius = std::hypot(i - centre, j - 7.5, k - 7.5);
        samples.push_back(static_cast<float>(14.0 - radius));
      }
    }
  }
  return "NRRD0001\ntype: float\ndimension: 3\nsizes: 16 16 16\nspacings: 2 2 2\nendian: little\nencoding: raw\n\n" +
         bytes_of_samples<float>(samples);
}

/// A folder with a catalogue of one dataset, "ball", whose data may lie in data/, cache/ or published/.
class CatalogueOfOne : public testing::Test {
 protected:
  void write_manifest(const std::string& address, const std::string& sha256) {
    const std::string from = address.empty() ? "" : "address = \"" + address + "\"\n";
    folder.write(
        "catalogue/ball.toml",
        fmt::format("title = \"Ball\"\nisovalue = 10\nprepare = [ {{ step = \"gaussian\", sigma = 0.5 }} ]\n[data]\n{}"
                    "files = [ {{ name = \"ball.nrrd\", sha256 = \"{}\" }} ]\n",
                    from, sha256));
  }
  std::string message_of_load(const std::string& name = "ball") {
    try {
      Monitor monitor;
      load_dataset(name, monitor, {"config.toml", 7, 3});
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "no error";
  }
  Dataset load() {
    Monitor monitor;
    return load_dataset("ball", monitor);
  }

  TestFolder folder;
  std::string ball = ball_nrrd();
  std::string sum = sha256_of_text(ball);
  std::string published = "file://" + (folder.path() / "published").string() + "/";
  TestVariable catalogue{"ISOBENCH_CATALOGUE", (folder.path() / "catalogue").string()};
  TestVariable cache{"ISOBENCH_CACHE", (folder.path() / "cache").string()};
  TestVariable data{"ISOBENCH_DATA", ""};
};

TEST_F(CatalogueOfOne, FetchesOnceThenTakesTheCache) {
  folder.write("published/ball.nrrd", ball);
  write_manifest(published, sum);
  const Dataset fetched = load();
  EXPECT_NE(fetched.source.find("fetched from " + published), std::string::npos) << fetched.source;
  EXPECT_EQ(fetched.title, "Ball");
  EXPECT_EQ(fetched.preparation.size(), 1U);
  std::filesystem::remove(folder.path() / "published/ball.nrrd");
  const Dataset cached = load();
  EXPECT_TRUE(cached.source.starts_with("the cache")) << cached.source;
  EXPECT_EQ(cached.source.find("fetched"), std::string::npos);
  EXPECT_EQ(cached.checksum, fetched.checksum);
  EXPECT_EQ(cached.checksum, dataset_checksum("ball"));
  Monitor monitor;
  EXPECT_EQ(load_dataset("ball", monitor, {}, 5.0).checksum, cached.checksum) << "the experiment's choice is no data";
  EXPECT_EQ(fetch_dataset("ball", monitor), std::vector{folder.path() / "cache/ball/ball.nrrd"});
  // No incomplete file is left beside it.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "cache/ball"), {}), 1);
}

TEST_F(CatalogueOfOne, IsobenchDataComesBeforeTheCache) {
  write_manifest(published, sum);
  folder.write("cache/ball/ball.nrrd", ball);
  folder.write("data/ball/ball.nrrd", ball);
  const TestVariable variable("ISOBENCH_DATA", (folder.path() / "data").string());
  EXPECT_TRUE(load().source.starts_with("ISOBENCH_DATA")) << load().source;
  std::filesystem::remove(folder.path() / "data/ball/ball.nrrd");
  EXPECT_TRUE(load().source.starts_with("the cache"));
}

TEST_F(CatalogueOfOne, AWrongChecksumNamesFileSumsAndRemedy) {
  write_manifest(published, sum);
  const std::string other = ball + "x";
  for (const char* place : {"published/ball.nrrd", "cache/ball/ball.nrrd", "data/ball/ball.nrrd"}) {
    SCOPED_TRACE(place);
    folder.write(place, other);
    std::filesystem::create_directories(folder.path() / "data");
    const TestVariable variable("ISOBENCH_DATA", (folder.path() / "data").string());
    const std::string message = message_of_load();
    EXPECT_NE(message.find("ball.nrrd"), std::string::npos) << message;
    EXPECT_NE(message.find(sum), std::string::npos) << message;
    EXPECT_NE(message.find(sha256_of_text(other)), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
  }
  EXPECT_THROW(load(), DataError);
}

TEST_F(CatalogueOfOne, WithoutNetworkOneSentenceSaysIsobenchData) {
  write_manifest("http://127.0.0.1:1/", sum);  // no server listens there
  const std::string message = message_of_load();
  EXPECT_NE(message.find("set ISOBENCH_DATA to a folder that has ball/ball.nrrd"), std::string::npos) << message;
  EXPECT_THROW(load(), DataError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "cache/ball"));
  const TestVariable variable("ISOBENCH_DATA", (folder.path() / "nowhere").string());
  EXPECT_NE(message_of_load().find("not a folder"), std::string::npos);
}

TEST_F(CatalogueOfOne, AnUnknownNameHasItsPlaceAndTheNearest) {
  write_manifest(published, sum);
  EXPECT_THROW(dataset_checksum("bal"), UsageError);
  const std::string message = message_of_load("bal");
  EXPECT_TRUE(message.starts_with("config.toml:7:3: ")) << message;
  EXPECT_NE(message.find("did you mean 'ball'?"), std::string::npos) << message;
}

/// Writes a program of this name that runs these shell commands, to a folder that the test puts first in PATH.
void write_program(const TestFolder& folder, const std::string& name, const std::string& commands) {
  const auto path = folder.write("bin/" + name, "#!/bin/sh\n" + commands + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
}

TEST_F(CatalogueOfOne, TakesFilesOutOfADebianPackage) {
  folder.write("package/DEBIAN/control",
               "Package: balls\nVersion: 1\nArchitecture: all\nMaintainer: nobody <n@example.org>\nDescription: x\n");
  folder.write("package/usr/share/balls/images/ball.nrrd", ball);
  const std::string root = folder.path().string();
  const std::string share = root + "/package/usr/share/balls";
  ASSERT_TRUE(run_command({"tar", "-C", share, "-czf", share + "/data.tar.gz", "images"}).exit.succeeded());
  std::filesystem::remove_all(share + "/images");
  ASSERT_TRUE(run_command({"dpkg-deb", "--build", root + "/package", root + "/balls_1_all.deb"}).exit.succeeded());
  // Stands in for the package archive.
  write_program(folder, "apt-get", "test \"$1 $2\" = 'download balls' && cp " + root + "/balls_1_all.deb .");
  const TestVariable path("PATH", root + "/bin:" + std::getenv("PATH"));
  const auto write = [&](const std::string& member, const std::string& sha256) {
    folder.write(
        "catalogue/ball.toml",
        fmt::format(
            "title = \"Ball\"\nisovalue = 10\n[data]\npackage = \"balls\"\narchive = \"usr/share/balls/data.tar.gz\"\n"
            "files = [ {{ name = \"ball.nrrd\", member = \"{}\", sha256 = \"{}\" }} ]\n",
            member, sha256));
  };
  write("images/none.nrrd", sum);
  EXPECT_NE(message_of_load().find("Debian package balls"), std::string::npos) << message_of_load();
  write("images/ball.nrrd", std::string(64, '0'));
  EXPECT_NE(message_of_load().find(sum), std::string::npos) << message_of_load();
  write("images/ball.nrrd", sum);
  EXPECT_NE(load().source.find("fetched from the Debian package balls"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "cache/ball"), {}), 1);
  std::filesystem::remove(folder.path() / "cache/ball/ball.nrrd");
  write_program(folder, "apt-get", "echo 'E: Unable to locate package balls' >&2; exit 100");
  const std::string message = message_of_load();
  EXPECT_NE(message.find("E: Unable to locate package balls"), std::string::npos) << message;
  EXPECT_NE(message.find("ISOBENCH_DATA"), std::string::npos) << message;
}

TEST_F(CatalogueOfOne, AUsersOwnManifestHasItsDataBesideIt) {
  folder.write("own/mine.toml",
               "title = \"Mine\"\nisovalue = 10\n[data]\nfolder = \"scans\"\nfiles = [ { name = \"b.nrrd\" } ]\n");
  folder.write("own/scans/b.nrrd", ball);
  const std::string name = (folder.path() / "own/mine.toml").string();
  Monitor monitor;
  const Dataset dataset = load_dataset(name, monitor);
  EXPECT_EQ(dataset.name, "mine");
  EXPECT_EQ(dataset.checksum, dataset_checksum(name));
  EXPECT_GT(dataset.surface->value({15.0, 15.0, 15.0}), 0.0);  // the middle is inside
  folder.write("own/scans/b.nrrd", ball_nrrd(7.0));
  EXPECT_NE(dataset_checksum(name), dataset.checksum);  // the manifest states no sha256, so the file's own is used
  std::filesystem::remove(folder.path() / "own/scans/b.nrrd");
  EXPECT_NE(message_of_load(name).find("b.nrrd: no such file"), std::string::npos) << message_of_load(name);
  EXPECT_NE(message_of_load("none.toml").find("config.toml:7:3"), std::string::npos);
}

TEST(Catalogue, EveryManifestIsValidAndPinned) {
  const TestVariable data("ISOBENCH_CATALOGUE", "");
  const auto names = dataset_names();
  for (const char* name : {"brain", "pelvis", "skull", "vessel", "skull-small", "brain-mni", "brain-mni-half"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
  for (const Phantom& phantom : phantoms()) {
    EXPECT_NE(std::find(names.begin(), names.end(), phantom.name), names.end()) << phantom.name;
  }
  for (const DatasetInfo& info : list_datasets()) {
    SCOPED_TRACE(info.name);
    EXPECT_FALSE(info.title.empty());
    EXPECT_FALSE(info.source.empty());
    if (!info.source.starts_with("phantom") && !info.source.starts_with("generated")) {
      EXPECT_FALSE(info.licence.empty());
    }
  }
  // This needs no data, because the catalogue states every file's checksum. No two datasets, and no two members of a
  // family, are the same.
  std::set<std::string> checksums;
  for (const std::string& name : names) checksums.insert(dataset_checksum(name));
  EXPECT_EQ(checksums.size(), names.size());
}

TEST(Catalogue, PhantomsLoadWithTheirCentreInside) {
  Monitor monitor;
  const Dataset dataset = load_dataset("sphere", monitor);
  EXPECT_EQ(dataset.source, "phantom");
  EXPECT_EQ(dataset.checksum, dataset_checksum("sphere"));
  for (const char* name : {"sphere", "wild-islands-001"})
    EXPECT_EQ(load_dataset(name, monitor, {}, 5.0).checksum, dataset_checksum(name)) << name;
  EXPECT_GT(dataset.surface->value(dataset.surface->lattice().to_local(Eigen::Vector3d::Zero())), 0.0);
  EXPECT_NE(dataset.checksum, dataset_checksum("torus"));
}

TEST(DatasetFromFile, TakesAnIsovalueAndSmoothing) {
  const TestFolder folder;
  const auto path = folder.write("ball.nrrd", ball_nrrd());
  Monitor monitor;
  const Dataset plain = dataset_from_file(path, {.isovalue = 10.0}, monitor);
  EXPECT_EQ(plain.name, "ball");
  EXPECT_TRUE(plain.preparation.empty());
  EXPECT_TRUE(monitor.notes().empty());
  const Dataset smooth = dataset_from_file(path, {.isovalue = 10.0, .smooth_voxels = 1.0}, monitor);
  EXPECT_EQ(smooth.preparation.size(), 1U);
  EXPECT_NE(smooth.checksum, plain.checksum);
  EXPECT_NE(dataset_from_file(path, {.isovalue = 10.5}, monitor).checksum, plain.checksum);
  EXPECT_EQ(dataset_from_file(path, {.isovalue = 10.0}, monitor).checksum, plain.checksum);
  EXPECT_THROW(dataset_from_file(path, {.isovalue = 99.0}, monitor), DataError);
  EXPECT_THROW(dataset_from_file(path, {.isovalue = 10.0, .smooth_voxels = -1.0}, monitor), UsageError);
}

/// Two blocks of labels in 16³ nodes, 4 ≤ j, k < 12: the first where 2 ≤ i < 7, the second where 9 ≤ i < 14.
template <class Label>
std::string two_blocks(Label first, Label second) {
  std::string bytes;
  for (int n = 0; n < 16 * 16 * 16; ++n) {
    const int i = n % 16;
    const int j = n / 16 % 16;
    const int k = n / 256;
    const bool within = j >= 4 && j < 12 && k >= 4 && k < 12;
    const Label label = !within ? 0 : i >= 2 && i < 7 ? first : i >= 9 && i < 14 ? second : Label{0};
    bytes += bytes_of_value(label);
  }
  return bytes;
}

/// Loads `file` through a manifest that selects one label, and says at which of the two blocks the surface is.
template <class Label>
std::string selected_block(const TestFolder& folder, const std::string& file, Label label) {
  const auto manifest = folder.write(
      "labels.toml", fmt::format("title = \"Labels\"\nisovalue = 0.5\nprepare = [ {{ step = \"labels\", labels = [{}] "
                                 "}} ]\n[data]\nfiles = [ {{ name = \"{}\" }} ]\n",
                                 label, file));
  Monitor monitor;
  const Dataset dataset = load_dataset(manifest.string(), monitor);
  const bool first = dataset.surface->value({4.0, 8.0, 8.0}) > 0.0;
  const bool second = dataset.surface->value({11.0, 8.0, 8.0}) > 0.0;
  return first && second ? "both" : first ? "first" : second ? "second" : "none";
}

template <class Label>
void expect_told_apart(const std::string& file, const std::string& header, Label first, Label second) {
  const TestFolder folder;
  folder.write(file, header + two_blocks(first, second));
  EXPECT_EQ(selected_block(folder, file, first), "first") << file;
  EXPECT_EQ(selected_block(folder, file, second), "second") << file;
}

std::string nrrd_of_blocks(const std::string& type) {
  return fmt::format(
      "NRRD0001\ntype: {}\ndimension: 3\nsizes: 16 16 16\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n", type);
}

std::string nifti_of_blocks(std::int16_t datatype, std::int16_t bits) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, const std::string& bytes) { header.replace(at, bytes.size(), bytes); };
  put(0, bytes_of_value(std::int32_t{348}));
  put(40, bytes_of_value(std::int16_t{3}));
  for (const std::size_t at : {42, 44, 46}) put(at, bytes_of_value(std::int16_t{16}));
  put(70, bytes_of_value(datatype));
  put(72, bytes_of_value(bits));
  for (const std::size_t at : {76, 80, 84, 88, 112}) put(at, bytes_of_value(1.0F));  // spacings; a slope of 1
  put(108, bytes_of_value(352.0F));
  put(344, "n+1");
  return header;
}

// Labels of the Allen brain atlas: as floats both are 312782560.
TEST(DatasetOfLabels, LabelsThatRoundToOneFloatAreToldApart) {
  expect_told_apart<std::int32_t>("i.nrrd", nrrd_of_blocks("int32"), 312782546, 312782574);
  expect_told_apart<std::uint32_t>("u.nrrd", nrrd_of_blocks("uint32"), 312782546, 312782574);
  expect_told_apart<std::int32_t>("i.nii", nifti_of_blocks(8, 32), 312782546, 312782574);
  expect_told_apart<std::uint32_t>("u.nii", nifti_of_blocks(768, 32), 312782546, 312782574);
}

TEST(DatasetOfLabels, LabelsThatRoundToOneDoubleAreToldApart) {
  const std::int64_t beyond = (std::int64_t{1} << 53) + 1;
  expect_told_apart<std::int64_t>("i.nrrd", nrrd_of_blocks("int64"), beyond, beyond - 1);
  expect_told_apart<std::int64_t>("i.nii", nifti_of_blocks(1024, 64), -beyond, 1 - beyond);
  expect_told_apart<std::uint64_t>("u.nrrd", nrrd_of_blocks("uint64"), std::uint64_t{beyond},
                                   std::uint64_t{beyond} - 1);
}

TEST(DatasetFromFile, ChecksumIsThatOfTheFloatsWhateverTheirTypeInTheFile) {
  const TestFolder folder;
  Monitor monitor;
  const auto checksum = [&](const std::string& bytes) {
    const auto path = folder.write("blocks.nrrd", bytes);
    return dataset_from_file(path, {.isovalue = 1.5}, monitor).checksum;
  };
  const std::string as_bytes = checksum(nrrd_of_blocks("uint8") + two_blocks<std::uint8_t>(3, 5));
  EXPECT_EQ(checksum(nrrd_of_blocks("float") + two_blocks<float>(3, 5)), as_bytes);
  EXPECT_EQ(checksum(nrrd_of_blocks("int64") + two_blocks<std::int64_t>(3, 5)), as_bytes);
  EXPECT_NE(checksum(nrrd_of_blocks("uint8") + two_blocks<std::uint8_t>(3, 4)), as_bytes);
}

/// True if f is inside at some node of the lattice's border.
bool inside_at_border(const Isosurface& surface) {
  const auto& size = surface.lattice().size;
  std::vector<float> slab;
  for (int k = 0; k < size[2]; ++k) {
    surface.node_values(k, slab);
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const bool border = i == 0 || j == 0 || k == 0 || i == size[0] - 1 || j == size[1] - 1 || k == size[2] - 1;
        if (border && slab[surface.lattice().index(i, j, 0)] > 0.0F) return true;
      }
    }
  }
  return false;
}

TEST(DatasetFromFile, ClosesAnObjectOutsideTheVolumeAndSaysSo) {
  const TestFolder folder;
  const auto path = folder.write("half.nrrd", ball_nrrd(1.0));  // the ball's middle lies near the border
  Monitor monitor;
  const Dataset above = dataset_from_file(path, {.isovalue = 10.0}, monitor);
  ASSERT_EQ(monitor.notes().size(), 1U);
  EXPECT_EQ(monitor.notes()[0].find("the object reaches the volume's border on 1 side; "), 0U) << monitor.notes()[0];
  EXPECT_FALSE(inside_at_border(*above.surface));
  EXPECT_EQ(above.preparation.size(), 1U);
  // The outermost nodes stay inside. The object ends half a voxel (1 mm) beyond them where they have their median
  // value; here, in the ball's middle, they have more.
  const Lattice& lattice = above.surface->lattice();
  const double outermost = lattice.to_local(Eigen::Vector3d::Zero())[0];
  EXPECT_GT(above.surface->value({outermost, 15.0, 15.0}), 0.0);
  EXPECT_GT(above.surface->value({outermost - 0.7, 15.0, 15.0}), 0.0);
  EXPECT_LT(above.surface->value({outermost - 2.0, 15.0, 15.0}), 0.0);
  // The complement of the ball reaches the border on all sides.
  const Dataset below = dataset_from_file(path, {.isovalue = 10.0, .inside = Inside::below}, monitor);
  EXPECT_EQ(monitor.notes().size(), 2U);
  EXPECT_FALSE(inside_at_border(*below.surface));
  EXPECT_THROW(dataset_from_file(path, {.isovalue = 10.0, .border = Border::refuse}, monitor), DataError);
}

}  // namespace
}  // namespace isobench
