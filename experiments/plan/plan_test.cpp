#include "isobench/experiments/plan/plan.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/method.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

std::vector<RunRequest> plan_of(const std::string& text) {
  const TestFolder folder;
  return make_plan(read_config(folder.write("plan.toml", text)));
}

const char* const grid = R"(dataset = ["torus", "sphere"]
seed = [1, 2]
[sampling]
epsilon = [0.5, 0.75]
delta = 0.3
[[override]]
dataset = "sphere"
sampling = { epsilon = 1.0 }
[[method]]
name = "particles"
sweeps = [5, 10, 20]
[[method]]
name = "marching-cubes"
[limits]
minutes = 20
)";

TEST(Plan, IsTheGridWithOverrides) {
  const std::vector<RunRequest> plan = plan_of(grid);
  // torus: (3 + 1) methods x 2 epsilons x 2 seeds; sphere: one epsilon.
  ASSERT_EQ(plan.size(), 16U + 8U);
  std::set<std::string> names;
  for (const RunRequest& request : plan) {
    names.insert(request.run);
    EXPECT_EQ(request.limit_minutes, 20.0);
    EXPECT_EQ(request.sizing.epsilon == 1.0, request.dataset == "sphere");
  }
  EXPECT_EQ(names.size(), plan.size());
  EXPECT_EQ(plan.front().label, "particles sweeps=5");
  EXPECT_EQ(std::get<double>(plan.front().parameters->at("sweeps")), 5.0);
}

TEST(Plan, AnOverrideOfAnotherKindReplacesTheSizing) {
  const auto plan = plan_of(R"(dataset = "torus"
[sampling]
epsilon = 0.5
delta = 0.3
[[override]]
method = "marching-cubes"
sampling = { edge_length = 2.2 }
limits = { memory_gb = 3 }
[[method]]
name = "marching-cubes"
[[method]]
name = "flying-edges"
)");
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[0].sizing.edge_length, 2.2);
  EXPECT_FALSE(plan[0].sizing.epsilon.has_value());
  EXPECT_EQ(plan[0].limit_memory_gb, 3.0);
  EXPECT_EQ(plan[1].sizing.epsilon, 0.5);
  EXPECT_FALSE(plan[1].limit_memory_gb.has_value());
}

// Three numbers of sweeps, the one in the middle the method's own default.
std::array<int, 3> around_the_default() {
  const int sweeps = Parameters(method("particles").parameters).integer("sweeps");
  return {sweeps + 1, sweeps, sweeps + 2};
}

std::string ablation() {
  const std::string text = R"(dataset = ["torus", "sphere"]
[sampling]
epsilon = 0.5
delta = 0.3
[[override]]
dataset = "sphere"
sampling = { epsilon = 1.0 }
[[method]]
name = "particles"
[[method]]
name = "marching-cubes"
[[vary]]
key = "sampling.epsilon"
values = [0.5, 0.75, 1.0]
[[vary]]
key = "method.particles.sweeps"
)";
  return text + fmt::format("values = [{}]\n", fmt::join(around_the_default(), ", "));
}

TEST(Plan, VariesOneThingAtATimeFromOneBase) {
  std::vector<std::string> names;
  for (const RunRequest& r : plan_of(ablation())) {
    names.push_back(fmt::format("{} {} {}", r.dataset, r.label, *r.sizing.epsilon));
  }
  // The default is the base, which comes once. A variation of epsilon replaces the sphere's override.
  const std::string more = fmt::format("particles sweeps={}", around_the_default()[0]);
  const std::string most = fmt::format("particles sweeps={}", around_the_default()[2]);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "torus particles 0.5",       //
                       "torus particles 0.75",      //
                       "torus particles 1",         //
                       "torus " + more + " 0.5",    //
                       "torus " + most + " 0.5",    //
                       "torus marching-cubes 0.5",  //
                       "torus marching-cubes 0.75",
                       "torus marching-cubes 1",
                       "sphere particles 1",
                       "sphere particles 0.5",
                       "sphere particles 0.75",
                       "sphere " + more + " 1",
                       "sphere " + most + " 1",
                       "sphere marching-cubes 1",
                       "sphere marching-cubes 0.5",
                       "sphere marching-cubes 0.75",
                   }));
  for (const RunRequest& r : plan_of(ablation())) {
    const auto sweeps = static_cast<double>(around_the_default()[2]);
    EXPECT_EQ(r.label == most, r.method == "particles" && r.parameters->at("sweeps") == ParameterValue(sweeps));
  }
}

