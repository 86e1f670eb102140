#include "isobench/reports/published/published.h"

#include <gtest/gtest.h>

#include <fstream>

#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

std::filesystem::path write(const std::string& text) {
  static const TestFolder folder;  // of this process: tests run side by side
  return folder.write("published.toml", text);
}

const char* const small = R"(source = "Somebody 1999"
[[method]]
printed = "xx"
name = "particles-2007"
beside = ["particles"]
[[quantity]]
name = "radius_ratio_min"
[[quantity]]
name = "share"
unit = "%"
[[figures]]
table = "Table 2"
method = "xx"
dataset = "skull"
radius_ratio_min = "0.40"
share = "< 0.004"
)";

TEST(Published, KeepsWhatWasPrinted) {
  const Published published = read_published(write(small));
  const PublishedFigure* figure = published.find("radius_ratio_min", "skull", "particles-2007");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->printed, "0.40");
  EXPECT_EQ(figure->value, 0.4);
  EXPECT_EQ(figure->decimals, 2);
  EXPECT_EQ(published.find("radius_ratio_min", "skull", "particles"), figure);  // shown beside ours, too
  EXPECT_EQ(published.find("radius_ratio_min", "skull", "marching-cubes"), nullptr);
  EXPECT_EQ(published.find("radius_ratio_min", "brain", "particles"), nullptr);
  const PublishedFigure* bound = published.find("share", "skull", "particles");
  ASSERT_NE(bound, nullptr);
  EXPECT_TRUE(bound->bound);
  EXPECT_EQ(bound->value, 0.004);
}

TEST(Published, MistakesHaveTheirPlace) {
  const auto mistake = [](const std::string& what, const std::string& with) -> std::string {
    std::string text = small;
    text.replace(text.find(what), what.size(), with);
    try {
      read_published(write(text));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(mistake("method = \"xx\"", "method = \"xy\"").find("published.toml:13:"), std::string::npos);
  EXPECT_NE(mistake("share = \"<", "shore = \"<").find("'share'"), std::string::npos);
  // A number would lose its last digit, so it must be a string.
  EXPECT_NE(mistake("\"0.40\"", "0.40").find("published.toml:15:"), std::string::npos);
}

TEST(Published, FiguresHaveNumbersAndShowWhatIsKnown) {
  const Published paper = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  ASSERT_EQ(paper.plates.size(), 9U);
  for (std::size_t n = 0; n < 9; ++n) EXPECT_EQ(paper.plates[n].number, static_cast<int>(n + 1));
  const TestFolder folder;
  const auto mistake = [&folder](const std::string& plate) -> std::string {
    try {
      read_published(folder.write("published.toml", "source = \"x\"\n[[plate]]\n" + plate));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(mistake("number = 6\nshows = \"mesh\"\ncaption = \"x\"\n"), "");
  EXPECT_NE(mistake("number = 6\nshows = \"mash\"\ncaption = \"x\"\n").find("'mesh'"), std::string::npos);
  EXPECT_NE(mistake("number = 0\nshows = \"mesh\"\ncaption = \"x\"\n").find("published.toml:3:"), std::string::npos);
}

TEST(Published, ThePapersFiguresAreAllThere) {
  const Published paper = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  const auto value = [&paper](const char* quantity, const char* dataset, const char* method) {
    const PublishedFigure* figure = paper.find(quantity, dataset, method);
    return figure == nullptr ? -1.0 : figure->value.value_or(-2.0);
  };
  EXPECT_EQ(value("vertices", "vessel", "particles-2007"), 287990);
  EXPECT_EQ(value("triangles", "pelvis", "particles"), 9984);
  EXPECT_EQ(value("minutes", "skull", "particles"), 232);
  EXPECT_EQ(value("radius_ratio_min", "vessel", "particles-2007"), 0.0195);
  EXPECT_EQ(value("radius_ratio_avg", "brain", "advancing-front"), 0.93);
  EXPECT_EQ(value("radius_ratio_min", "skull", "marching-cubes"), 0.0);
  EXPECT_EQ(value("valence_6_percent", "average", "marching-cubes"), 44.15);
  EXPECT_EQ(value("valence_extreme_percent", "average", "advancing-front"), 0.95);
  EXPECT_EQ(paper.find("radius_ratio_min", "skull", "marching-cubes")->printed, "0.000");
  for (const char* dataset : {"brain", "pelvis", "skull", "vessel"}) {
    for (const char* quantity : {"volume_size", "epsilon", "delta", "minutes", "vertices", "triangles",
                                 "radius_ratio_min", "radius_ratio_avg", "edge_over_own_h0_exceed_triangle_percent"}) {
      EXPECT_NE(paper.find(quantity, dataset, "particles-2007"), nullptr) << dataset << " " << quantity;
    }
  }
}

}  // namespace
}  // namespace isobench
