#include "isobench/experiments/plan/config.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

const char* const plain = R"(dataset = ["torus", "sphere"]
[sampling]
epsilon = 0.5
delta = 0.3
[[method]]
name = "marching-cubes"
)";

fs::path write(const std::string& text, const std::string& name = "config.toml") {
  static const TestFolder folder;  // of this process: tests run side by side
  return folder.write(name, text);
}

Config read(const std::string& text, ConfigVariant variant = ConfigVariant::full) {
  return read_config(write(text), variant);
}

// The message of the UsageError that reading gives; "" where there is none.
std::string mistake(const std::string& text) {
  try {
    make_plan(read(text));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, what.size(), with);
}

void expect_mistake(const std::string& text, const std::vector<std::string>& parts) {
  const std::string message = mistake(text);
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\nin: " << message;
}

TEST(Config, ReadsWhatIsThere) {
  const Config config = read(plain);
  EXPECT_EQ(config.name, "config");
  EXPECT_EQ(config.datasets, (std::vector<std::string>{"torus", "sphere"}));
  EXPECT_EQ(config.seeds, std::vector<std::uint64_t>{1});
  EXPECT_EQ(config.sampling.epsilon, std::vector<double>{0.5});
  EXPECT_EQ(config.methods.at(0).label, "marching-cubes");
  EXPECT_FALSE(config.limits.minutes.has_value());
}

TEST(ConfigErrors, UnknownNamesComeWithPlaceAndNearest) {
  expect_mistake(replaced(plain, "sphere", "spere"), {"config.toml:1:", "unknown dataset 'spere'", "'sphere'"});
  expect_mistake(replaced(plain, "marching-cubes", "marching-cube"), {"config.toml:6:", "'marching-cubes'"});
  expect_mistake(replaced(plain, "delta", "detla"), {"config.toml:4:1", "detla", "'delta'"});
  expect_mistake(replaced(plain, "[[method]]", "[limts]\n[[method]]"), {"limts", "'limits'"});
  expect_mistake(std::string(plain) + "contraction = 1.5\n", {"config.toml:7:", "contraction"});
  expect_mistake(replaced(plain, "marching-cubes", "particles") + "swepes = 3\n", {"config.toml:7:", "'sweeps'"});
}

TEST(ConfigErrors, NumbersMustBeFiniteAndPositive) {
  expect_mistake(replaced(plain, "0.5", "0"), {"config.toml:3:", "epsilon is 0"});
  expect_mistake(replaced(plain, "0.5", "-0.5"), {"config.toml:3:", "epsilon is -0.5"});
  expect_mistake(replaced(plain, "0.5", "nan"), {"config.toml:3:", "epsilon", "not nan"});
  expect_mistake(replaced(plain, "0.5", "inf"), {"config.toml:3:", "epsilon is inf"});
  expect_mistake(replaced(plain, "0.5", "\"much\""), {"config.toml:3:", "number", "string"});
  expect_mistake(std::string("seed = -1\n") + plain, {"config.toml:1:", "seed is -1"});
  expect_mistake(std::string(plain) + "[limits]\nminutes = 0\n", {"config.toml:8:", "minutes is 0"});
}

TEST(ConfigErrors, ExactlyOneKindOfSizing) {
  expect_mistake(replaced(plain, "delta = 0.3\n", ""), {"config.toml:2:", "epsilon is given without delta"});
  expect_mistake(replaced(plain, "epsilon = 0.5\n", ""), {"config.toml:2:", "delta is given without epsilon"});
  expect_mistake(replaced(plain, "epsilon = 0.5\ndelta = 0.3\n", ""), {"config.toml:2:", "no size"});
  expect_mistake(replaced(plain, "delta = 0.3", "delta = 0.3\nvertices = 100"), {"config.toml:2:", "several sizes"});
  expect_mistake(replaced(plain, "epsilon = 0.5\ndelta = 0.3", "edge_length = 1\nvertices = 100"), {"several sizes"});
  EXPECT_EQ(mistake(replaced(plain, "epsilon = 0.5\ndelta = 0.3", "edge_length = 2")), "");
}

