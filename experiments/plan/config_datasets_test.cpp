// The datasets of a config: globs, and methods that run on some of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "isobench/experiments/plan/config.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_variable.h"

namespace isobench {
namespace {

/// A catalogue with a family of thirty: noise-01 to noise-30.
class ConfigOfFamilies : public testing::Test {
 protected:
  ConfigOfFamilies() {
    folder.write("catalogue/noise.toml",
                 "title = \"Noise\"\n[generated]\ngenerator = \"random-field\"\nsize = 24\ncorrelation = 2\n"
                 "[family]\nmembers = 30\nquantile = [0.3, 0.5, 0.7]\n");
  }
  Config read(const std::string& text, ConfigVariant variant = ConfigVariant::full) {
    return read_config(folder.write("config.toml", text), variant);
  }
  std::string mistake(const std::string& text, ConfigVariant variant = ConfigVariant::full) {
    try {
      make_plan(read(text, variant));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }
  void expect_mistake(const std::string& text, const std::vector<std::string>& parts,
                      ConfigVariant variant = ConfigVariant::full) {
    const std::string message = mistake(text, variant);
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
  /// The config as a results folder keeps it.
  Config stored(const Config& config) {
    return read_config(folder.write("stored.toml", to_toml(config, "")), ConfigVariant::stored);
  }

  TestFolder folder;
  TestVariable catalogue{"ISOBENCH_CATALOGUE", (folder.path() / "catalogue").string()};
};

const std::string sampling_of_all = "[sampling]\nepsilon = 0.5\ndelta = 0.3\n";
const std::string particles_of_all = "[[method]]\nname = \"particles\"\n";

TEST_F(ConfigOfFamilies, AGlobStandsForAllThatItMatches) {
  const Config config = read("dataset = [\"noise-*\", \"tor?s\"]\n" + sampling_of_all + particles_of_all);
  ASSERT_EQ(config.datasets.size(), 31U);
  EXPECT_EQ(config.datasets.front(), "noise-01");
  EXPECT_EQ(config.datasets[29], "noise-30");
  EXPECT_EQ(config.datasets.back(), "torus");
  std::set<std::string> checksums;
  for (const RunRequest& request : make_plan(config)) {
    checksums.insert(request.dataset_checksum);
    EXPECT_EQ(request.family, request.dataset == "torus" ? "" : "noise") << request.dataset;
  }
  EXPECT_EQ(checksums.size(), 31U);
}

TEST_F(ConfigOfFamilies, AGlobAddsOnlyWhatIsNew) {
  const auto datasets = [&](const std::string& list) {
    return read("dataset = " + list + "\n" + sampling_of_all + particles_of_all).datasets;
  };
  EXPECT_EQ(datasets("[\"noise-03\", \"noise-0[1-4]\", \"noise-04\", \"noise-0[45]\"]"),
            (std::vector<std::string>{"noise-03", "noise-01", "noise-02", "noise-04", "noise-05"}));
  const std::string rest = "\n" + sampling_of_all + particles_of_all;
  expect_mistake("dataset = [\"torus\", \"torus\"]" + rest, {"config.toml:1:", "'torus' is listed twice"});
  expect_mistake("dataset = [\"torus\",\n\"noize-*\"]" + rest, {"config.toml:2:", "no dataset matches 'noize-*'"});
  expect_mistake("dataset = \"noise-31\"" + rest, {"config.toml:1:", "it has noise-01 … -30"});
  expect_mistake("dataset = \"noise\"" + rest, {"config.toml:1:", "is a family", "'noise-*'"});
}

const std::string subset_of_methods =
    "dataset = [\"noise-*\", \"torus\"]\nmatch = \"vertices\"\nmatch_to = \"particles\"\n" + sampling_of_all +
    particles_of_all + "[[method]]\nname = \"marching-cubes\"\ndataset = \"*-*5\"\n";

TEST_F(ConfigOfFamilies, AMethodMayRunOnSomeDatasetsAlone) {
  const std::vector<RunRequest> plan = make_plan(read(subset_of_methods));
  std::map<std::string, std::vector<std::string>> datasets;
  std::map<std::string, std::string> particles;  // the run of each dataset
  for (const RunRequest& request : plan) {
    datasets[request.method].push_back(request.dataset);
    if (request.method == "particles")
      particles[request.dataset] = request.run;
    else
      EXPECT_EQ(request.match_to, particles.at(request.dataset));
  }
  EXPECT_EQ(datasets["particles"].size(), 31U);
  EXPECT_EQ(datasets["marching-cubes"], (std::vector<std::string>{"noise-05", "noise-15", "noise-25"}));
}

TEST_F(ConfigOfFamilies, TheStoredConfigKeepsTheNamesAndGivesTheSamePlan) {
  const Config config = read(subset_of_methods +
                             "[[override]]\ndataset = [\"noise-1*\", \"torus\"]\nsampling = { epsilon = 1 }\n"
                             "[[also]]\ndataset = \"noise-0[12]\"\nsampling = { edge_length = 3 }\n"
                             "method = { name = \"particles\", label = \"aside\", dataset = \"noise-*2\" }\n");
  EXPECT_EQ(config.overrides.at(0).datasets.size(), 11U);
  const std::string text = to_toml(config, "");
  EXPECT_EQ(text.find('*'), std::string::npos) << text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    EXPECT_LE(end - begin, 120U) << text.substr(begin, end - begin);
    begin = end + 1;
  }
  const Config again = stored(config);
  EXPECT_EQ(identity(again), identity(config));
  const std::string plan = plan_to_json(make_plan(config));
  EXPECT_EQ(plan_to_json(make_plan(again)), plan);
  EXPECT_NE(plan.find("noise-02"), std::string::npos);
  // A family that grows later changes nothing in the folder.
  folder.write("catalogue/noise.toml",
               "title = \"Noise\"\n[generated]\ngenerator = \"random-field\"\nsize = 24\ncorrelation = 2\n"
               "[family]\nmembers = 60\nquantile = [0.3, 0.5, 0.7]\n");
  EXPECT_EQ(plan_to_json(make_plan(read_config(folder.path() / "stored.toml", ConfigVariant::stored))), plan);
}

TEST_F(ConfigOfFamilies, WhereAMethodRunsIsPartOfTheIdentity) {
  std::string other = subset_of_methods;
  other.replace(other.find("*-*5"), 4, "*-*6");
  EXPECT_NE(identity(read(other)), identity(read(subset_of_methods)));
}

TEST_F(ConfigOfFamilies, QuickKeepsTheMethodsThatRunOnItsDatasets) {
  const Config both = read(subset_of_methods + "[quick]\ndataset = \"noise-0[56]\"\n", ConfigVariant::quick);
  EXPECT_EQ(both.datasets, (std::vector<std::string>{"noise-05", "noise-06"}));
  ASSERT_EQ(both.methods.size(), 2U);
  EXPECT_EQ(both.methods[1].datasets, std::vector<std::string>{"noise-05"});
  EXPECT_EQ(make_plan(both).size(), 3U);
  EXPECT_EQ(plan_to_json(make_plan(stored(both))), plan_to_json(make_plan(both)));
  const Config one = read(subset_of_methods + "[quick]\ndataset = \"noise-06\"\n", ConfigVariant::quick);
  EXPECT_EQ(one.methods.size(), 1U);
  EXPECT_EQ(make_plan(one).size(), 1U);
}

// What a table says about a dataset of [quick] alone is no part of the full experiment, and not of its folder.
TEST_F(ConfigOfFamilies, TheFullExperimentForgetsTheDatasetsOfQuick) {
  const std::string text =
      "dataset = \"noise-01\"\n" + sampling_of_all + particles_of_all +
      "[[method]]\nname = \"marching-cubes\"\ndataset = \"slab\"\n"
      "[[override]]\ndataset = \"slab\"\nsampling = { epsilon = 1 }\n[quick]\ndataset = \"slab\"\n";
  const Config config = read(text);
  EXPECT_EQ(config.methods.size(), 1U);
  EXPECT_TRUE(config.overrides.empty());
  EXPECT_EQ(identity(stored(config)), identity(config));
  EXPECT_EQ(make_plan(read(text, ConfigVariant::quick)).size(), 2U);
}

TEST_F(ConfigOfFamilies, MistakesInTheDatasetsOfAMethodHaveTheirPlace) {
  const auto with = [](const std::string& list) {
    return "dataset = [\"noise-0*\", \"torus\"]\n" + sampling_of_all +
           "[[method]]\nname = \"particles\"\ndataset = " + list + "\n";
  };
  EXPECT_EQ(mistake(with("[\"torus\", \"noise-01\"]")), "");
  expect_mistake(with("\"torsu\""), {"config.toml:7:", "no dataset 'torsu'", "did you mean 'torus'?"});
  expect_mistake(with("\"noise-1*\""), {"config.toml:7:", "no dataset matches 'noise-1*'"});
  expect_mistake(with("[]"), {"config.toml:7:", "empty list"});
  expect_mistake(with("[\"torus\", \"torus\"]"), {"config.toml:7:", "listed twice"});
  // The method that others are matched to must run wherever they do.
  const std::string match = "match = \"vertices\"\nmatch_to = \"particles\"\n";
  expect_mistake(match + with("\"torus\"") + "[[method]]\nname = \"marching-cubes\"\n",
                 {"config.toml:2:", "'marching-cubes' on noise-01", "'particles' does not run there"});
  EXPECT_EQ(mistake(match + with("\"torus\"") + "[[method]]\nname = \"marching-cubes\"\ndataset = \"torus\"\n"), "");
  const std::string quick = "[quick]\ndataset = \"noise-01\"\n";
  expect_mistake(with("\"torus\"") + quick, {"config.toml:8:", "no method runs on any of these datasets"},
                 ConfigVariant::quick);
  expect_mistake(match + with("\"torus\"") + "[[method]]\nname = \"marching-cubes\"\ndataset = \"noise-01\"\n" + quick,
                 {"config.toml:13:", "match_to names it"}, ConfigVariant::quick);
}

}  // namespace
}  // namespace isobench
