// What the page opens with, and the page of many data sets.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/page/test_html.h"
#include "isobench/reports/survey/sample_survey.h"

namespace isobench {
namespace {

// Two methods on two data sets; one run timed out.
Results two_methods() {
  Results results;
  results.title = "Two methods";
  results.records = {sample_record("pelvis", "ours"), sample_record("pelvis", "theirs"), sample_record("skull", "ours"),
                     sample_record("skull", "theirs")};
  results.records[1].measurement->set("radius_ratio_min", 0.5);
  results.records[3].status = Status::timeout;
  results.records[3].measurement.reset();
  return results;
}

// Exhibits with a close-up and a worst triangle for these methods on a data set.
Exhibits pictures_of(const TestFolder& folder, const std::string& dataset, const std::vector<std::string>& methods) {
  Exhibits exhibits;
  for (const std::string& method : methods) {
    for (const char* shot : {shots::closer, shots::worst}) {
      const std::string run = fmt::format("{}-{}", dataset, method);
      const std::string name = fmt::format("pictures/{}-{}", run, shot);
      folder.write(name + ".jpg", name);
      exhibits.pictures.push_back({name + ".png", name + ".jpg", dataset, run, shot, false, dataset, method, "", ""});
    }
  }
  return exhibits;
}

TEST(Page, OpensWithTheBestMethodsAndTheirCloseUps) {
  const TestFolder folder;
  const std::string text = page(two_methods(), pictures_of(folder, "pelvis", {"ours", "theirs"}), folder.path());
  EXPECT_EQ(first_unbalanced(text), "");
  const std::size_t line = text.find("<p class=\"lead\">Best on the most data sets – ");
  const std::size_t ours = text.find("alt=\"Close-up of ours on pelvis\"");
  const std::size_t theirs = text.find("alt=\"Close-up of theirs on pelvis\"");
  EXPECT_LT(text.find("<h1>"), line);
  EXPECT_LT(line, ours);
  EXPECT_LT(ours, theirs);
  EXPECT_LT(theirs, text.find("<nav>"));
  EXPECT_LT(theirs, text.find("<section id=\"summary\">"));
  EXPECT_NE(text.find("<b>theirs</b> 2000 triangles, smallest radius ratio 0.500, angles 0.0–0.0°"), std::string::npos);
}

TEST(Page, OpensWithTheWorstOfASingleMethod) {
  Results results = two_methods();
  std::erase_if(results.records, [](const RunRecord& record) { return record.request.label == "theirs"; });
  EXPECT_NE(opening_html(results, {}, {}).find("Worst of all meshes of ours: Smallest radius ratio 0.300 (pelvis)"),
            std::string::npos);
}

TEST(Page, OfManyDataSetsShowsTheOverviewFirstAndFoldsTheRest) {
  const TestFolder folder;
  Results results = sample_survey::results(400);
  results.records[3 * 17].measurement->set("radius_ratio_min", 0.31);
  Exhibits exhibits = pictures_of(folder, sample_survey::dataset(1), {"good", "fast", "slow"});
  for (Picture& picture : pictures_of(folder, sample_survey::dataset(17), {"good"}).pictures)
    exhibits.pictures.push_back(picture);
  const std::string text = page(results, exhibits, folder.path());
  EXPECT_EQ(first_unbalanced(text), "");
  EXPECT_LT(text.size(), 3000000U);
  EXPECT_EQ(count_of(text, "alt=\"Close-up of "), 3U);
  EXPECT_NE(text.find("alt=\"Close-up of good on " + sample_survey::dataset(1)), std::string::npos);
  EXPECT_NE(text.find("<p class=\"lead\">Sound meshes (closed manifold, "), std::string::npos);
  EXPECT_NE(text.find("<b>good</b> " + sample_survey::dataset(17) + ": radius ratio 0.310"), std::string::npos);
  std::size_t last = 0;
  for (const char* part :
       {"<section id=\"opening\">", "<nav>", "<section id=\"summary\">", "<h3>Reliability</h3>",
        "<h3>Data sets that do not pass</h3>", "<section id=\"worst\">", "<summary>Runs without a mesh</summary>",
        "<summary>Tables of data sets</summary>", "<h3>Each data set</h3>", "<summary>Runs</summary>"}) {
    const std::size_t at = text.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_LT(last, at) << part;
    last = at;
  }
  EXPECT_NE(text.find("The first 300 of 1200 rows. All are in tables.md"), std::string::npos);
  EXPECT_EQ(text.find("The best method for each criterion and data set"), std::string::npos);  // 400 columns
}

}  // namespace
}  // namespace isobench