TEST(ConfigErrors, ListsLabelsAndOverrides) {
  expect_mistake(replaced(plain, "[\"torus\", \"sphere\"]", "[]"), {"config.toml:1:", "dataset is an empty list"});
  expect_mistake(replaced(plain, "0.5", "[]"), {"config.toml:3:", "epsilon is an empty list"});
  expect_mistake(std::string(plain) + "[[method]]\nname = \"marching-cubes\"\n", {"config.toml:7:", "used twice"});
  expect_mistake(std::string(plain) + "[[method]]\nname = \"marching-cubes\"\nlabel = \"again\"\n", {"the same run"});
  expect_mistake(std::string(plain) + "[[override]]\ndataset = \"skull\"\n", {"config.toml:8:", "no dataset 'skull'"});
  expect_mistake(std::string(plain) + "[[override]]\nsampling = { epsilon = 1 }\n",
                 {"config.toml:7:", "needs dataset or method"});
  expect_mistake(std::string(plain) + "[[override]]\ndataset = \"torus\"\nsampling = { epsilon = 1, vertices = 9 }\n",
                 {"config.toml:9:", "several sizes"});
  expect_mistake(std::string(plain) + "[published]\nsource = \"nowhere.toml\"\n", {"config.toml:8:", "nowhere.toml"});
  expect_mistake(std::string(plain) + "[quick]\ndataset = \"tors\"\n", {"config.toml:8:", "'torus'"});
  expect_mistake("dataset = \n", {"config.toml:1:"});
}

TEST(Config, QuickReplacesWhatItNames) {
  const std::string text = std::string(plain) + "[quick]\ndataset = \"slab\"\nsampling = { epsilon = 1 }\n";
  const Config quick = read(text, ConfigVariant::quick);
  EXPECT_EQ(quick.name, "config-quick");
  EXPECT_EQ(quick.datasets, std::vector<std::string>{"slab"});
  EXPECT_EQ(quick.sampling.epsilon, std::vector<double>{1.0});
  EXPECT_EQ(quick.sampling.delta, std::vector<double>{0.3});
  EXPECT_EQ(read(text).datasets.size(), 2U);
  EXPECT_THROW(read(plain, ConfigVariant::quick), UsageError);
}

TEST(Config, QuickForgetsWhatIsAboutThingsItLeavesOut) {
  const std::string text = std::string(plain) + R"([[method]]
name = "particles"
[[override]]
dataset = ["sphere", "torus"]
sampling = { epsilon = 1 }
[[override]]
dataset = "sphere"
method = "marching-cubes"
sampling = { epsilon = 2 }
[[override]]
method = "particles"
sampling = { epsilon = 3 }
[[vary]]
key = "method.particles.sweeps"
values = [5]
[[vary]]
key = "sampling.delta"
values = [0.1]
[quick]
dataset = "torus"
method = "marching-cubes"
)";
  const Config quick = read(text, ConfigVariant::quick);
  ASSERT_EQ(quick.overrides.size(), 1U);
  EXPECT_EQ(quick.overrides[0].datasets, std::vector<std::string>{"torus"});
  ASSERT_EQ(quick.variations.size(), 1U);
  EXPECT_EQ(quick.variations[0].name, "delta");
  // A results folder keeps the quick config alone; the next run reads it back.
  const Config stored = read_config(write(to_toml(quick, ""), "stored.toml"));
  EXPECT_EQ(identity(stored), identity(quick));
  EXPECT_EQ(plan_to_json(make_plan(stored)), plan_to_json(make_plan(quick)));
  EXPECT_EQ(read(text).overrides.size(), 3U);
}

