#include "isobench/reports/page/page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/page/html.h"
#include "isobench/reports/page/test_html.h"
#include "isobench/reports/plots/plots.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/report.h"
#include "isobench/reports/tables/best_methods.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {
namespace {

// Two methods on two data sets; one run timed out.
Results results_for_page() {
  Results results;
  results.name = "test";
  results.title = "A <test> & more";
  results.records = {sample_record("pelvis", "ours"), sample_record("pelvis", "theirs"), sample_record("skull", "ours"),
                     sample_record("skull", "theirs")};
  results.records[1].measurement->set("radius_ratio_min", 0.5);
  results.records[3].status = Status::timeout;
  results.records[3].reason = "not finished after 20 minutes";
  results.records[3].measurement.reset();
  results.published = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  return results;
}

// Looks for what a browser fetches by itself: an address in src, or in the href of a link element.
bool asks_a_network(const std::string& page) {
  for (const std::string& attribute : {std::string("src=\""), std::string("<link rel=\"icon\" href=\"")}) {
    for (std::size_t at = page.find(attribute); at != std::string::npos; at = page.find(attribute, at + 1)) {
      if (page.compare(at + attribute.size(), 5, "data:") != 0) return true;
    }
  }
  return page.find("@import") != std::string::npos || page.find("url(") != std::string::npos;
}

TEST(Page, IsWholeAndAsksNoNetwork) {
  const TestFolder folder;
  const std::string text = page(results_for_page(), {}, folder.path());
  EXPECT_EQ(first_unbalanced(text), "");
  EXPECT_FALSE(asks_a_network(text));
  EXPECT_NE(text.find("<h1>A &lt;test&gt; &amp; more</h1>"), std::string::npos);
}

TEST(Page, HoldsEveryTableWithWhatItSortsBy) {
  const TestFolder folder;
  const Results results = results_for_page();
  const std::string text = page(results, {}, folder.path());
  for (const Table& table : all_tables(results)) {
    EXPECT_NE(text.find("<h3>" + html_escaped(table.title) + "</h3>"), std::string::npos) << table.title;
  }
  EXPECT_NE(text.find("data-sort=\"0.30000000000000004\">0.300 / 0.945</td>"), std::string::npos);
  EXPECT_NE(text.find("<span class=\"published\">published 0.40 / 0.92</span>"), std::string::npos);
}

TEST(Page, SaysInWordsWhatWasComparedAndWhatHeld) {
  const std::string text = summary_html(results_for_page());
  EXPECT_NE(
      text.find("Compared: 2 methods (ours, theirs) on 2 data sets (pelvis, skull), with the sizing ε 0.5, δ 0.3."),
      std::string::npos);
  EXPECT_NE(text.find("Matched: nothing."), std::string::npos);
  EXPECT_NE(text.find("Runs: 4 planned, 3 ok, 1 timeout."), std::string::npos);
  EXPECT_NE(text.find("Claims of Meyer, Kirby, Whitaker 2007: "), std::string::npos);
  EXPECT_NE(text.find("Worst triangle (radius ratio): ours on 1, theirs on 1 of 2 data sets."), std::string::npos);
  Results better = results_for_page();
  for (RunRecord& record : better.records) {
    if (record.request.label == "ours" && record.measurement) record.measurement->set("radius_ratio_min", 0.99);
  }
  EXPECT_NE(summary_html(better).find("Worst triangle (radius ratio): ours on all 2 data sets."), std::string::npos);
}

TEST(Page, NamesTheBestWithItsFlaws) {
  Results results = results_for_page();
  results.records[1].measurement->set("boundary_edges", 2);
  const RunGrid runs = arrange_runs(results);
  const Question& worst = questions().front();
  ASSERT_EQ(worst.figure, "radius_ratio_min");
  EXPECT_EQ(best(worst, runs, "pelvis").text, "theirs †: 0.500");
  EXPECT_EQ(best(worst, runs, "skull").names, (std::vector<std::string>{"ours"}));
  // Values that print alike count as equal.
  results.records[1].measurement->set("radius_ratio_min",
                                      results.records[0].measurement->number("radius_ratio_min") * 1.000001);
  EXPECT_EQ(best(worst, arrange_runs(results), "pelvis").names.size(), 2U);
}

TEST(Page, ShowsFailuresAndWhatIsNotDone) {
  Results results = results_for_page();
  EXPECT_NE(gaps_html(results).find("not finished after 20 minutes"), std::string::npos);
  const TestFolder folder;
  EXPECT_EQ(page(results, {}, folder.path()).find("Half-finished"), std::string::npos);
  results.missing.push_back(results.records.back().request);
  results.records.pop_back();
  EXPECT_NE(gaps_html(results).find("not done yet"), std::string::npos);
  EXPECT_NE(page(results, {}, folder.path()).find("Half-finished: 1 of 4 runs"), std::string::npos);
  results.records.clear();
  EXPECT_NE(page(results, {}, folder.path()).find("No run is finished yet."), std::string::npos);
}

TEST(Page, StaysAPageForVeryManyRuns) {
  Results results = results_for_page();
  const std::size_t usual = page(results, {}, TestFolder().path()).size();
  RunRecord failed = results_for_page().records.back();
  for (std::uint64_t seed = 2; seed < 4000; ++seed) {
    results.records.push_back(seed % 2 == 0 ? results.records.front() : failed);
    results.records.back().request.seed = seed;
  }
  const std::string text = page(results, {}, TestFolder().path());
  EXPECT_EQ(count_of(text, "<details class=\"run\">"), 200U);
  EXPECT_NE(text.find("3802 further runs are too many to be listed here"), std::string::npos);
  EXPECT_NE(text.find("more runs that failed or were skipped."), std::string::npos);
  EXPECT_LT(text.size(), usual + 700000);  // a thousand rows for failed runs, two hundred folds
}

TEST(Page, PutsEveryClaimUnderItsVerdict) {
  const Results results = results_for_page();
  const std::string text = claims_html(results);
  EXPECT_EQ(count_of(text, "<details class=\"claim\">"), results.published->claims.size());
  EXPECT_GE(count_of(text, "class=\"badge"), results.published->claims.size());
}

TEST(Page, FoldsTheProvenanceOfEachRun) {
  const Results results = results_for_page();
  const std::string text = provenance_html(results);
  EXPECT_EQ(count_of(text, "<details class=\"run\">"), results.records.size());
  EXPECT_NE(text.find("start = grid, fine, sweeps = 60"), std::string::npos);
  EXPECT_NE(text.find("commit abcdef"), std::string::npos);
  EXPECT_EQ(count_of(text, "mesh.vtp"), 2 * 3U);  // the run that timed out has no mesh
}

TEST(Page, CitesDataWithLicenceAndAcknowledgement) {
  const std::string text = citations_html(results_for_page());
  EXPECT_NE(text.find("CT scanner data courtesy of North Carolina Memorial Hospital"), std::string::npos);
  EXPECT_NE(text.find("Licence: free to redistribute with acknowledgement"), std::string::npos);
  EXPECT_NE(text.find("IEEE Transactions on Visualization and Computer Graphics"), std::string::npos);
}

TEST(Page, PutsFiguresUnderTheirNumbers) {
  const TestFolder folder;
  Exhibits exhibits;
  for (const char* shot : {shots::whole, shots::closer, shots::worst}) {
    for (const char* method : {"theirs", "particles"}) {
      const std::string name = std::string("pictures/") + method + shot;
      folder.write(name + ".jpg", name);
      exhibits.pictures.push_back({name + ".png", name + ".jpg", "pelvis", "", shot, false, "pelvis", method, "", ""});
    }
  }
  Plot plot;
  plot.name = "radius-ratio-pelvis";
  plot.kind = "radius-ratio";
  folder.write("plots/radius-ratio-pelvis.svg", "<svg/>");
  exhibits.plots = {plot};
  exhibits.drawn = {plot.name};
  const std::string text = page(results_for_page(), exhibits, folder.path());
  EXPECT_EQ(first_unbalanced(text), "");
  EXPECT_EQ(count_of(text, "<h3 id=\"figure-"), 9U);
  EXPECT_EQ(count_of(text, "alt=\"pelvis: particles\""), 3U + 2U);  // Figure 6 shows the whole and a closer view
  EXPECT_EQ(count_of(text, "alt=\"pelvis: theirs\""), 3U);
  EXPECT_EQ(count_of(text, "plots/radius-ratio-pelvis.svg"), 1U);  // under Figure 5 and nowhere else
  EXPECT_LT(text.find("figure-5"), text.find("plots/radius-ratio-pelvis.svg"));
  EXPECT_LT(text.find("plots/radius-ratio-pelvis.svg"), text.find("figure-6"));
  EXPECT_NE(text.find("It needs a finished run of vessel"), std::string::npos);
}

TEST(Page, OfManyRunsStaysUsable) {
  const TestFolder folder;
  Results results;
  for (int n = 0; n < 2000; ++n) {
    results.records.push_back(sample_record("pelvis", "ours", fmt::format("ours {}", n)));
    results.missing.push_back(sample_record("skull", "ours", fmt::format("ours {}", n)).request);
  }
  const std::string text = page(results, {}, folder.path());
  EXPECT_EQ(first_unbalanced(text), "");
  EXPECT_LT(text.size(), 12000000U);
  EXPECT_EQ(count_of(text, "<details class=\"run\">"), 200U);
  EXPECT_NE(text.find("1800 further runs"), std::string::npos);
  EXPECT_NE(text.find("And 1800 more runs that are not done yet."), std::string::npos);
  EXPECT_NE(text.find("and 1988 more"), std::string::npos);
  EXPECT_NE(text.find("<summary>2000 rows</summary>"), std::string::npos);
  for (const Plot& plot : all_plots(results)) {
    EXPECT_LE(plot.marks == Marks::stack ? plot.categories.size() : plot.series.size(), 24U) << plot.name;
  }
}

TEST(Page, LeavesRunsForAFigureOutOfTheTables) {
  Results results = results_for_page();
  for (const double epsilon : {1.0, 0.5}) {
    for (const double delta : {0.6, 0.3}) {
      RunRecord record = sample_record("box", "ours", "unfinished");
      record.request.sizing.epsilon = epsilon;
      record.request.sizing.delta = delta;
      record.request.aside = true;
      results.records.push_back(record);
    }
  }
  for (const Table& table : all_tables(results)) {
    const bool grid = table.title.starts_with("Grid of ε");
    EXPECT_EQ(html(table).find("unfinished") != std::string::npos, grid) << table.title;
  }
  EXPECT_NE(summary_html(results).find("Not compared: 4 runs, made for single figures and claims."), std::string::npos);
}

TEST(Page, EscapesWhatOthersWrote) {
  Results results = results_for_page();
  results.records[3].reason = "<script>alert(1)</script>";
  results.records[0].notes = {"</details><b>"};
  const TestFolder folder;
  const std::string text = page(results, {}, folder.path());
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  EXPECT_EQ(first_unbalanced(text), "");
}

TEST(Html, EncodesBytes) {
  EXPECT_EQ(data_uri("text/plain", "Man"), "data:text/plain;base64,TWFu");
  EXPECT_EQ(data_uri("text/plain", "M"), "data:text/plain;base64,TQ==");
  EXPECT_EQ(data_uri("text/plain", ""), "data:text/plain;base64,");
  EXPECT_EQ(html_prose("a `b<c` d"), "a <code>b&lt;c</code> d");
}

// A results folder as a run leaves it, without meshes.
std::filesystem::path stored(const TestFolder& folder) {
  std::vector<RunRequest> plan;
  for (const RunRecord& record : results_for_page().records) {
    plan.push_back(record.request);
    std::filesystem::create_directories(folder.path() / record.request.run);
    write_record(record, folder.path() / record.request.run / "run.json");
  }
  write_text(folder.path() / "plan.json", plan_to_json(plan));
  return folder.path();
}

TEST(Report, MadeAgainChangesNoByte) {
  const TestFolder folder;
  const std::filesystem::path path = stored(folder);
  const Report first = write_report(path);
  EXPECT_EQ(first.written.back(), "report.html");
  const std::string before = read_text(path / "report.html");
  write_report(path);
  EXPECT_EQ(read_text(path / "report.html"), before);
}

TEST(Report, OfTablesAloneHasNoPage) {
  const TestFolder folder;
  const Report report = write_report(stored(folder), ReportParts::tables);
  EXPECT_EQ(report.written.back(), "results.csv");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html"));
}

TEST(Page, NotesStandUnderTheWordsOfACellAndWideTablesAreDense) {
  Table table;
  table.label_columns = 1;
  table.header = {"Method", "passed"};
  table.rows = {{"ours", "9 of 9"}};
  table.rows.front()[1].note = "70–100 %";
  EXPECT_NE(html(table).find("<td class=\"noted\">9 of 9<span class=\"note\">70–100 %</span></td>"), std::string::npos)
      << html(table);
  EXPECT_NE(html(table).find("<table class=\"sortable\">"), std::string::npos);
  EXPECT_NE(markdown(table).find("9 of 9 (70–100 %)"), std::string::npos);
  table.header.resize(14);
  EXPECT_NE(html(table).find("<table class=\"sortable dense\">"), std::string::npos);
}

}  // namespace
}  // namespace isobench
