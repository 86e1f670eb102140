// Checks the tree that this test was built from against the rules of docs/ARCHITECTURE.md: headers are included only
// from the same floor or from floors below, folders do not include each other in a circle, no folder has more than 30
// files, and every test to which a build file gives a label exists.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace isobench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files_in_a_folder = 30;

const std::vector<std::string>& floors() {
  static const std::vector<std::string> all = {"foundation", "datasets", "methods",
                                               "metrics",    "reports",  "experiments"};
  return all;
}

/// A source or header, by its path from the root, and the paths that it includes as "isobench/<path>".
using Includes = std::map<std::string, std::set<std::string>>;

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

std::ptrdiff_t floor_of(const std::string& file) {
  const std::string floor = file.substr(0, file.find('/'));
  return std::find(floors().begin(), floors().end(), floor) - floors().begin();
}

bool is_product_code(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  const auto ends_with = [&stem](const char* end) { return stem.ends_with(end); };
  return !ends_with("_test") && !ends_with("_benchmark") && !ends_with("_fuzz") && !stem.starts_with("test_") &&
         !stem.starts_with("sample_");
}

std::vector<std::string> upward_includes(const Includes& tree) {
  std::vector<std::string> found;
  for (const auto& [file, includes] : tree) {
    for (const std::string& included : includes) {
      if (floor_of(included) > floor_of(file)) found.push_back(fmt::format("{} includes {}", file, included));
    }
  }
  return found;
}

/// Folders that include one another in a circle, in its order; std::nullopt where there is none. Tests, benchmarks and
/// fuzz targets are left out: nothing includes them.
std::optional<std::vector<std::string>> folder_cycle(const Includes& tree) {
  std::map<std::string, std::set<std::string>> graph;
  for (const auto& [file, includes] : tree) {
    if (!is_product_code(file)) continue;
    for (const std::string& included : includes) {
      if (folder_of(included) != folder_of(file)) graph[folder_of(file)].insert(folder_of(included));
    }
  }
  // A folder that includes none of the others is in no circle. Remove such folders until there are none: only circles
  // and folders that lead to them stay.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto folder = graph.begin(); folder != graph.end();) {
      std::erase_if(folder->second, [&graph](const std::string& other) { return !graph.contains(other); });
      changed = changed || folder->second.empty();
      folder = folder->second.empty() ? graph.erase(folder) : std::next(folder);
    }
  }
  if (graph.empty()) return std::nullopt;
  std::vector<std::string> path = {graph.begin()->first};
  while (true) {
    const std::string& next = *graph.at(path.back()).begin();
    const auto met = std::find(path.begin(), path.end(), next);
    if (met != path.end()) return std::vector<std::string>(met, path.end());
    path.push_back(next);
  }
}

std::vector<std::string> crowded_folders(const std::vector<std::string>& files, std::size_t most) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& file : files) ++counts[folder_of(file)];
  std::vector<std::string> found;
  for (const auto& [folder, count] : counts) {
    if (count > most) found.push_back(fmt::format("{} has {} files", folder, count));
  }
  return found;
}

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(fs::path(ISOBENCH_SOURCE) / file).rdbuf();
  return text.str();
}

/// The tests to which a CMakeLists.txt gives a label, as "Suite.Name" or "Suite.*". "Prefix/" of parameters is dropped.
std::set<std::string> labelled_tests(const std::string& cmake) {
  std::set<std::string> named;
  std::istringstream words(cmake);
  bool in_list = false;
  for (std::string word; words >> word;) {
    if (word == "SLOW" || word == "VOLUMES" || word == "THREADS") {
      in_list = true;
      continue;
    }
    const bool ends = word.ends_with(')');
    if (ends) word.pop_back();
    if (in_list && word.find('.') != std::string::npos) named.insert(word.substr(word.find('/') + 1));
    in_list = in_list && !ends;
  }
  return named;
}

/// The tests of a source, each as "Suite.Name" and as "Suite.*".
std::set<std::string> tests_in(const std::string& source) {
  static const std::regex test(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> found;
  for (std::sregex_iterator match(source.begin(), source.end(), test), end; match != end; ++match) {
    found.insert(fmt::format("{}.{}", match->str(1), match->str(2)));
    found.insert(fmt::format("{}.*", match->str(1)));
  }
  return found;
}

std::vector<std::string> files_of_the_tree() {
  std::vector<std::string> files;
  for (const std::string& floor : floors()) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(ISOBENCH_SOURCE) / floor)) {
      const std::string file = fs::relative(entry.path(), ISOBENCH_SOURCE).string();
      const bool ours = entry.is_regular_file() && !entry.path().filename().string().starts_with(".");
      if (ours && file.find("/corpus/") == std::string::npos) files.push_back(file);
    }
  }
  return files;
}