TEST(Config, WrittenOutAndReadBackGivesTheSamePlan) {
  const std::string text = R"(title = "a \"quoted\" title"
dataset = ["torus", "sphere"]
seed = [1, 7]
repeats = 2
timing = false
[sampling]
epsilon = [0.5, 0.75]
delta = 0.3
floor = 0.25
[[override]]
dataset = "sphere"
method = "few"
sampling = { edge_length = 2.5 }
limits = { minutes = 3 }
[[vary]]
key = "sampling.floor"
values = [0.1, 0.2]
[[vary]]
key = "method.few.rounds"
values = [1, 2]
[[vary]]
key = "method.dotted.name.sweeps"
values = 7
[[method]]
name = "particles"
label = "few"
sweeps = [5, 10]
[[method]]
name = "marching-cubes"
[[method]]
name = "particles"
label = "dotted.name"
[limits]
minutes = 20
memory_gb = 8
)";
  const Config config = read(text);
  const Config again = read_config(write(to_toml(config, ""), "again.toml"));
  EXPECT_EQ(again.title, "a \"quoted\" title");
  EXPECT_EQ(identity(again), identity(config));
  EXPECT_EQ(plan_to_json(make_plan(again)), plan_to_json(make_plan(config)));
}

// Older versions had a table [reference], and wrote it into the config of every results folder.
TEST(ConfigErrors, AReferenceIsNoLongerAskedForButAnOldFolderHasIt) {
  const std::string old = std::string(plain) + "[reference]\nk = [1, 3]\n";
  expect_mistake(old, {"config.toml:7:", "proven", "remove the table [reference]"});
  EXPECT_EQ(identity(read(old, ConfigVariant::stored)), identity(read(plain)));
  EXPECT_EQ(to_toml(read(old, ConfigVariant::stored), ""), to_toml(read(plain), ""));
}

TEST(ConfigErrors, AsidesAreWholeExperiments) {
  const std::string also = std::string(plain) + "[[also]]\ndataset = \"slab\"\nsampling = { epsilon = 1, delta = 1 }\n";
  const std::string method = "method = { name = \"marching-cubes\" }\n";
  EXPECT_EQ(mistake(also + method), "");
  expect_mistake(also, {"config.toml:7:", "method"});
  expect_mistake(also + method + "vary = 1\n", {"config.toml:11:", "vary"});
  expect_mistake(replaced(also, "slab", "slap") + method, {"config.toml:8:", "'slab'"});
  expect_mistake(replaced(also + method, "slab\"\nsampling = { epsilon = 1, delta = 1 }",
                          "torus\"\nsampling = { epsilon = 0.5, delta = 0.3 }"),
                 {"ask for the same run"});
}

TEST(ConfigErrors, VariationsChangeWhatThereIs) {
  const auto vary = [](const std::string& key, const std::string& values) {
    return std::string(plain) + "[[vary]]\nkey = \"" + key + "\"\nvalues = " + values + "\n";
  };
  EXPECT_EQ(mistake(vary("sampling.epsilon", "[0.5, 0.75]")), "");
  EXPECT_EQ(mistake(vary("sampling.edge_length", "[2]")), "");  // another kind of sizing than the base's
  expect_mistake(vary("sampling.epsilno", "[1]"), {"config.toml:8:", "epsilno", "'epsilon'"});
  expect_mistake(vary("sampling.epsilon", "[]"), {"config.toml:9:", "values is an empty list"});
  expect_mistake(vary("sampling.epsilon", "[1, -1]"), {"config.toml:9:", "epsilon is -1"});
  expect_mistake(vary("samplign.epsilon", "[1]"), {"config.toml:8:", "[[vary]]", "'sampling'"});
  expect_mistake(vary("epsilon", "[1]"), {"config.toml:8:", "sampling.<key>"});
  expect_mistake(vary("method.marching-cube.x", "[1]"), {"config.toml:8:", "'marching-cubes'"});
  expect_mistake(vary("method.marching-cubes.sweeps", "[1]"), {"config.toml:8:", "sweeps"});
  expect_mistake(vary("reference.k", "[1, 3]"), {"config.toml:8:", "[[vary]]", "sampling.<key>"});
  expect_mistake(std::string(plain) + "[[vary]]\nvalues = [1]\n", {"config.toml:7:", "key"});
  expect_mistake(replaced(vary("sampling.epsilon", "[1]"), "epsilon = 0.5", "epsilon = [0.5, 0.6]"),
                 {"config.toml:8:", "several values of epsilon", "starts from one"});
  expect_mistake(replaced(vary("sampling.epsilon", "[1]"), "epsilon = 0.5\ndelta = 0.3", "vertices = 100"),
                 {"config.toml:7:", "epsilon is given without delta"});
  const std::string particles = replaced(vary("method.particles.sweeps", "[3, 4.5]"), "marching-cubes", "particles");
  expect_mistake(particles, {"config.toml:9:", "'sweeps'", "4.5"});
  expect_mistake(replaced(particles, "[[vary]]", "sweeps = [1, 2]\n[[vary]]"), {"several values of sweeps"});
}

