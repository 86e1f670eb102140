#include "isobench/foundation/toml.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

const char* const kExperiment = R"(title = "Four data sets"
dataset = ["brain", 'skull']
seed = 1
exact = true
[sampling]
epsilon = 0.5
delta = 1
beyond = inf
[[method]]
name = "particles"
[[method]]
name = "marching-cubes"
options = { z = 1, a = 2 }
)";

TomlValue experiment() { return TomlValue::parse_text(kExperiment, "experiments/four.toml"); }

std::string usage_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Toml, ReadsEveryType) {
  const TomlValue root = experiment();
  EXPECT_EQ(root.require("title").as_string(), "Four data sets");
  EXPECT_EQ(root.require("seed").as_integer(), 1);
  EXPECT_TRUE(root.require("exact").as_bool());
  EXPECT_DOUBLE_EQ(root.require("sampling").require("epsilon").as_number(), 0.5);
  EXPECT_TRUE(std::isinf(root.require("sampling").require("beyond").as_number()));
  const std::vector<TomlValue> datasets = root.require("dataset").as_array();
  ASSERT_EQ(datasets.size(), 2U);
  EXPECT_EQ(datasets[1].as_string(), "skull");
  EXPECT_EQ(root.require("method").as_array().at(1).require("name").as_string(), "marching-cubes");
}

TEST(Toml, AnIntegerIsANumberToo) {
  const TomlValue delta = experiment().require("sampling").require("delta");
  EXPECT_TRUE(delta.is_number());
  EXPECT_DOUBLE_EQ(delta.as_number(), 1.0);
  EXPECT_EQ(delta.type_name(), "integer");
}

TEST(Toml, ALoneValueIsAListOfOne) {
  EXPECT_EQ(experiment().require("seed").as_list().size(), 1U);
  EXPECT_EQ(experiment().require("dataset").as_list().size(), 2U);
}

TEST(Toml, KeysKeepTheOrderOfTheFile) {
  EXPECT_EQ(experiment().keys(), (std::vector<std::string>{"title", "dataset", "seed", "exact", "sampling", "method"}));
  const TomlValue options = experiment().require("method").as_array().at(1).require("options");
  EXPECT_EQ(options.keys(), (std::vector<std::string>{"z", "a"}));
}

TEST(Toml, AValueOutlivesTheHandleItCameFrom) {
  TomlValue name = experiment().require("method").as_array().at(0).require("name");
  EXPECT_EQ(name.as_string(), "particles");
}

TEST(Toml, KnowsWhereAValueStands) {
  const Place place = experiment().require("sampling").require("epsilon").place();
  EXPECT_EQ(place.file, "experiments/four.toml");
  EXPECT_EQ(place.line, 6);
  EXPECT_EQ(place.column, 11);
}

TEST(Toml, FindTellsAnAbsentKey) {
  EXPECT_FALSE(experiment().find("absent").has_value());
  EXPECT_TRUE(experiment().find("seed").has_value());
}

TEST(TomlErrors, NameTheKeyAndBothTypes) {
  const TomlValue root = experiment();
  EXPECT_EQ(usage_error([&] { root.require("title").as_number(); }),
            "experiments/four.toml:1:9: 'title' must be a number, not a string");
  EXPECT_EQ(usage_error([&] { root.require("sampling").require("epsilon").as_integer(); }),
            "experiments/four.toml:6:11: 'epsilon' must be an integer, not a number");
  EXPECT_EQ(usage_error([&] { root.require("dataset").as_string(); }),
            "experiments/four.toml:2:11: 'dataset' must be a string, not an array");
  EXPECT_EQ(usage_error([&] { root.require("seed").as_bool(); }),
            "experiments/four.toml:3:8: 'seed' must be a boolean, not an integer");
  EXPECT_EQ(usage_error([&] { root.require("seed").as_array(); }),
            "experiments/four.toml:3:8: 'seed' must be an array, not an integer");
  EXPECT_EQ(usage_error([&] { root.require("seed").keys(); }),
            "experiments/four.toml:3:8: 'seed' must be a table, not an integer");
  EXPECT_EQ(usage_error([&] { root.require("seed").find("x"); }),
            "experiments/four.toml:3:8: 'seed' must be a table, not an integer");
}

TEST(TomlErrors, NotANumberIsNone) {
  const TomlValue root = TomlValue::parse_text("epsilon = nan\n", "a.toml");
  EXPECT_EQ(usage_error([&] { root.require("epsilon").as_number(); }),
            "a.toml:1:11: 'epsilon' must be a number, not nan");
}

