#include "isobench/reports/claims/claims.h"

#include <gtest/gtest.h>

#include <fstream>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/tables/tables.h"
#include "isobench/reports/tables_document.h"

namespace isobench {
namespace {

const std::string claims_head = R"(source = "Somebody 1999"
[[method]]
printed = "ps"
name = "particles-2007"
beside = ["particles"]
[[method]]
printed = "af"
name = "advancing-front"
[[method]]
printed = "mc"
name = "marching-cubes"
[[quantity]]
name = "radius_ratio_min"
[[figures]]
table = "Table 2"
method = "ps"
dataset = "skull"
radius_ratio_min = "0.40"
[[claim]]
words = "It is so."
)";

Published published_with(const std::string& claim) {
  const TestFolder folder;
  return read_published(folder.write("claims.toml", claims_head + claim));
}

// A run with this smallest radius ratio and this percentage of extreme valences.
RunRecord run(const std::string& dataset, const std::string& method, double worst, double extreme = 0.0) {
  RunRecord record = sample_record(dataset, method);
  record.measurement->set("radius_ratio_min", worst);
  record.measurement->set("valence_lt5_percent", extreme / 4.0);
  record.measurement->set("valence_gt7_percent", 3.0 * extreme / 4.0);
  return record;
}

RunRecord unfinished(RunRecord record) {
  record.status = Status::timeout;
  record.measurement.reset();
  return record;
}

ClaimResult judge(const std::string& claim, const std::vector<RunRecord>& records) {
  Results results;
  results.records = records;
  results.published = published_with(claim);
  return evaluate(results.published->claims.front(), results);
}

const std::string trend = "figure = \"radius_ratio_min\"\nmethod = \"ps\"\nsmaller = \"delta\"\ngives = \"larger\"\n";
const std::string order = "figure = \"radius_ratio_min\"\norder = \"ps > af > mc\"\n";

TEST(Claims, AnOrderHoldsOnEachDataSet) {
  const ClaimResult held = judge(order, {run("skull", "particles", 0.3), run("skull", "advancing-front", 0.2),
                                         run("skull", "marching-cubes", 0.1), run("brain", "particles", 0.03),
                                         run("brain", "advancing-front", 0.02), run("brain", "marching-cubes", 0.01)});
  EXPECT_EQ(held.verdict, Verdict::held);
  EXPECT_EQ(held.summary, "held");
  ASSERT_EQ(held.findings.size(), 2U);
  EXPECT_EQ(held.findings[0].ours, "particles 0.300, advancing-front 0.200, marching-cubes 0.100");
  EXPECT_EQ(held.findings[0].published, "ps 0.40");
  EXPECT_EQ(held.findings[1].published, "");
  const ClaimResult broken =
      judge(order, {run("skull", "particles", 0.3), run("skull", "advancing-front", 0.2),
                    run("skull", "marching-cubes", 0.2), run("brain", "particles", 0.03),
                    run("brain", "advancing-front", 0.02), run("brain", "marching-cubes", 0.01)});
  EXPECT_EQ(broken.verdict, Verdict::not_held);
  EXPECT_EQ(broken.summary, "not held on skull");
}

TEST(Claims, WithoutAMethodTheRestOfTheOrderIsTested) {
  const std::vector<RunRecord> records = {run("skull", "particles", 0.3), run("skull", "marching-cubes", 0.1),
                                          run("brain", "particles", 0.3),
                                          unfinished(run("brain", "marching-cubes", 0.1))};
  const ClaimResult result = judge(order, records);
  EXPECT_EQ(result.verdict, Verdict::held);
  EXPECT_EQ(result.findings[1].verdict, Verdict::not_testable);
  EXPECT_EQ(
      result.summary,
      "held as far as it could be tested; not testable on brain (advancing-front was not run; advancing-front was "
      "not run, marching-cubes: timeout)");
  const ClaimResult nothing = judge(order, {records[0]});
  EXPECT_EQ(nothing.summary, "not testable here: advancing-front was not run, marching-cubes was not run");
  EXPECT_EQ(nothing.verdict, Verdict::not_testable);
  // If b is absent, "a ~ b >> c" becomes "a >> c".
  const std::string much = "figure = \"radius_ratio_min\"\norder = \"ps ~ af >> mc\"\nabout = 0.1\nmuch = 3.5\n";
  EXPECT_EQ(judge(much, {records[0], records[1]}).verdict, Verdict::not_held);
  EXPECT_EQ(judge(much, {run("skull", "particles", 0.36), records[1]}).verdict, Verdict::held);
  const std::string first = "figure = \"radius_ratio_min\"\norder = \"mc << af < ps\"\nmuch = 3.5\n";
  EXPECT_EQ(judge(first, {records[0], records[1]}).verdict, Verdict::not_held);
  EXPECT_EQ(judge(first, {run("skull", "particles", 0.36), records[1]}).verdict, Verdict::held);
}

TEST(Claims, AboutAndMuchAreWhatTheFileSays) {
  const std::string about = "figure = \"radius_ratio_min\"\norder = \"ps ~ mc\"\nabout = 0.1\n";
  EXPECT_EQ(judge(about, {run("skull", "particles", 0.91), run("skull", "marching-cubes", 1.0)}).verdict,
            Verdict::held);
  EXPECT_EQ(judge(about, {run("skull", "particles", 0.89), run("skull", "marching-cubes", 1.0)}).verdict,
            Verdict::not_held);
  const std::string much = "figure = \"radius_ratio_min\"\norder = \"ps << mc\"\nmuch = 2\n";
  EXPECT_EQ(judge(much, {run("skull", "particles", 0.5), run("skull", "marching-cubes", 1.0)}).verdict, Verdict::held);
  EXPECT_EQ(judge(much, {run("skull", "particles", 0.51), run("skull", "marching-cubes", 1.0)}).verdict,
            Verdict::not_held);
  EXPECT_EQ(judge(much, {run("skull", "particles", 0.0), run("skull", "marching-cubes", 0.0)}).verdict,
            Verdict::not_held);
}

TEST(Claims, EverySeedBearsTheClaimOutAndOpenMeshesAreMarked) {
  std::vector<RunRecord> records = {run("skull", "particles", 0.3), run("skull", "particles", 0.2),
                                    run("skull", "marching-cubes", 0.1)};
  records[1].request.seed = 2;
  records[1].measurement->set("boundary_edges", 3);
  const ClaimResult held = judge(order, records);
  EXPECT_EQ(held.verdict, Verdict::held);
  EXPECT_EQ(held.findings[0].ours, "particles 0.200–0.300 †, marching-cubes 0.100");
  records[1].measurement->set("radius_ratio_min", 0.05);
  EXPECT_EQ(judge(order, records).verdict, Verdict::not_held);
}

TEST(Claims, TheMethodItselfSpeaksBeforeItsRelativesAndVariants) {
  std::vector<RunRecord> records = {run("skull", "particles", 0.01), run("skull", "marching-cubes", 0.1)};
  EXPECT_EQ(judge(order, records).verdict, Verdict::not_held);
  records.push_back(run("skull", "particles-2007", 0.3));
  EXPECT_EQ(judge(order, records).verdict, Verdict::held);
  records.push_back(run("skull", "particles-2007", 0.01));
  records.back().request.label = "without finish";
  EXPECT_EQ(judge(order, records).verdict, Verdict::held);
}

TEST(Claims, AnAverageIsOverTheDataSetsThatAllHaveFinished) {
  const std::string average =
      "figure = [\"valence_lt5_percent\", \"valence_gt7_percent\"]\norder = \"ps << mc\"\nmuch = 5\ndata = "
      "\"average\"\n";
  std::vector<RunRecord> records = {run("skull", "particles", 0, 2.0), run("skull", "marching-cubes", 0, 8.0),
                                    run("brain", "particles", 0, 0.0), run("brain", "marching-cubes", 0, 4.0)};
  const ClaimResult held = judge(average, records);  // 1 and 6; on the skull alone it would be 2 and 8
  EXPECT_EQ(held.verdict, Verdict::held);
  EXPECT_EQ(held.findings[0].data, "average of 2");
  EXPECT_EQ(held.findings[0].ours, "particles 1.00, marching-cubes 6.00");
  records[3] = unfinished(records[3]);
  const ClaimResult half = judge(average, records);
  EXPECT_EQ(half.verdict, Verdict::not_held);
  EXPECT_NE(half.summary.find("brain left out, as marching-cubes: timeout"), std::string::npos) << half.summary;
  records = {records[0], records[1], records[0]};
  records[2].request.sizing.epsilon = 0.25;
  EXPECT_EQ(judge(average, records).verdict, Verdict::not_testable);
}

TEST(Claims, BoundsAreInclusive) {
  const auto verdict = [](const std::string& bound, double worst) {
    return judge("figure = \"radius_ratio_min\"\nmethod = \"ps\"\n" + bound + "\n", {run("skull", "particles", worst)})
        .verdict;
  };
  EXPECT_EQ(verdict("at_most = 0.5", 0.5), Verdict::held);
  EXPECT_EQ(verdict("at_most = 0.5", 0.51), Verdict::not_held);
  EXPECT_EQ(verdict("at_least = 0.5", 0.5), Verdict::held);
  EXPECT_EQ(verdict("at_least = 0.5", 0.49), Verdict::not_held);
  EXPECT_EQ(verdict("at_least = 0.4\nat_most = 0.5", 0.45), Verdict::held);
}

TEST(Claims, ATrendComparesRunsThatDifferInOneParameter) {
  std::vector<RunRecord> records;
  for (const double epsilon : {0.5, 0.25}) {
    for (const double delta : {0.2, 0.8, 0.4}) {
      records.push_back(run("box", "particles", epsilon - 0.1 * delta));
      records.back().request.sizing.epsilon = epsilon;
      records.back().request.sizing.delta = delta;
    }
  }
  const ClaimResult held = judge(trend, records);
  EXPECT_EQ(held.verdict, Verdict::held);
  ASSERT_EQ(held.findings.size(), 2U);
  EXPECT_EQ(held.findings[0].data, "box, ε 0.5");
  EXPECT_EQ(held.findings[0].ours, "δ 0.8: 0.420, δ 0.4: 0.460, δ 0.2: 0.480");
  records[3].measurement->set("radius_ratio_min", 0.2);  // epsilon 0.25, delta 0.2
  const ClaimResult broken = judge(trend, records);
  EXPECT_EQ(broken.summary, "not held on box, ε 0.25");
  EXPECT_EQ(judge(trend, {records[0]}).summary, "not testable here: no two runs differ in delta alone");
  EXPECT_EQ(judge(trend, {run("box", "marching-cubes", 0.1)}).verdict, Verdict::not_testable);
}

TEST(Claims, ATrendOverSeveralSeedsComparesMedians) {
  const auto cell = [](double delta, const std::vector<double>& ratios) {
    std::vector<RunRecord> records;
    for (const double ratio : ratios) {
      records.push_back(run("box", "particles", ratio));
      records.back().request.sizing.delta = delta;
      records.back().request.seed = records.size();
    }
    return records;
  };
  std::vector<RunRecord> records = cell(0.4, {0.5, 0.3, 0.6});
  for (RunRecord& record : cell(0.2, {0.2, 0.55, 0.7})) records.push_back(record);
  const ClaimResult held = judge(trend, records);
  EXPECT_EQ(held.verdict, Verdict::held);
  EXPECT_EQ(held.findings[0].ours, "δ 0.4: 0.500 (0.300–0.600), δ 0.2: 0.550 (0.200–0.700)");
  records[4].measurement->set("radius_ratio_min", 0.45);
  EXPECT_EQ(judge(trend, records).verdict, Verdict::not_held);
}

// Runs over a grid of ε and δ that are aside. The radius ratio rises by 0.1 from one δ to the next smaller one.
std::vector<RunRecord> sweep_aside(const std::string& dataset, const std::string& method, const std::string& label) {
  std::vector<RunRecord> records;
  for (const double epsilon : {1.0, 0.5}) {
    double ratio = 0.1;
    for (const double delta : {0.6, 0.3, 0.15}) {
      records.push_back(run(dataset, method, ratio));
      records.back().request.label = label;
      records.back().request.aside = true;
      records.back().request.sizing.epsilon = epsilon;
      records.back().request.sizing.delta = delta;
      ratio += 0.1;
    }
  }
  return records;
}

TEST(Claims, ATrendIsSeenInRunsThatAreAside) {
  // As in paper.toml: the tables have one sizing for each data set, and the sweep is a labelled variant of
  // `particles`.
  std::vector<RunRecord> records = {run("skull", "particles-2007", 0.3), run("skull", "particles", 0.3),
                                    run("brain", "particles", 0.2)};
  EXPECT_EQ(judge(trend, records).summary, "not testable here: no two runs differ in delta alone");
  for (const RunRecord& record : sweep_aside("box", "particles", "unfinished")) records.push_back(record);
  const ClaimResult held = judge(trend, records);
  EXPECT_EQ(held.summary, "held");
  ASSERT_EQ(held.findings.size(), 2U);
  EXPECT_EQ(held.findings[0].data, "box, unfinished, ε 1");
  EXPECT_EQ(held.findings[0].ours, "δ 0.6: 0.100, δ 0.3: 0.200, δ 0.15: 0.300");
  EXPECT_EQ(held.findings[1].data, "box, unfinished, ε 0.5");
  records.back().measurement->set("radius_ratio_min", 0.15);
  EXPECT_EQ(judge(trend, records).summary, "not held on box, unfinished, ε 0.5");
  records.back() = unfinished(records.back());
  EXPECT_EQ(judge(trend, records).summary, "held as far as it could be tested (δ 0.15: unfinished: timeout)");
}

TEST(Claims, OrdersAndBoundsLeaveOutRunsThatAreAside) {
  const std::string bound = "figure = \"radius_ratio_min\"\nmethod = \"ps\"\nat_least = 0.15\n";
  std::vector<RunRecord> records = {run("skull", "particles", 0.3), run("skull", "marching-cubes", 0.1)};
  for (const std::string dataset : {"box", "skull"}) {
    for (const RunRecord& record : sweep_aside(dataset, "particles", "particles")) records.push_back(record);
    for (const RunRecord& record : sweep_aside(dataset, "marching-cubes", "coarse")) records.push_back(record);
  }
  for (const std::string& claim : {order, bound}) {
    const ClaimResult result = judge(claim, records);
    EXPECT_EQ(result.verdict, Verdict::held);
    ASSERT_EQ(result.findings.size(), 1U) << claim;
    EXPECT_EQ(result.findings[0].data, "skull");
  }
}

TEST(Claims, ASeriesDiffersInItsParameterAlone) {
  const std::vector<RunRecord> sweep = sweep_aside("box", "particles", "unfinished");
  const std::vector<RunRecord> pair(sweep.begin(), sweep.begin() + 2);
  EXPECT_EQ(judge(trend, pair).verdict, Verdict::held);
  const auto after = [&](auto&& change) {
    std::vector<RunRecord> records = pair;
    change(records[1].request);
    return judge(trend, records).verdict;
  };
  EXPECT_EQ(after([](RunRequest& r) { r.seed = 2; }), Verdict::held);
  EXPECT_EQ(after([](RunRequest& r) { r.label = "finished"; }), Verdict::not_testable);
  EXPECT_EQ(after([](RunRequest& r) { r.dataset = "torus"; }), Verdict::not_testable);
  EXPECT_EQ(after([](RunRequest& r) { r.sizing.epsilon = 0.7; }), Verdict::not_testable);
  EXPECT_EQ(after([](RunRequest& r) { r.sizing.floor = 2.0; }), Verdict::not_testable);
  EXPECT_EQ(after([](RunRequest& r) { set_parameter(r, "sweeps", 30.0); }), Verdict::not_testable);
}

TEST(Claims, AVariantInTheTablesShowsATrendOnlyWhereThePlainMethodShowsNone) {
  std::vector<RunRecord> records = sweep_aside("box", "particles", "without finish");
  for (RunRecord& record : records) record.request.aside = false;
  records.push_back(run("box", "particles", 0.3));
  EXPECT_EQ(judge(trend, records).findings.front().data, "box, without finish, ε 1");
  for (RunRecord record : sweep_aside("box", "particles", "particles")) {
    record.request.aside = false;
    records.push_back(record);
  }
  EXPECT_EQ(judge(trend, records).findings.front().data, "box, ε 0.5");
}

TEST(Claims, MistakesHaveTheirPlace) {
  const auto mistake = [](const std::string& claim) -> std::string {
    try {
      published_with(claim);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "no mistake";
  };
  const auto has = [&mistake](const std::string& claim, const std::string& words) {
    const std::string message = mistake(claim);
    EXPECT_NE(message.find("claims.toml:"), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  EXPECT_EQ(mistake(order), "no mistake");
  EXPECT_NE(mistake("figure = \"radius_ratio_mni\"\norder = \"ps > mc\"\n").find("claims.toml:21:10: "),
            std::string::npos);
  has("figure = \"radius_ratio_mni\"\norder = \"ps > mc\"\n", "did you mean 'radius_ratio_min'?");
  has("figure = \"radius_ratio_min\"\norder = \"ps > xx\"\n", "unknown published method 'xx'");
  has("figure = \"radius_ratio_min\"\norder = \"ps > \"\n", "at least two methods");
  has("figure = \"radius_ratio_min\"\norder = \"ps >= mc\"\n", "'>=' is no relation");
  has("figure = \"radius_ratio_min\"\norder = \"ps > af < mc\"\n", "must not mix");
  has("figure = \"radius_ratio_min\"\norder = \"ps ~ mc\"\n", "'about' is missing");
  has("figure = \"radius_ratio_min\"\norder = \"ps > mc\"\nmuch = 2\n",
      "'much' explains '>>', which this claim does not use");
  has("figure = \"radius_ratio_min\"\norder = \"ps >> mc\"\nmuch = 0.5\n", "more than 1");
  has("figure = \"radius_ratio_min\"\n", "exactly one of");
  has("figure = \"radius_ratio_min\"\norder = \"ps > mc\"\nat_most = 1\n", "exactly one of");
  has("figure = \"radius_ratio_min\"\nat_most = 1\n", "needs 'method'");
  has("figure = \"radius_ratio_min\"\nmethod = \"ps\"\nsmaller = \"seed\"\ngives = \"larger\"\n", "'seed'");
  has("figure = []\norder = \"ps > mc\"\n", "empty list");
  has("figure = \"vertices\"\npublished = \"vertexes\"\norder = \"ps > mc\"\n", "unknown published quantity");
  has("figure = \"vertices\"\nodrer = \"ps > mc\"\n", "did you mean 'order'?");
}

TEST(Claims, ThePapersClaimsStandUnderItsTables) {
  Results results;
  results.title = "A test";
  results.records = {run("skull", "particles", 0.3), run("skull", "marching-cubes", 0.1)};
  results.published = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  EXPECT_GE(results.published->claims.size(), 4U);
  const std::string text = markdown_tables(results);
  EXPECT_NE(text.find("## Claims of Meyer, Kirby, Whitaker 2007"), std::string::npos);
  EXPECT_NE(text.find("then marching cubes.\n\n**held as far as it could be tested (advancing-front was not run)**"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("particles 0.300, marching-cubes 0.100 | ps 0.092, af 0.006, mc 0.000 |"), std::string::npos);
  EXPECT_NE(text.find("Tested: radius_ratio_min: ps > af > mc, on each data set."), std::string::npos);
  EXPECT_NE(text.find("Names in the publication: ps is our particles-2007 or particles, af is our advancing-front"),
            std::string::npos);
  const std::string table = markdown(claims_table(results));
  EXPECT_NE(table.find("| particles 0.300, marching-cubes 0.100 | ps 0.092, af 0.006, mc 0.000 |"), std::string::npos)
      << table;
  EXPECT_NE(text.find("What differs: As in the paper, h0 belongs to the field that controlled the particles"),
            std::string::npos);
}

}  // namespace
}  // namespace isobench
