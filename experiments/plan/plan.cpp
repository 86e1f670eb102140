#include "isobench/experiments/plan/plan.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <map>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"

namespace isobench {

namespace {

// FNV-1a, folded to 32 bits. That is enough to tell apart the runs of a folder: a stored record is compared with the
// whole key, not with its hash.
std::uint32_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037ULL;
  for (const char c : text) {
    value ^= static_cast<unsigned char>(c);
    value *= 1099511628211ULL;
  }
  return static_cast<std::uint32_t>(value ^ (value >> 32U));
}

std::string text(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "-"; }

// One value of a [[vary]]; without a variation, no change: the base.
struct Change {
  const Variation* variation = nullptr;
  ParameterValue value;

  bool of(const char* table) const { return variation != nullptr && variation->table == table; }
};

std::vector<Change> changes(const Config& config, const MethodEntry& entry) {
  std::vector<Change> result = {Change{}};
  for (const Variation& variation : config.variations) {
    if (!variation.changes(entry)) continue;
    for (const ParameterValue& value : variation.values) result.push_back({&variation, value});
  }
  return result;
}

struct ParameterVariant {
  std::string label;
  Parameters parameters;
};

// A variant for each combination of the listed parameter values. Its label has the values that distinguish it.
std::vector<ParameterVariant> variants(const MethodEntry& entry, const Method& found, const Change& change) {
  std::vector<ParameterVariant> result = {{entry.label, Parameters(found.parameters)}};
  for (const auto& [name, values] : entry.parameters) {
    std::vector<ParameterVariant> grown;
    for (const ParameterVariant& variant : result) {
      for (const ParameterValue& value : values) {
        ParameterVariant next = variant;
        next.parameters.set(found.parameters, name, value, entry.place);
        if (values.size() > 1) next.label += " " + name + "=" + to_string(value);
        grown.push_back(std::move(next));
      }
    }
    result = std::move(grown);
  }
  if (change.of("method")) {
    for (ParameterVariant& variant : result) {
      variant.parameters.set(found.parameters, change.variation->name, change.value, change.variation->place);
      variant.label += " " + change.variation->name + "=" + to_string(change.value);
    }
  }
  return result;
}

std::vector<SizingRequest> sizings(const Sampling& sampling) {
  std::vector<SizingRequest> result;
  const std::vector<double> floors = sampling.floor.empty() ? std::vector{SizingRequest{}.floor} : sampling.floor;
  for (const double floor : floors) {
    SizingRequest request;
    request.floor = floor;
    for (const double epsilon : sampling.epsilon) {
      for (const double delta : sampling.delta) {
        result.push_back(request);
        result.back().epsilon = epsilon;
        result.back().delta = delta;
      }
    }
    for (const double length : sampling.edge_length) {
      result.push_back(request);
      result.back().edge_length = length;
    }
    for (const double vertices : sampling.vertices) {
      result.push_back(request);
      result.back().vertices = vertices;
    }
  }
  return result;
}

bool names(const std::vector<std::string>& targets, const std::string& name) {
  return std::find(targets.begin(), targets.end(), name) != targets.end();
}

bool applies(const Override& change, const std::string& dataset, const MethodEntry& entry) {
  const bool dataset_agrees = change.datasets.empty() || names(change.datasets, dataset);
  const bool method_agrees =
      change.methods.empty() || names(change.methods, entry.name) || names(change.methods, entry.label);
  return dataset_agrees && method_agrees;
}

// The part of a run that overrides and variations can change.
struct Settings {
  Sampling sampling;
  Limits limits;
  bool artefacts = false;
};

// The settings of one dataset and method. Later overrides replace earlier ones; a variation replaces them all.
Settings resolve(const Config& config, const std::string& dataset, const MethodEntry& entry, const Change& vary) {
  Settings all{config.sampling, config.limits, config.artefacts};
  for (const Override& change : config.overrides) {
    if (!applies(change, dataset, entry)) continue;
    all.sampling = merged(all.sampling, change.sampling);
    if (change.limits.minutes) all.limits.minutes = change.limits.minutes;
    if (change.limits.memory_gb) all.limits.memory_gb = change.limits.memory_gb;
    all.artefacts = change.artefacts.value_or(all.artefacts);
  }
  if (vary.of("sampling")) all.sampling = merged(all.sampling, variation_sampling(*vary.variation, vary.value));
  check_kind(all.sampling);
  return all;
}

// More runs are most likely a mistake in the config, and their plan would fill the memory.
constexpr double most_runs = 100000.0;

void check_number(double runs) {
  if (runs > most_runs) {
    throw UsageError(
        fmt::format("this experiment has {:.0f} runs or more, but at most {:.0f} are possible; shorten its lists or "
                    "make several experiments of it",
                    runs, most_runs));
  }
}

double number_of_runs(const Config& config, const MethodEntry& entry, const Sampling& sampling) {
  const auto of = [](const auto& list) { return static_cast<double>(list.size()); };
  double runs = of(config.seeds) * config.repeats * std::max(of(sampling.floor), 1.0);
  for (const auto& [name, values] : entry.parameters) runs *= of(values);
  return runs * (of(sampling.epsilon) * of(sampling.delta) + of(sampling.edge_length) + of(sampling.vertices));
}

void add_seeds(const Config& config, RunRequest request, std::vector<RunRequest>& runs) {
  for (const std::uint64_t seed : config.seeds) {
    request.seed = seed;
    for (request.repeat = 1; request.repeat <= config.repeats; ++request.repeat) {
      request.run = run_name(request);
      runs.push_back(request);
    }
  }
}

// What is looked up once for all runs of a dataset.
struct PlannedDataset {
  std::string name;
  std::string checksum;
  std::string family;
};

PlannedDataset look_up(const std::string& dataset) {
  return {dataset, dataset_checksum(dataset), dataset_family(dataset)};
}

std::vector<RunRequest> runs_of(const Config& config, const PlannedDataset& dataset, const MethodEntry& entry,
                                const Change& change) {
  const Method& found = method(entry.name, entry.place);
  const auto [sampling, limits, artefacts] = resolve(config, dataset.name, entry, change);
  check_number(number_of_runs(config, entry, sampling));
  RunRequest request;
  request.dataset = dataset.name;
  request.dataset_checksum = dataset.checksum;
  request.family = dataset.family;
  request.method = found.name;
  request.method_revision = found.revision;
  request.metrics_revision = metrics_revision;
  request.alone = config.timing;
  request.artefacts = artefacts;
  request.metrics_of_use = config.metrics_of_use;
  request.min_component = config.min_component;
  request.limit_minutes = limits.minutes;
  request.limit_memory_gb = limits.memory_gb;
  std::vector<RunRequest> runs;
  for (const ParameterVariant& variant : variants(entry, found, change)) {
    request.label = variant.label;
    request.parameters = variant.parameters.all();
    for (const SizingRequest& sizing : sizings(sampling)) {
      request.sizing = sizing;
      add_seeds(config, request, runs);
    }
  }
  return runs;
}

// The candidate with the same sizing, seed and repeat; nullptr where there is none.
const RunRequest* same_row(const std::vector<RunRequest>& candidates, const RunRequest& request) {
  const auto agrees = [&request](const RunRequest& other) {
    return sizing_text(other.sizing) == sizing_text(request.sizing) && other.sizing.floor == request.sizing.floor &&
           other.seed == request.seed && other.repeat == request.repeat;
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), agrees);
  return found == candidates.end() ? nullptr : &*found;
}

