#include "isobench/reports/claims/convergence.h"

#include <gtest/gtest.h>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/reports/record/sample_refinement.h"

namespace isobench {
namespace {

const std::string order_head = R"(source = "Somebody 1999"
[[method]]
printed = "ps"
name = "particles"
[[claim]]
words = "It is so."
figure = "poisson_l2"
)";

Published published_order(const std::string& claim) {
  const TestFolder folder;
  return read_published(folder.write("claims.toml", order_head + claim));
}

ClaimResult judge_order(const std::string& claim, const std::vector<RunRecord>& records) {
  Results results;
  results.records = records;
  results.published = published_order(claim);
  return evaluate(results.published->claims.front(), results);
}

std::vector<RunRecord> two_orders() {
  std::vector<RunRecord> records = sample_levels("sphere", "particles", 0.2, 2.0);
  for (const RunRecord& record : sample_levels("sphere", "cvt", 0.2, 1.5)) records.push_back(record);
  return records;
}

TEST(Convergence, EveryMethodMustHaveTheOrder) {
  const ClaimResult held = judge_order("convergence = { at_least = 1.4, at_most = 2.1 }\n", two_orders());
  EXPECT_EQ(held.summary, "held");
  ASSERT_EQ(held.findings.size(), 1U);
  EXPECT_EQ(held.findings[0].data, "sphere");
  EXPECT_EQ(held.findings[0].ours, "particles 2.00, cvt 1.50");
  EXPECT_EQ(judge_order("convergence = { at_least = 1.6 }\n", two_orders()).verdict, Verdict::not_held);
  EXPECT_EQ(judge_order("convergence = { at_most = 1.9 }\n", two_orders()).verdict, Verdict::not_held);
}

TEST(Convergence, AClaimMayNameItsMethod) {
  const ClaimResult held = judge_order("method = \"ps\"\nconvergence = { at_least = 1.6 }\n", two_orders());
  EXPECT_EQ(held.summary, "held");
  EXPECT_EQ(held.findings[0].ours, "particles 2.00");
}

TEST(Convergence, WhatHasNoOrderIsLeftOutAndNamed) {
  std::vector<RunRecord> records = two_orders();
  records.pop_back();
  const ClaimResult held = judge_order("convergence = { at_least = 1.6 }\n", records);
  EXPECT_EQ(held.summary, "held as far as it could be tested (cvt left out: fewer than 3 sizings)");
  // A data set with one sizing was not meant to show an order.
  records.push_back(sample_level("skull", "particles", 1000, 0.2, 2.0));
  EXPECT_EQ(judge_order("convergence = { at_least = 1.6 }\n", records).findings.size(), 1U);
  EXPECT_EQ(judge_order("convergence = { at_least = 1.6 }\n", {records.back()}).summary,
            "not testable here: no method was run at several sizings");
}

TEST(Convergence, TheRuleSaysWhatIsTested) {
  EXPECT_EQ(rule_text(published_order("convergence = { at_least = 1.8, at_most = 2.5 }\n").claims.front()),
            "poisson_l2: for each method it falls with h at an order of at least 1.8 and at most 2.5, on each data set "
            "with three sizings or more");
}

TEST(Convergence, MistakesHaveTheirPlace) {
  const auto has = [](const std::string& claim, const std::string& words) {
    std::string message = "no mistake";
    try {
      published_order(claim);
    } catch (const UsageError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find("claims.toml:8:"), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  has("convergence = {}\n", "at_least, at_most or both");
  has("convergence = { at_least = 2, at_most = 1 }\n", "no order of convergence is at least 2 and at most 1");
  has("convergence = { least = 2 }\n", "at_least");
  has("convergence = 2\n", "convergence");
}

}  // namespace
}  // namespace isobench