TEST(Plan, RepeatsAreRunsOfTheirOwn) {
  const auto plan = plan_of(R"(dataset = "torus"
seed = [1, 2]
repeats = 3
[sampling]
edge_length = 2
[[method]]
name = "marching-cubes"
)");
  ASSERT_EQ(plan.size(), 2U * 3U);
  std::set<std::string> names;
  std::set<std::string> keys;
  for (const RunRequest& request : plan) {
    names.insert(request.run);
    keys.insert(result_key(request));
    EXPECT_TRUE(request.alone);
  }
  EXPECT_EQ(names.size(), plan.size());
  EXPECT_EQ(keys.size(), plan.size());
  EXPECT_EQ(plan[2].repeat, 3);
  EXPECT_EQ(plan[2].run.rfind("torus-marching-cubes-l2-s1-r3-", 0), 0U) << plan[2].run;
}

RunRequest sample() {
  RunRequest request;
  request.dataset = "skull";
  request.dataset_checksum = "abc";
  request.method = "particles";
  request.label = "particles";
  request.parameters = ParameterValues{{"sweeps", 60.0}, {"finish", true}};
  request.sizing.epsilon = 0.5;
  request.sizing.delta = 0.3;
  return request;
}

TEST(RunName, SaysWhatItIs) {
  const std::string name = run_name(sample());
  EXPECT_EQ(name.substr(0, name.size() - 8), "skull-particles-e0.5-d0.3-s1-");
  EXPECT_EQ(name.substr(name.size() - 8).find_first_not_of("0123456789abcdef"), std::string::npos);
  RunRequest uniform = sample();
  uniform.sizing = {};
  uniform.sizing.edge_length = 2.2;
  EXPECT_EQ(run_name(uniform).rfind("skull-particles-l2.2-s1-", 0), 0U);
}

TEST(RunName, HashesAllThatDeterminesTheResultAndNothingElse) {
  const std::vector<std::function<void(RunRequest&)>> changes = {
      [](RunRequest& r) { r.dataset = "brain"; },
      [](RunRequest& r) { r.dataset_checksum = "abd"; },
      [](RunRequest& r) { r.method_revision = 2; },
      [](RunRequest& r) { set_parameter(r, "sweeps", 61.0); },
      [](RunRequest& r) { set_parameter(r, "finish", false); },
      [](RunRequest& r) { r.sizing.epsilon = 0.5000000000000001; },
      [](RunRequest& r) { r.sizing.floor = 0.4; },
      [](RunRequest& r) { r.match_to = "sphere-particles-l2-s1-00000000"; },
      [](RunRequest& r) { r.seed = 2; },
      [](RunRequest& r) { r.repeat = 2; },
      [](RunRequest& r) { r.min_component = 2.0; },
      [](RunRequest& r) { r.metrics_revision = 99; },
  };
  std::set<std::string> tails = {run_name(sample()).substr(run_name(sample()).size() - 8)};
  for (const auto& change : changes) {
    RunRequest request = sample();
    change(request);
    const std::string name = run_name(request);
    EXPECT_TRUE(tails.insert(name.substr(name.size() - 8)).second) << result_key(request);
  }
  RunRequest same = sample();
  same.label = "another label";
  same.limit_minutes = 1.0;
  same.alone = true;
  EXPECT_EQ(run_name(same), run_name(sample()));
}

const char* const matched = R"(dataset = ["torus", "sphere"]
seed = [1, 2]
match = "vertices"
match_to = "best"
[sampling]
epsilon = [0.5, 0.75]
delta = 0.3
[[method]]
name = "marching-cubes"
[[method]]
name = "particles"
label = "best"
[[method]]
name = "particles"
sweeps = 5
)";