// Sets match_to of each run, except of those that the others are matched to.
void match_rows(const Config& config, const PlannedDataset& dataset, const MethodEntry& entry, const Change& change,
                std::vector<RunRequest>& runs) {
  if (!config.match) return;
  const MethodEntry& reference =
      *std::find_if(config.methods.begin(), config.methods.end(),
                    [&config](const MethodEntry& candidate) { return candidate.label == config.match->to; });
  // A variation of the sizing changes all runs of a row. A variation of a method leaves the others as they are, so its
  // runs are matched to the base.
  const bool of_method = change.of("method");
  if (&reference == &entry && !of_method) return;
  if (!reference.runs_on(dataset.name)) {
    throw UsageError(config.match->place,
                     fmt::format("'{}' on {} cannot be matched: '{}' does not run there; let it run on all datasets "
                                 "that others run on",
                                 entry.label, dataset.name, config.match->to));
  }
  const std::vector<RunRequest> candidates = runs_of(config, dataset, reference, of_method ? Change{} : change);
  for (RunRequest& request : runs) {
    const RunRequest* other = same_row(candidates, request);
    if (other == nullptr) {
      throw UsageError(config.match->place,
                       fmt::format("'{}' on {} at {} cannot be matched: '{}' has no run at the same sizing there; give "
                                   "both the same [[override]]",
                                   request.label, dataset.name, sizing_text(request.sizing), config.match->to));
    }
    request.match_to = other->run;
    request.run = run_name(request);
  }
}

// For the name of each run, the label that asked for it first.
using Seen = std::map<std::string, std::string>;

