#include <fmt/format.h>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/command_line/verbs.h"

namespace isobench {

int fetch_verb(std::vector<std::string> datasets, const CommonArguments& common) {
  if (datasets.empty()) {
    // The members of a family have their files in common.
    for (const DatasetInfo& dataset : list_datasets()) datasets.push_back(dataset.first);
  }
  Console console(common.verbosity);
  ConsoleSink sink(console);
  Monitor monitor(&sink);
  for (const std::string& name : datasets) {
    const std::vector<std::filesystem::path> files = fetch_dataset(name, monitor);
    console.clear();
    for (const std::filesystem::path& file : files) fmt::print("{}\n", file.string());
  }
  return 0;
}

}  // namespace isobench
