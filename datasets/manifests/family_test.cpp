#include "isobench/datasets/manifests/family.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/sha256.h"
#include "isobench/foundation/testing/test_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_variable.h"

namespace isobench {
namespace {

const std::string wild_fields =
    "title = \"Fields\"\n"
    "[generated]\ngenerator = \"random-field\"\nseed = 1000\nsize = 24\n"
    "[family]\nmembers = 120\ncorrelation = [1.5, 2, 3]\nquantile = [0.3, 0.7]\nspacing = [1, [1, 1, 7]]\n"
    "inside = [\"above\", \"below\"]\n";

const std::string wild_blocks =
    "title = \"Blocks\"\n"
    "prepare = [ { step = \"cut\", size = 8 }, { step = \"pad\", voxels = 3, value = 0 } ]\n"
    "[data]\nfiles = [ { name = \"v.nrrd\" } ]\n"
    "[family]\nname = \"scans\"\nmembers = 6\nisovalue = [16, 18.5, 17]\ncut.from = [[0, 0, 0], [4, 4, 4]]\n";

Manifest read_member(const std::string& text, std::optional<int> member) {
  const TestFolder folder;
  const auto path = folder.write("wild.toml", text);
  return read_manifest(path, path.string(), member);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

void expect_refused(const std::string& text, int line, const std::string& part, int member = 1) {
  const std::string message = message_of([&] { read_member(text, member); });
  EXPECT_NE(message.find("wild.toml:" + std::to_string(line) + ":"), std::string::npos) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Family, AMemberHasItsOwnValuesAndSaysThem) {
  const Manifest first = read_member(wild_fields, 1);
  EXPECT_EQ(first.name, "wild-001");
  EXPECT_EQ(first.family, "wild");
  ASSERT_TRUE(first.generated);
  EXPECT_EQ(first.generated->seed, 1001U);
  EXPECT_EQ(first.generated->correlation, 1.5);
  EXPECT_EQ(first.generated->quantile, 0.3);
  EXPECT_EQ(first.inside, Inside::above);
  EXPECT_EQ(first.title, "Fields 001: correlation 1.5, quantile 0.3, spacing 1, inside above");
  const Manifest second = read_member(wild_fields, 2);
  EXPECT_EQ(second.generated->seed, 1002U);
  EXPECT_EQ(second.title, "Fields 002: correlation 2, quantile 0.7, spacing [1, 1, 7], inside below");
  const Manifest seventh = read_member(wild_fields, 7);
  EXPECT_EQ(seventh.generated->spacing, Eigen::Vector3d(1.0, 1.0, 7.0));
  EXPECT_EQ(seventh.generated->size, (std::array<int, 3>{24, 24, 24}));
}

TEST(Family, AMemberOfDataHasItsOwnStepsAndIsovalue) {
  std::set<std::string> seen;
  for (int member = 1; member <= 6; ++member) {
    const Manifest manifest = read_member(wild_blocks, member);
    EXPECT_EQ(manifest.family, "scans");
    ASSERT_EQ(manifest.steps.size(), 2U);
    const auto& cut = std::get<Cut>(manifest.steps[0]);
    EXPECT_EQ(cut.size, (std::array<int, 3>{8, 8, 8}));
    EXPECT_EQ(std::get<Pad>(manifest.steps[1]).voxels, 3);
    seen.insert(fmt::format("{} {}", manifest.isovalue, cut.from[0]));
  }
  EXPECT_EQ(seen, (std::set<std::string>{"16 0", "16 4", "18.5 0", "18.5 4", "17 0", "17 4"}));
  EXPECT_EQ(read_member(wild_blocks, 2).title, "Blocks 2: isovalue 18.5, cut from [4, 4, 4]");
}

// 3 · 2 · 2 · 2 combinations, each of them 5 times among 120 members, and every value among the first three.
TEST(Family, AllCombinationsComeUpEvenly) {
  const TomlValue manifest = TomlValue::parse_text(wild_fields, "wild.toml");
  const Family family = *parse_family(manifest, "wild");
  std::map<std::string, int> counts;
  for (int member = 1; member <= family.members; ++member) ++counts[member_text(family, member)];
  EXPECT_EQ(counts.size(), 24U);
  for (const auto& [text, count] : counts) EXPECT_EQ(count, 5) << text;
  std::set<double> correlations;
  std::set<std::string> insides;
  for (int member = 1; member <= 3; ++member) {
    correlations.insert(read_member(wild_fields, member).generated->correlation);
    insides.insert(to_string(read_member(wild_fields, member).inside));
  }
  EXPECT_EQ(correlations.size(), 3U);
  EXPECT_EQ(insides.size(), 2U);
}

TEST(Family, MoreMembersChangeNoneOfThoseThatExist) {
  const std::string more = replaced(wild_fields, "members = 120", "members = 200");
  const std::string renamed = replaced(wild_fields, "title = \"Fields\"", "title = \"Other\"\nlicence = \"L\"");
  std::set<std::string> sums;
  for (const int member : {1, 2, 60, 120}) {
    const std::string sum = manifest_checksum(read_member(wild_fields, member), {});
    EXPECT_EQ(manifest_checksum(read_member(more, member), {}), sum);
    EXPECT_EQ(manifest_checksum(read_member(renamed, member), {}), sum);
    EXPECT_NE(manifest_checksum(read_member(replaced(wild_fields, "seed = 1000", "seed = 0"), member), {}), sum);
    sums.insert(sum);
  }
  EXPECT_EQ(sums.size(), 4U);
}

TEST(Family, MistakesHaveTheirPlace) {
  expect_refused(replaced(wild_fields, "quantile =", "quantil ="), 9, "did you mean 'quantile'?");
  expect_refused(replaced(wild_fields, "[0.3, 0.7]", "[0.3, 7]"), 9, "quantile is 7", 2);
  expect_refused(replaced(wild_fields, "[0.3, 0.7]", "[]"), 9, "lists no value");
  expect_refused(replaced(wild_fields, "[0.3, 0.7]", "0.3"), 9, "must be an array");
  expect_refused(replaced(wild_fields, "size = 24", "size = 24\nquantile = 0.5"), 6, "stands in [family], too");
  expect_refused(replaced(wild_fields, "members = 120\n", ""), 6, "members");
  expect_refused(replaced(wild_fields, "members = 120", "members = 0"), 7, "at least 1");
  expect_refused(replaced(wild_blocks, "members = 6", "members = 7"), 7, "6 combinations");
  expect_refused(replaced(wild_blocks, "cut.from", "cut.form"), 9, "did you mean 'from'?");
  expect_refused(replaced(wild_blocks, "cut.from", "crop.margin"), 9, "no steps 'crop'");
  expect_refused(replaced(wild_blocks, "isovalue =", "isovalu ="), 8, "did you mean 'isovalue'?");
  expect_refused(replaced(wild_blocks, "size = 8 }", "size = 8 }, { step = \"cut\", size = 4 }"), 9, "2 steps 'cut'");
  expect_refused(replaced(wild_blocks, "[data]", "[phantom]\nname = \"torus\"\n[data]"), 1, "exactly one of");
  const std::string alone = message_of([&] { read_member(wild_fields, std::nullopt); });
  EXPECT_NE(alone.find("give the name of one, wild-001 … -120"), std::string::npos) << alone;
}

/// A catalogue with a family of generated data and one of blocks of a volume.
class CatalogueOfFamilies : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("catalogue/wild-fields.toml", wild_fields);
    folder.write("catalogue/wild-blocks.toml", replaced(wild_blocks, "v.nrrd\"", "v.nrrd\", sha256 = \"" + sum + "\""));
    folder.write("data/wild-blocks/v.nrrd", volume);
  }
  static std::string ramp_nrrd() {
    std::vector<float> samples;
    for (int n = 0; n < 12 * 12 * 12; ++n) samples.push_back(static_cast<float>(n % 12 + 2 * (n / 12 % 12)));
    return "NRRD0001\ntype: float\ndimension: 3\nsizes: 12 12 12\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n" +
           bytes_of_samples<float>(samples);
  }