// Adds base runs. None of them may be in the plan already.
void add_base(const std::vector<RunRequest>& runs, Seen& seen, std::vector<RunRequest>& plan) {
  for (const RunRequest& request : runs) {
    const auto [place, fresh] = seen.emplace(request.run, request.label);
    if (!fresh) {
      throw UsageError(fmt::format("'{}' and '{}' ask for the same run {}; remove one of them, or change a parameter",
                                   place->second, request.label, request.run));
    }
    plan.push_back(request);
  }
}

// Adds runs of a variation. A run that the base or another variation has, too, is made once.
void add_variation(const std::vector<RunRequest>& runs, Seen& seen, std::vector<RunRequest>& plan) {
  for (const RunRequest& request : runs) {
    if (seen.emplace(request.run, request.label).second) plan.push_back(request);
  }
}

// Adds the runs of an [[also]], which is planned as an experiment of its own.
void add_aside(const Config& config, const Aside& aside, Seen& seen, std::vector<RunRequest>& plan) {
  Config own;
  own.seeds = aside.seeds;
  own.sampling = aside.sampling;
  own.limits = config.limits;
  own.metrics_of_use = config.metrics_of_use;
  own.min_component = config.min_component;
  for (const std::string& name : aside.datasets) {
    const PlannedDataset dataset = look_up(name);
    for (const MethodEntry& entry : aside.methods) {
      if (!entry.runs_on(name)) continue;
      std::vector<RunRequest> runs = runs_of(own, dataset, entry, Change{});
      for (RunRequest& request : runs) request.aside = true;
      add_base(runs, seen, plan);
    }
  }
  check_number(static_cast<double>(plan.size()));
}

}  // namespace

std::vector<RunRequest> make_plan(const Config& config) {
  std::vector<RunRequest> plan;
  Seen seen;
  for (const std::string& name : config.datasets) {
    const PlannedDataset dataset = look_up(name);
    for (const MethodEntry& entry : config.methods) {
      if (!entry.runs_on(name)) continue;
      for (const Change& change : changes(config, entry)) {
        std::vector<RunRequest> runs = runs_of(config, dataset, entry, change);
        match_rows(config, dataset, entry, change, runs);
        if (change.variation == nullptr)
          add_base(runs, seen, plan);
        else
          add_variation(runs, seen, plan);
        check_number(static_cast<double>(plan.size()));
      }
    }
  }
  for (const Aside& aside : config.also) add_aside(config, aside, seen, plan);
  return plan;
}

std::string result_key(const RunRequest& r) {
  std::string key =
      fmt::format("dataset {} {}\nmethod {} {}\n", r.dataset, r.dataset_checksum, r.method, r.method_revision);
  for (const auto& [name, value] : *r.parameters) key += fmt::format("{} = {}\n", name, to_string(value));
  key += fmt::format("epsilon {} delta {} floor {} edge_length {} vertices {}\n", text(r.sizing.epsilon),
                     text(r.sizing.delta), r.sizing.floor, text(r.sizing.edge_length), text(r.sizing.vertices));
  if (!r.match_to.empty()) key += fmt::format("match {}\n", r.match_to);
  key += fmt::format("seed {}\nmetrics {}\n", r.seed, r.metrics_revision);
  if (r.repeat > 1) key += fmt::format("repeat {}\n", r.repeat);
  if (r.min_component > 0.0) key += fmt::format("min component {}\n", r.min_component);
  return key;
}

std::string run_name(const RunRequest& r) {
  std::string size;
  if (r.sizing.epsilon) size = fmt::format("e{}-d{}", *r.sizing.epsilon, text(r.sizing.delta));
  if (r.sizing.edge_length) size = fmt::format("l{}", *r.sizing.edge_length);
  if (r.sizing.vertices) size = fmt::format("n{}", *r.sizing.vertices);
  // A dataset may be the path of a manifest that the user wrote.
  const std::string dataset = std::filesystem::path(r.dataset).stem().string();
  const std::string repeat = r.repeat > 1 ? fmt::format("r{}-", r.repeat) : "";
  return fmt::format("{}-{}-{}-s{}-{}{:08x}", dataset, r.method, size, r.seed, repeat, hash(result_key(r)));
}

std::string sizing_text(const SizingRequest& sizing) {
  if (sizing.edge_length) return fmt::format("edge {} mm", *sizing.edge_length);
  if (sizing.vertices) return fmt::format("{} vertices", *sizing.vertices);
  return fmt::format("e{} d{}", text(sizing.epsilon), text(sizing.delta));
}

bool selected(const RunRequest& request, const std::string& glob) {
  for (const std::string& name :
       {request.dataset + "/" + request.label, request.dataset + "/" + request.method, request.run}) {
    if (fnmatch(glob.c_str(), name.c_str(), 0) == 0) return true;
  }
  return false;
}

}  // namespace isobench