TEST(TomlErrors, AMissingKeyIsReportedAtItsTable) {
  EXPECT_EQ(usage_error([] { experiment().require("sampling").require("floor"); }),
            "experiments/four.toml:5:1: the key 'floor' is missing in 'sampling'");
  EXPECT_EQ(usage_error([] { experiment().require("limits"); }),
            "experiments/four.toml:1:1: the key 'limits' is missing");
}

TEST(TomlErrors, AnUnknownKeyIsReportedWithTheNearestOne) {
  const TomlValue sampling = experiment().require("sampling");
  EXPECT_NO_THROW(sampling.allow_keys({"epsilon", "delta", "beyond"}, "[sampling]"));
  EXPECT_EQ(usage_error([&] {
              sampling.allow_keys({"epsilom", "delta", "beyond"}, "[sampling]");
            }),
            "experiments/four.toml:6:1: unknown key 'epsilon' in [sampling]; did you mean 'epsilom'?");
}

TEST(TomlErrors, ASyntaxErrorHasItsPlace) {
  const std::string message = usage_error([] { TomlValue::parse_text("a = 1\nb = = 2\n", "broken.toml"); });
  EXPECT_TRUE(message.starts_with("broken.toml:2:5: ")) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(usage_error([] { TomlValue::parse_text("a = 1\na = 2\n", "twice.toml"); }).starts_with("twice.toml:2:"));
}

class TomlFiles : public testing::Test {
 protected:
  TestFolder test_folder_;
  std::filesystem::path folder_ = test_folder_.path();
};

TEST_F(TomlFiles, KeepThePathAsGiven) {
  const std::filesystem::path path = folder_ / ".." / folder_.filename() / "a.toml";
  std::ofstream(path) << "seed = 3\n";
  const TomlValue root = TomlValue::parse_file(path);
  EXPECT_EQ(root.require("seed").as_integer(), 3);
  EXPECT_EQ(root.place().file, path.string());
}

TEST_F(TomlFiles, ThatAreMissingOrFoldersAreUsageErrors) {
  const std::filesystem::path missing = folder_ / "none.toml";
  EXPECT_EQ(usage_error([&] { TomlValue::parse_file(missing); }),
            missing.string() + ": cannot be read; give the path of a TOML file");
  EXPECT_EQ(usage_error([&] { TomlValue::parse_file(folder_); }),
            folder_.string() + ": cannot be read; give the path of a TOML file");
}

TEST_F(TomlFiles, ThatAreNoTextAreUsageErrors) {
  const std::filesystem::path path = folder_ / "binary.toml";
  std::ofstream(path, std::ios::binary) << "\x89PNG\r\n\xff\xfe";
  EXPECT_TRUE(usage_error([&] { TomlValue::parse_file(path); }).starts_with(path.string() + ":1:"));
}

TEST(Toml, AnIntegerThatNoDoubleIsExactlyIsStillANumber) {
  const TomlValue document = TomlValue::parse_text("a = 9007199254740993\nb = -9223372036854775807\n", "x.toml");
  EXPECT_EQ(document.require("a").as_number(), 9007199254740992.0);
  EXPECT_EQ(document.require("b").as_number(), -9223372036854775808.0);
}

TEST(Toml, ACopyMayHaveOtherValuesAndNamesTheirPlaces) {
  const TomlValue original = experiment();
  const TomlValue sampling = original.require("sampling");
  const TomlValue other = TomlValue::parse_text("\n\nlist = [0.75, \"much\"]", "other.toml").require("list");
  const TomlValue changed =
      original.with("sampling", sampling.with("epsilon", other.as_array()[0]).with("floor", other.as_array()[1]));
  EXPECT_EQ(changed.require("sampling").require("epsilon").as_number(), 0.75);
  EXPECT_EQ(changed.require("sampling").require("delta").as_number(), 1.0);
  EXPECT_EQ(original.require("sampling").require("epsilon").as_number(), 0.5);
  EXPECT_EQ(changed.require("sampling").keys(), (std::vector<std::string>{"epsilon", "delta", "beyond", "floor"}));
  EXPECT_NE(usage_error([&] {
              changed.require("sampling").require("floor").as_number();
            }).find("other.toml:3:15: 'floor' must be a number"),
            std::string::npos);
  EXPECT_NE(usage_error([&] {
              changed.require("sampling").allow_keys({"epsilon", "delta", "beyond"}, "[sampling]");
            }).find("other.toml:3:15: unknown key 'floor'"),
            std::string::npos);
  EXPECT_EQ(original.require("dataset").with_elements({other.as_array()[1]}).as_array()[0].as_string(), "much");
  EXPECT_EQ(usage_error([&] { other.with("x", other); }).find("other.toml:3:8: 'list' must be a table"), 0U);
}

}  // namespace
}  // namespace isobench
