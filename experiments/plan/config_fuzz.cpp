// Fuzz targets: configs with their plans, and --set.
#include <algorithm>

#include "isobench/experiments/plan/config.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/foundation/names.h"
#include "isobench/foundation/testing/fuzz_target.h"

namespace isobench {

namespace {

/// Whether a config has so many runs that its plan takes long. Small plans find the same mistakes.
bool is_large(const Config& config) {
  std::size_t runs = config.seeds.size() * static_cast<std::size_t>(config.repeats) * (config.variations.size() + 1) *
                     config.datasets.size();
  const auto several = [&](const Sampling& sampling) {
    for (const auto* list :
         {&sampling.epsilon, &sampling.delta, &sampling.edge_length, &sampling.vertices, &sampling.floor}) {
      runs *= std::max<std::size_t>(list->size(), 1);
    }
  };
  several(config.sampling);
  for (const Override& change : config.overrides) several(change.sampling);
  for (const MethodEntry& entry : config.methods) {
    for (const auto& [name, values] : entry.parameters) runs *= values.size();
  }
  for (const Variation& variation : config.variations) runs += runs * variation.values.size();
  return runs > 500;
}

/// The config that a results folder keeps must be read again as the same one.
void check_config(Config config) {
  require(is_plain_name(config.name), "the name of a results folder is a plain name");
  if (is_large(config)) return;
  const std::vector<RunRequest> plan = make_plan(config);
  for (const RunRequest& request : plan) require(is_plain_name(request.run, 240), "the name of a run is a plain name");
  config.published.reset();
  const Config again = read_config(fuzz_file("stored.toml", to_toml(config, "")));
  require(identity(again) == identity(config), "a config, written and read again, is the same");
  require(plan_to_json(make_plan(again)) == plan_to_json(plan), "a config, written and read again, has the same plan");
}

}  // namespace

bool fuzz_config(std::string_view bytes) {
  const std::filesystem::path path = fuzz_file("config.toml", bytes);
  accepts([&] {
    check_config(read_config(path, ConfigVariant::quick));
    return true;
  });
  return accepts([&] {
    check_config(read_config(path));
    return true;
  });
}

bool fuzz_set(std::string_view bytes) {
  static const Config base = read_config(fuzz_file("base.toml",
                                                   "dataset = \"torus\"\n[sampling]\nedge_length = 2\n"
                                                   "[[method]]\nname = \"particles\"\n"));
  return accepts([&] {
    Config config = base;
    set_parameter(config, std::string(bytes));
    require(make_plan(config).size() == 1, "--set does not change the number of runs");
    check_config(config);
    return true;
  });
}

}  // namespace isobench