TEST(Plan, MatchesEveryOtherRunOfARow) {
  const std::vector<RunRequest> plan = plan_of(matched);
  ASSERT_EQ(plan.size(), 2U * 2U * 3U * 2U);
  std::map<std::string, const RunRequest*> by_name;
  for (const RunRequest& request : plan) by_name[request.run] = &request;
  ASSERT_EQ(by_name.size(), plan.size());
  for (const RunRequest& request : plan) {
    EXPECT_EQ(request.match_to.empty(), request.label == "best") << request.run;
    if (request.match_to.empty()) continue;
    const RunRequest& other = *by_name.at(request.match_to);
    EXPECT_EQ(other.label, "best");
    EXPECT_EQ(other.dataset, request.dataset);
    EXPECT_EQ(other.sizing.epsilon, request.sizing.epsilon);
    EXPECT_EQ(other.seed, request.seed);
  }
}

TEST(Plan, AblationsAreMatchedToTheBaseOfTheirRow) {
  const std::string vary = R"([[vary]]
key = "method.best.sweeps"
values = [7]
[[vary]]
key = "sampling.delta"
values = [0.1]
)";
  for (const RunRequest& request : plan_of(matched + vary)) {
    if (request.label == "best sweeps=7") {
      EXPECT_NE(request.match_to.find("-d0.3-"), std::string::npos) << request.match_to;
    }
    if (request.sizing.delta == 0.1 && request.label != "best") {
      EXPECT_NE(request.match_to.find("-d0.1-"), std::string::npos) << request.match_to;
    }
  }
}

TEST(Plan, WhatIsForAFigureStandsAside) {
  const std::string text = R"(dataset = "torus"
[sampling]
epsilon = 0.5
delta = 0.3
[[override]]
method = "particles"
artefacts = true
[[method]]
name = "particles"
[[method]]
name = "marching-cubes"
[[also]]
dataset = "rounded-box"
seed = [1, 2]
sampling = { epsilon = [1.0, 0.6], delta = 0.3 }
method = { name = "particles", label = "unfinished", finish = 0 }
)";
  const std::vector<RunRequest> plan = plan_of(text);
  ASSERT_EQ(plan.size(), 2U + 4U);
  for (const RunRequest& request : plan) {
    EXPECT_EQ(request.aside, request.dataset == "rounded-box");
    EXPECT_EQ(request.artefacts, request.label == "particles");
    EXPECT_EQ(request.label == "unfinished", request.aside);
  }
  EXPECT_TRUE(plan_from_json(plan_to_json(plan), "plan").back().aside);
  // The config that a results folder keeps gives the same plan. Keeping artefacts does not make another experiment.
  const TestFolder folder;
  const Config config = read_config(folder.write("config.toml", text));
  const Config stored = read_config(folder.write("stored.toml", to_toml(config, "")));
  EXPECT_EQ(plan_to_json(make_plan(stored)), plan_to_json(plan));
  Config without = config;
  without.overrides.clear();
  EXPECT_EQ(identity(without), identity(config));
  without.also[0].seeds = {1};
  EXPECT_NE(identity(without), identity(config));
}

TEST(Plan, ThePapersExperimentHasTheGridOfItsSecondFigure) {
  const auto plan = make_plan(read_config(ISOBENCH_EXPERIMENTS "/paper.toml"));
  EXPECT_EQ(std::count_if(plan.begin(), plan.end(), [](const RunRequest& r) { return r.aside; }), 81);
  const auto sweep = make_plan(read_config(ISOBENCH_EXPERIMENTS "/sweep.toml"));
  for (const RunRequest& request : sweep) {
    EXPECT_TRUE(std::any_of(plan.begin(), plan.end(), [&](const RunRequest& r) { return r.run == request.run; }));
  }
}

TEST(Plan, OnlySelectsByDatasetAndLabelOrRun) {
  RunRequest request = sample();
  request.label = "best";
  request.run = run_name(request);
  EXPECT_TRUE(selected(request, "skull/*"));
  EXPECT_TRUE(selected(request, "*/best"));
  EXPECT_TRUE(selected(request, "skull/particles"));
  EXPECT_TRUE(selected(request, request.run));
  EXPECT_FALSE(selected(request, "brain/*"));
  EXPECT_FALSE(selected(request, "skull"));
}

}  // namespace
}  // namespace isobench
