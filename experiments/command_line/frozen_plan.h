// From the arguments of `run` and `submit` to an experiment's plan, and the plan that a results folder keeps.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/config.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// The experiment that the arguments name, by a config or by a results folder, which keeps its config.
struct ChosenExperiment {
  Config config;                                ///< with --set, --seed and --quick applied
  std::filesystem::path folder;                 ///< its results folder, which may not exist yet
  std::optional<std::filesystem::path> copies;  ///< the results folder that is computed again in another place
};
/// Uses config, out, set, seeds and quick. Throws UsageError for a mistake in them or in the config.
ChosenExperiment choose_experiment(const RunArguments& arguments);

/// A plan as it stands in a results folder.
struct FrozenPlan {
  std::filesystem::path folder;
  std::vector<RunRequest> plan;
};
/// Makes the results folder of the chosen experiment and writes its plan there.
FrozenPlan freeze_plan(const RunArguments& arguments);

/// Reads plan.json of a results folder. Throws UsageError where there is none.
std::vector<RunRequest> read_plan(const std::filesystem::path& folder);

}  // namespace isobench