TEST(ConfigErrors, RunsAreMatchedToOneEntry) {
  const std::string match = "match = \"vertices\"\nmatch_to = \"particles\"\n";
  const std::string both = std::string(plain) + "[[method]]\nname = \"particles\"\n";
  EXPECT_EQ(mistake(match + both), "");
  expect_mistake("match = \"area\"\nmatch_to = \"particles\"\n" + both, {"config.toml:1:", "'area'", "\"vertices\""});
  expect_mistake("match = \"vertices\"\n" + both, {"match_to"});
  expect_mistake("match_to = \"particles\"\n" + both, {"'match'"});
  expect_mistake(replaced(match, "particles", "particle") + both, {"config.toml:2:", "'particle'", "'particles'"});
  expect_mistake(match + both + "sweeps = [5, 10]\n", {"config.toml:2:", "2 values of sweeps"});
  expect_mistake(match + plain + "[[method]]\nname = \"particles\"\nlabel = \"a\"\n[[method]]\nname = \"particles\"\n" +
                     "label = \"b\"\nsweeps = 5\n",
                 {"config.toml:2:", "2 entries", "label"});
  expect_mistake(match + both + "[[override]]\nmethod = \"particles\"\nsampling = { epsilon = 1.0 }\n",
                 {"config.toml:2:", "marching-cubes", "same sizing"});
  expect_mistake(match + both + "[quick]\nmethod = \"marching-cubes\"\n", {"[quick] leaves out 'particles'"});
}

TEST(ConfigErrors, NamesThatWouldLeaveTheResultsFolder) {
  for (const char* name : {"...toml", ".toml", ".hidden.toml", "-x.toml", "a\nb.toml"}) {
    EXPECT_THROW(read_config(write(plain, name)), UsageError) << name;
  }
  EXPECT_THROW(read_config(write(plain, std::string(150, 'n') + ".toml")), UsageError);
  for (const char* dataset : {"../torus", "/torus", "torus/../torus", ".", "..", ""}) {
    expect_mistake(replaced(plain, "\"torus\"", fmt::format("\"{}\"", dataset)), {"config.toml:1:", "unknown dataset"});
  }
  expect_mistake(replaced(plain, "marching-cubes", "../marching-cubes"), {"config.toml:6:", "unknown method"});
  // A manifest that exists, but whose name cannot be that of a folder.
  const std::string manifest = "title = \"P\"\n[phantom]\nname = \"torus\"\nnodes = 64\n";
  const fs::path hidden = write(manifest, ".tmp-own.toml");
  expect_mistake(replaced(plain, "\"torus\"", fmt::format("\"{}\"", hidden.string())), {".tmp-own.toml", "rename it"});
}

TEST(ConfigErrors, TextsThatNoTableCanTake) {
  const auto label = [](const std::string& text) { return std::string(plain) + "label = \"" + text + "\"\n"; };
  expect_mistake(label("a\\nb"), {"config.toml:7:", "label must be one printable line"});
  expect_mistake(label("\\u001b[31m"), {"config.toml:7:", "label"});
  expect_mistake(label(std::string(101, 'l')), {"config.toml:7:", "label"});
  EXPECT_EQ(mistake(label("ε ≤ 0.5, \\\"best\\\"")), "");
  expect_mistake("title = \"a\\u0007\"\n" + std::string(plain), {"config.toml:1:", "title must be one printable line"});
}

