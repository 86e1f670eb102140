// The datasets of an experiment, by their names or by globs.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/plan/config_readers.h"

namespace isobench {

namespace {

/// Collects names in their order.
class DatasetList {
 public:
  void add_name(const std::string& name, const Place& place) {
    if (!literal_.insert(name).second) throw UsageError(place, "dataset '" + name + "' is listed twice");
    add(name);
  }
  void add_glob(const std::string& glob, const std::vector<std::string>& known, const Place& place) {
    const std::vector<std::string> found = matching(glob, known);
    if (found.empty()) {
      throw UsageError(place, fmt::format("no dataset matches '{}'; `isobench list datasets` shows all names", glob));
    }
    for (const std::string& name : found) add(name);
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  void add(const std::string& name) {
    if (all_.insert(name).second) names_.push_back(name);
  }

  std::vector<std::string> names_;
  std::set<std::string> all_;
  std::set<std::string> literal_;
};

}  // namespace

std::vector<std::string> read_datasets(const TomlValue& list) {
  DatasetList datasets;
  for (const TomlValue& element : nonempty_list(list, "dataset")) {
    const std::string name = element.as_string();
    if (is_glob(name)) {
      datasets.add_glob(name, dataset_names(), element.place());
    } else {
      dataset_checksum(name, element.place());  // throws where there is no such dataset
      datasets.add_name(name, element.place());
    }
  }
  return datasets.names();
}

std::vector<std::string> read_own_datasets(const TomlValue& list, const std::vector<std::string>& datasets) {
  DatasetList own;
  for (const TomlValue& element : nonempty_list(list, "dataset")) {
    const std::string name = element.as_string();
    if (is_glob(name)) {
      own.add_glob(name, datasets, element.place());
      continue;
    }
    if (std::find(datasets.begin(), datasets.end(), name) == datasets.end()) {
      throw UsageError(element.place(),
                       fmt::format("this experiment has no dataset '{}'{}", name, suggestion(name, datasets)));
    }
    own.add_name(name, element.place());
  }
  return own.names();
}

}  // namespace isobench