/// The files of ours that each file includes; `unprefixed` gets the includes in quotes without "isobench/".
Includes includes_of(const std::vector<std::string>& files, std::vector<std::string>& unprefixed) {
  const std::string start = "#include \"";
  const std::string prefix = "isobench/";
  Includes tree;
  for (const std::string& file : files) {
    if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
    std::set<std::string>& includes = tree[file];
    std::ifstream source(fs::path(ISOBENCH_SOURCE) / file);
    for (std::string line; std::getline(source, line);) {
      if (!line.starts_with(start)) continue;
      const std::string path = line.substr(start.size(), line.rfind('"') - start.size());
      if (path.starts_with(prefix))
        includes.insert(path.substr(prefix.size()));
      else
        unprefixed.push_back(fmt::format("{} includes {}", file, path));
    }
  }
  return tree;
}

TEST(HouseRules, AnUpwardIncludeIsFound) {
  EXPECT_TRUE(upward_includes({{"methods/a.cpp", {"methods/a.h", "datasets/b.h", "foundation/c.h"}}}).empty());
  EXPECT_EQ(upward_includes({{"datasets/b_test.cpp", {"methods/a.h"}}}),
            std::vector<std::string>{"datasets/b_test.cpp includes methods/a.h"});
}

TEST(HouseRules, ACircleOfFoldersIsFound) {
  Includes tree = {{"methods/a/a.cpp", {"methods/b/b.h"}},
                   {"methods/b/b.h", {"methods/c/c.h"}},
                   {"methods/c/c.h", {"foundation/error.h"}},
                   {"methods/c/c_test.cpp", {"methods/a/a.h"}}};
  EXPECT_FALSE(folder_cycle(tree).has_value());
  tree["methods/c/c.cpp"] = {"methods/b/other.h"};
  EXPECT_EQ(folder_cycle(tree), (std::vector<std::string>{"methods/b", "methods/c"}));
}

TEST(HouseRules, ACrowdedFolderIsFound) {
  EXPECT_TRUE(crowded_folders({"a/1.h", "a/2.h", "a/b/3.h"}, 2).empty());
  EXPECT_EQ(crowded_folders({"a/1.h", "a/2.h", "a/b/3.h"}, 1), std::vector<std::string>{"a has 2 files"});
}

TEST(HouseRules, LabelledTestsAreFoundByName) {
  EXPECT_EQ(
      labelled_tests("isobench_tests(a SOURCES b_test.cpp\n  SLOW Phantoms/C.*\n  THREADS D.E\n F.G)\nadd(h.cpp)"),
      (std::set<std::string>{"C.*", "D.E", "F.G"}));
  EXPECT_EQ(tests_in("TEST(A, B) {}\nTEST_P(C, D) {}"), (std::set<std::string>{"A.B", "A.*", "C.D", "C.*"}));
}

class House : public testing::Test {
 protected:
  std::vector<std::string> files_ = files_of_the_tree();
  std::vector<std::string> unprefixed_;
  Includes includes_ = includes_of(files_, unprefixed_);
};

TEST_F(House, IncludesRunOneWay) {
  ASSERT_GT(includes_.size(), 300U) << "the tree was not found";
  EXPECT_EQ(upward_includes(includes_), std::vector<std::string>());
}

TEST_F(House, IncludesCarryThePrefix) { EXPECT_EQ(unprefixed_, std::vector<std::string>()); }

TEST_F(House, FoldersIncludeEachOtherInNoCircle) {
  EXPECT_EQ(folder_cycle(includes_).value_or(std::vector<std::string>()), std::vector<std::string>());
}

// A test that is renamed only in its source would lose its label unnoticed.
TEST_F(House, EveryTestThatIsGivenALabelExists) {
  for (const std::string& floor : floors()) {
    std::set<std::string> known;
    for (const std::string& file : files_) {
      if (file.starts_with(floor) && file.ends_with("_test.cpp")) known.merge(tests_in(text_of(file)));
    }
    for (const std::string& name : labelled_tests(text_of(floor + "/CMakeLists.txt"))) {
      EXPECT_TRUE(known.contains(name)) << floor << "/CMakeLists.txt gives a label to " << name << ", which is no test";
    }
  }
}

TEST_F(House, NoFolderIsCrowded) {
  EXPECT_EQ(crowded_folders(files_, most_files_in_a_folder), std::vector<std::string>());
}

}  // namespace
}  // namespace isobench
