#include "isobench/experiments/command_line/frozen_plan.h"

#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/store.h"

namespace isobench {

namespace fs = std::filesystem;

ChosenExperiment choose_experiment(const RunArguments& arguments) {
  ChosenExperiment chosen;
  fs::path config = arguments.config;
  fs::path out = arguments.out.value_or("results");
  std::optional<fs::path> stored;
  if (fs::is_directory(config)) {
    stored = fs::canonical(config);
    config = *stored / "config.toml";
    out = arguments.out.value_or(stored->parent_path());
    if (!fs::exists(config)) {
      throw UsageError(arguments.config.string() +
                       " is a folder without a config.toml, so it holds no results; give a config or a results folder");
    }
  }
  const ConfigVariant whole = stored ? ConfigVariant::stored : ConfigVariant::full;
  chosen.config = read_config(config, arguments.quick ? ConfigVariant::quick : whole);
  if (stored) chosen.config.name = stored->filename().string();  // not "config", the name of the stored file
  for (const std::string& setting : arguments.set) set_parameter(chosen.config, setting);
  if (!arguments.seeds.empty()) chosen.config.seeds = arguments.seeds;
  chosen.folder = out / chosen.config.name;
  if (stored && (!fs::exists(chosen.folder) || !fs::equivalent(chosen.folder, *stored))) chosen.copies = stored;
  return chosen;
}

FrozenPlan freeze_plan(const RunArguments& arguments) {
  const ChosenExperiment chosen = choose_experiment(arguments);
  FrozenPlan frozen{chosen.folder, make_plan(chosen.config)};
  const Store store(frozen.folder, chosen.config, frozen.plan);
  return frozen;
}

std::vector<RunRequest> read_plan(const fs::path& folder) {
  const fs::path path = folder / "plan.json";
  if (!fs::exists(path)) {
    throw UsageError(folder.string() + " has no plan.json, so it is no results folder; give one, e.g. results/paper");
  }
  return plan_from_json(read_text(path), path.string());
}

}  // namespace isobench