  TestFolder folder;
  std::string volume = ramp_nrrd();
  std::string sum = sha256_of_text(volume);
  TestVariable catalogue{"ISOBENCH_CATALOGUE", (folder.path() / "catalogue").string()};
  TestVariable data{"ISOBENCH_DATA", (folder.path() / "data").string()};
};

TEST_F(CatalogueOfFamilies, MembersAreDatasets) {
  const auto names = dataset_names();
  const auto first = std::find(names.begin(), names.end(), "wild-fields-001");
  ASSERT_NE(first, names.end());
  EXPECT_EQ(*(first + 119), "wild-fields-120");
  EXPECT_NE(std::find(names.begin(), names.end(), "wild-blocks-6"), names.end());
  EXPECT_EQ(std::find(names.begin(), names.end(), "wild-fields"), names.end());
  EXPECT_EQ(dataset_family("wild-fields-017"), "wild-fields");
  EXPECT_EQ(dataset_family("wild-blocks-2"), "scans");
  EXPECT_EQ(dataset_family("torus"), "");
}

TEST_F(CatalogueOfFamilies, AGeneratedMemberLoads) {
  Monitor monitor;
  const Dataset dataset = load_dataset("wild-fields-002", monitor);
  EXPECT_EQ(dataset.name, "wild-fields-002");
  EXPECT_EQ(dataset.source, "generated");
  EXPECT_EQ(dataset.checksum, dataset_checksum("wild-fields-002"));
  EXPECT_NE(dataset.checksum, dataset_checksum("wild-fields-003"));
  ASSERT_EQ(dataset.preparation.size(), 1U);
  EXPECT_TRUE(dataset.preparation[0].starts_with("generate random-field")) << dataset.preparation[0];
  EXPECT_FALSE(dataset.topology->is_open);
  EXPECT_FALSE(dataset.topology->components.empty());
  EXPECT_TRUE(fetch_dataset("wild-fields-002", monitor).empty());
}

TEST_F(CatalogueOfFamilies, MembersShareTheFilesOfTheirManifest) {
  Monitor monitor;
  const Dataset first = load_dataset("wild-blocks-1", monitor);
  const Dataset second = load_dataset("wild-blocks-2", monitor);
  EXPECT_EQ(first.surface->lattice().size, (std::array<int, 3>{14, 14, 14}));
  EXPECT_EQ(first.surface->lattice().origin, Eigen::Vector3d(-3.0, -3.0, -3.0));
  EXPECT_EQ(second.surface->lattice().origin, Eigen::Vector3d(1.0, 1.0, 1.0));
  EXPECT_EQ(fetch_dataset("wild-blocks-2", monitor), std::vector{folder.path() / "data/wild-blocks/v.nrrd"});
}

TEST_F(CatalogueOfFamilies, AFamilyMayTakeTheFilesOfAnotherManifestOfTheCatalogue) {
  folder.write("catalogue/more/ramp.toml",
               "title = \"Ramp\"\nlicence = \"L\"\nisovalue = 16\nprepare = [ { step = \"close-border\" } "
               "]\n[data]\nfolder = \"wild-blocks\"\n"
               "files = [ { name = \"v.nrrd\", sha256 = \"" +
                   sum + "\" } ]\n");
  const std::string borrowing = replaced(wild_blocks, "files = [ { name = \"v.nrrd\" } ]", "of = \"ramp\"");
  folder.write("catalogue/wild-blocks.toml", borrowing);
  Monitor monitor;
  EXPECT_EQ(load_dataset("wild-blocks-1", monitor).surface->lattice().size, (std::array<int, 3>{14, 14, 14}));
  EXPECT_EQ(load_dataset("ramp", monitor).surface->lattice().size, (std::array<int, 3>{18, 15, 18}));
  folder.write("catalogue/wild-blocks.toml", replaced(borrowing, "\"ramp\"", "\"rampe\""));
  const std::string message = message_of([] { dataset_checksum("wild-blocks-1"); });
  EXPECT_NE(message.find("wild-blocks.toml:4:6: unknown manifest 'rampe'; did you mean 'ramp'?"), std::string::npos)
      << message;
}

TEST_F(CatalogueOfFamilies, AnUnknownMemberIsAnsweredWithTheRange) {
  for (const char* name : {"wild-fields-121", "wild-fields-17", "wild-fields-000", "wild-fields-x"}) {
    const std::string message = message_of([&] { dataset_checksum(name, {"config.toml", 7, 3}); });
    EXPECT_EQ(message, fmt::format("config.toml:7:3: the family 'wild-fields' has no member '{}'; it has "
                                   "wild-fields-001 … -120",
                                   name));
  }
  EXPECT_NE(message_of([] { dataset_checksum("wild-fields"); }).find("is a family of data sets; give one of"),
            std::string::npos);
  EXPECT_NE(message_of([] { dataset_checksum("wild-feilds-017"); }).find("did you mean 'wild-fields-017'?"),
            std::string::npos);
  const std::string far = message_of([] { dataset_checksum("qqqqqqqqqqqq"); });
  EXPECT_NE(far.find("wild-fields-001 … -120"), std::string::npos) << far;
  EXPECT_EQ(far.find("wild-fields-002"), std::string::npos) << far;
}

TEST_F(CatalogueOfFamilies, AFamilyIsOneLineOfTheList) {
  int lines = 0;
  for (const DatasetInfo& info : list_datasets()) {
    if (info.members.empty()) continue;
    ++lines;
    if (info.name != "wild-fields") continue;
    EXPECT_EQ(info.members, "wild-fields-001 … -120");
    EXPECT_EQ(info.first, "wild-fields-001");
    EXPECT_EQ(info.title, "Fields");
    EXPECT_EQ(info.source, "generated, random-field");
  }
  EXPECT_GE(lines, 2);
}

TEST_F(CatalogueOfFamilies, GlobsMatchMembers) {
  const auto names = dataset_names();
  EXPECT_EQ(matching("wild-fields-*5", names).size(), 12U);
  EXPECT_EQ(matching("wild-fields-0[12]7", names), (std::vector<std::string>{"wild-fields-017", "wild-fields-027"}));
  EXPECT_EQ(matching("tor?s", names), std::vector<std::string>{"torus"});
  EXPECT_TRUE(matching("nothing-*", names).empty());
  EXPECT_TRUE(is_glob("wild-*") && is_glob("tor?s") && is_glob("[ab]"));
  EXPECT_FALSE(is_glob("torus") || is_glob("a[1]/own.toml"));
}

}  // namespace
}  // namespace isobench
