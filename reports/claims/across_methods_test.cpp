#include "isobench/reports/claims/across_methods.h"

#include <gtest/gtest.h>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/reports/record/sample_refinement.h"

namespace isobench {
namespace {

const std::string claim_head = "source = \"Somebody 1999\"\n[[claim]]\nwords = \"It is so.\"\n";

Published published_claim(const std::string& claim) {
  const TestFolder folder;
  return read_published(folder.write("claims.toml", claim_head + claim));
}

ClaimResult judge_across(const std::string& gives, const std::vector<RunRecord>& records) {
  Results results;
  results.records = records;
  results.published = published_claim(
      "figure = \"gradient_max\"\nacross_methods = { larger = \"angle_max\", gives = \"" + gives + "\", tau = 0.5 }\n");
  return evaluate(results.published->claims.front(), results);
}

// Methods "a", "b", … with these largest angles and errors.
std::vector<RunRecord> methods_with(const std::vector<std::pair<double, double>>& values) {
  std::vector<RunRecord> records;
  for (const auto& [angle, error] : values) {
    records.push_back(sample_record("skull", std::string(1, static_cast<char>('a' + records.size()))));
    records.back().measurement->set("angle_max", angle);
    records.back().measurement->set("gradient_max", error);
  }
  return records;
}

TEST(AcrossMethods, TauSaysWhetherTheFiguresGoTogether) {
  // Of six pairs of methods, five agree: τ = 4/6.
  const std::vector<RunRecord> rising = methods_with({{90, 0.1}, {100, 0.2}, {120, 0.4}, {179, 0.3}});
  const ClaimResult held = judge_across("larger", rising);
  EXPECT_EQ(held.verdict, Verdict::held);
  EXPECT_EQ(held.summary, "held");
  EXPECT_EQ(held.findings.front().data, "skull");
  EXPECT_EQ(held.findings.front().ours, "τ = 0.67 over 4 methods");
  EXPECT_EQ(judge_across("smaller", rising).verdict, Verdict::not_held);
  EXPECT_EQ(judge_across("neither", rising).verdict, Verdict::not_held);
  const std::vector<RunRecord> falling = methods_with({{90, 0.4}, {100, 0.3}, {120, 0.2}, {179, 0.1}});
  EXPECT_EQ(judge_across("smaller", falling).verdict, Verdict::held);
  EXPECT_EQ(judge_across("larger", falling).verdict, Verdict::not_held);
  // Three pairs agree, three do not.
  const std::vector<RunRecord> mixed = methods_with({{90, 0.2}, {100, 0.4}, {120, 0.1}, {179, 0.3}});
  EXPECT_EQ(judge_across("neither", mixed).verdict, Verdict::held);
  EXPECT_EQ(judge_across("larger", mixed).verdict, Verdict::not_held);
}

TEST(AcrossMethods, WhatCannotBeMeasuredIsLeftOutAndNamed) {
  std::vector<RunRecord> records =
      methods_with({{90, 0.1}, {100, 0.2}, {120, 0.3}, {150, 0.4}, {170, 0.0}, {179, 0.0}});
  records[4].measurement->set("gradient_max", std::nullopt);
  records[5].status = Status::timeout;
  records[5].measurement.reset();
  const ClaimResult held = judge_across("larger", records);
  EXPECT_EQ(held.summary, "held as far as it could be tested (e left out: no gradient_max; f left out: timeout)");
  records.erase(records.begin());
  const ClaimResult few = judge_across("larger", records);
  EXPECT_EQ(few.verdict, Verdict::not_testable);
  EXPECT_NE(few.summary.find("3 of the 4 methods that it takes"), std::string::npos) << few.summary;
}

TEST(AcrossMethods, MeshesOfAnotherSizeAreLeftOut) {
  std::vector<RunRecord> records = methods_with({{90, 0.1}, {100, 0.2}, {120, 0.3}, {150, 0.4}, {179, 0.01}});
  records[4].match = MatchRecord{1002.0, 1.0, 3, "it meshes the lattice"};
  const ClaimResult held = judge_across("larger", records);
  EXPECT_EQ(held.findings.front().ours, "τ = 1.00 over 4 methods");
  EXPECT_EQ(held.findings.front().remark, "e left out: another number of vertices");
}

TEST(AcrossMethods, EqualValuesAreNotTestable) {
  const ClaimResult equal = judge_across("larger", methods_with({{90, 0.1}, {90, 0.2}, {90, 0.3}, {90, 0.4}}));
  EXPECT_EQ(equal.summary, "not testable here: all methods have the same value");
}

TEST(AcrossMethods, EachSizingOfADataSetIsTestedAndSeedsGiveTheirMedian) {
  std::vector<RunRecord> records = methods_with({{90, 0.1}, {100, 0.2}, {120, 0.3}, {150, 0.4}});
  for (RunRecord record : methods_with({{90, 0.4}, {100, 0.3}, {120, 0.2}, {150, 0.1}})) {
    record.request.sizing.epsilon = 0.25;
    records.push_back(record);
  }
  for (const double error : {0.1, 9.0}) {  // the median of "a" stays 0.1
    records.push_back(records.front());
    records.back().request.seed = records.size();
    records.back().measurement->set("gradient_max", error);
  }
  records.push_back(records.front());
  records.back().request.aside = true;
  records.back().measurement->set("gradient_max", 99.0);
  const ClaimResult result = judge_across("larger", records);
  ASSERT_EQ(result.findings.size(), 2U);
  EXPECT_EQ(result.findings[0].ours, "τ = 1.00 over 4 methods");
  EXPECT_EQ(result.findings[1].ours, "τ = −1.00 over 4 methods");
  EXPECT_EQ(result.summary, "not held on skull, ε 0.25, δ 0.3");
}

TEST(AcrossMethods, OfManyFindingsTheSummaryCountsThoseThatDidNotHold) {
  std::vector<RunRecord> records;
  for (const std::string dataset : {"a", "b", "c", "d", "e"}) {
    const double sign = dataset == "c" ? -1.0 : 1.0;
    for (RunRecord record :
         methods_with({{90, 2 + sign * 0.1}, {100, 2 + sign * 0.2}, {120, 2 + sign}, {150, 2 + sign * 1.5}})) {
      record.request.dataset = dataset;
      records.push_back(record);
    }
  }
  EXPECT_EQ(judge_across("larger", records).summary, "not held on 1 of 5: c");
}

TEST(AcrossMethods, TheRuleSaysWhatIsTested) {
  const auto rule = [](const std::string& gives) {
    return rule_text(
        published_claim("figure = \"gradient_max\"\nacross_methods = { larger = \"angle_max\", gives = \"" + gives +
                        "\", tau = 0.4 }\n")
            .claims.front());
  };
  EXPECT_EQ(rule("smaller"),
            "gradient_max: over the methods on each data set, it is smaller where angle_max is larger: Kendall's τ is "
            "at most −0.4");
  EXPECT_NE(rule("neither").find("between −0.4 and 0.4"), std::string::npos);
}

TEST(AcrossMethods, MistakesHaveTheirPlace) {
  const auto mistake = [](const std::string& claim) -> std::string {
    try {
      published_claim("figure = \"gradient_max\"\n" + claim);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "no mistake";
  };
  EXPECT_EQ(mistake("across_methods = { larger = \"angle_max\", gives = \"larger\", tau = 1 }\n"), "no mistake");
  const auto has = [&mistake](const std::string& claim, const std::string& words) {
    const std::string message = mistake(claim);
    EXPECT_NE(message.find("claims.toml:5:"), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  has("across_methods = { larger = \"angel_max\", gives = \"larger\", tau = 1 }\n", "did you mean 'angle_max'?");
  has("across_methods = { larger = \"angle_max\", gives = \"lager\", tau = 1 }\n", "did you mean 'larger'?");
  has("across_methods = { larger = \"angle_max\", gives = \"larger\", tau = 1.5 }\n", "never more than 1");
  has("across_methods = { larger = \"angle_max\", gives = \"larger\", tau = 0 }\n", "more than 0");
  has("across_methods = { larger = \"angle_max\", gives = \"larger\" }\n", "tau");
  has("across_methods = { larger = \"angle_max\", gives = \"larger\", tua = 1 }\n", "did you mean 'tau'?");
  EXPECT_NE(mistake("across_methods = { larger = \"angle_max\", gives = \"larger\", tau = 1 }\nat_most = 3\n")
                .find("exactly one of"),
            std::string::npos);
}

}  // namespace
}  // namespace isobench