TEST(ConfigErrors, PublishedFiguresAreAFileOfSuch) {
  const auto published = [](const std::string& source) {
    return std::string(plain) + "[published]\nsource = \"" + source + "\"\n";
  };
  expect_mistake(published("."), {"config.toml:8:", "no file"});
  expect_mistake(published("/dev/zero"), {"config.toml:8:", "no file"});
  write("secret\n", "secret.txt");
  expect_mistake(published("secret.txt"), {"secret.txt:1:"});
}

TEST(ConfigErrors, MoreRunsThanAnybodyMeans) {
  std::string list = "1";
  for (int n = 2; n <= 400; ++n) list += ", " + std::to_string(n);
  const std::string text = "seed = [" + list + "]\n" + replaced(plain, "0.5", "[" + list + "]");
  expect_mistake(text, {"160000 runs or more", "100000"});
  expect_mistake("repeats = 1000\n" + replaced(text, "[\"torus\", \"sphere\"]", "\"torus\""), {"160000000 runs"});
}

TEST(ConfigErrors, RepeatsAreAWholeNumber) {
  expect_mistake(std::string("repeats = 0\n") + plain, {"config.toml:1:", "repeats is 0"});
  expect_mistake(std::string("repeats = 1.5\n") + plain, {"config.toml:1:", "repeats"});
  expect_mistake(std::string("timing = 1\n") + plain, {"config.toml:1:", "timing"});
}

TEST(Config, RepeatsAreTimedUnlessItSaysOtherwise) {
  EXPECT_FALSE(read(plain).timing);
  EXPECT_TRUE(read(std::string("repeats = 3\n") + plain).timing);
  EXPECT_FALSE(read(std::string("repeats = 3\ntiming = false\n") + plain).timing);
  EXPECT_TRUE(read(std::string("timing = true\n") + plain).timing);
  EXPECT_TRUE(read(std::string(plain) + "[quick]\nrepeats = 2\n", ConfigVariant::quick).timing);
  EXPECT_FALSE(read("timing = false\n" + std::string(plain) + "[quick]\nrepeats = 2\n", ConfigVariant::quick).timing);
  EXPECT_NE(identity(read(plain)), identity(read(std::string("timing = true\n") + plain)));
}

TEST(Config, ArtefactsAreNoPartOfTheIdentity) {
  const Config asking = read(std::string("artefacts = true\n") + plain);
  EXPECT_TRUE(asking.artefacts);
  EXPECT_FALSE(read(plain).artefacts);
  EXPECT_NE(to_toml(asking, "").find("artefacts = true"), std::string::npos);
  EXPECT_EQ(identity(asking), identity(read(plain)));
}

TEST(Config, MetricsOfUseAreMeasuredIfTheConfigAsksForThem) {
  const Config asking = read(std::string("metrics_of_use = true\n") + plain);
  for (const RunRequest& request : make_plan(asking)) EXPECT_TRUE(request.metrics_of_use);
  for (const RunRequest& request : make_plan(read(plain))) EXPECT_FALSE(request.metrics_of_use);
  EXPECT_TRUE(read(to_toml(asking, "")).metrics_of_use);
  // They change no result that was there, so that both have the same runs and share a folder.
  EXPECT_EQ(identity(asking), identity(read(plain)));
  EXPECT_EQ(make_plan(asking).front().run, make_plan(read(plain)).front().run);
  expect_mistake(std::string("metrics_of_use = 1\n") + plain, {"config.toml:1:", "metrics_of_use"});
  expect_mistake(std::string("metric_of_use = true\n") + plain, {"config.toml:1:", "'metrics_of_use'"});
}

TEST(Config, ComponentsBelowAVolumeMayBeLeftOut) {
  const Config config = read(std::string("min_component = 2.5\n") + plain);
  EXPECT_EQ(config.min_component, 2.5);
  EXPECT_EQ(read(plain).min_component, 0.0);
  EXPECT_NE(to_toml(config, "").find("min_component = 2.5\n"), std::string::npos);
  EXPECT_NE(identity(config), identity(read(plain)));
  for (const RunRequest& request : make_plan(config)) EXPECT_EQ(request.min_component, 2.5);
  expect_mistake(std::string("min_component = -1\n") + plain, {"config.toml:1:", "min_component"});
}

TEST(Config, SetReplacesAParameterOfEveryMethodThatHasIt) {
  Config config = read(replaced(plain, "marching-cubes", "particles") + "sweeps = [1, 2]\n[[method]]\n" +
                       "name = \"marching-cubes\"\n[[method]]\nname = \"particles\"\nlabel = \"other\"\nrounds = 1\n");
  set_parameter(config, "sweeps=7");
  EXPECT_EQ(config.methods[0].parameters.at("sweeps"), std::vector<ParameterValue>{7.0});
  EXPECT_TRUE(config.methods[1].parameters.empty());
  EXPECT_EQ(config.methods[2].parameters.at("sweeps"), std::vector<ParameterValue>{7.0});
  EXPECT_THROW(set_parameter(config, "sweeps"), UsageError);
  EXPECT_THROW(set_parameter(config, "sweeps=many"), UsageError);
  EXPECT_THROW(set_parameter(config, "sweeps=-1"), UsageError);
  EXPECT_THROW(set_parameter(config, "swepes=7"), UsageError);
}

// The example of README.md must work: every key that it shows is read, and gives the runs that it describes.
TEST(Config, TheExampleOfThePageIsAnExperiment) {
  const std::string page = read_text(fs::path(ISOBENCH_EXPERIMENTS) / "README.md");
  const std::size_t begin = page.find("```toml\n") + 8;
  const std::string example = page.substr(begin, page.find("```\n", begin) - begin);
  const fs::path path = write(example, "example.toml");
  fs::create_directories(path.parent_path() / "published");
  fs::copy_file(fs::path(ISOBENCH_EXPERIMENTS) / "published" / "meyer-2007.toml",
                path.parent_path() / "published" / "meyer-2007.toml", fs::copy_options::overwrite_existing);
  // Two data sets, the torus at one ε. The three variants of particles have two variations each; marching cubes has
  // none.
  const std::size_t rows = 1 + 2;
  const std::size_t of_a_row = (1 + 2) * (1 + 2) + 1;
  const std::size_t aside = 2 * 2;
  EXPECT_EQ(make_plan(read_config(path)).size(), rows * of_a_row * 3 * 2 + aside);
  EXPECT_EQ(make_plan(read_config(path, ConfigVariant::quick)).size(), of_a_row * 2 + aside);
}

TEST(Config, IdentityIsOfWhatDecidesTheRuns) {
  const Config config = read(plain);
  EXPECT_EQ(identity(config), identity(read(std::string("title = \"x\"\n") + plain + "[limits]\nminutes = 1\n")));
  EXPECT_EQ(identity(config), identity(read(std::string(plain) + "label = \"other\"\n")));
  EXPECT_NE(identity(config), identity(read(replaced(plain, "0.5", "0.6"))));
  EXPECT_NE(identity(config), identity(read(replaced(plain, ", \"sphere\"", ""))));
  const std::string varied = std::string(plain) + "[[vary]]\nkey = \"sampling.delta\"\nvalues = [0.1]\n";
  EXPECT_NE(identity(config), identity(read(varied)));
  EXPECT_NE(identity(read(varied)), identity(read(replaced(varied, "0.1", "0.2"))));
  // Two entries of one method: to vary the one or the other makes different experiments, though only labels differ.
  const std::string two = replaced(plain, "marching-cubes", "particles") +
                          "label = \"a\"\n[[method]]\nname = \"particles\"\nlabel = \"b\"\nsweeps = 5\n";
  const auto of = [&two](const std::string& label) {
    return identity(read(two + "[[vary]]\nkey = \"method." + label + ".rounds\"\nvalues = [1]\n"));
  };
  EXPECT_NE(of("a"), of("b"));
}

}  // namespace
}  // namespace isobench
