// An experiment as its TOML file says it; see experiments/paper.toml for the whole of the schema in use.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/methods/parameters.h"
#include "isobench/metrics/metric.h"

namespace isobench {

/// [sampling]: lists make a grid. Exactly one of (epsilon and delta), edge_length (mm), vertices.
struct Sampling {
  std::vector<double> epsilon;
  std::vector<double> delta;
  std::vector<double> edge_length;
  std::vector<double> vertices;
  std::vector<double> floor;  ///< voxels; empty: the default of SizingRequest
  Place place;
};

/// [limits]: for every run alike; not set: none.
struct Limits {
  std::optional<double> minutes;
  std::optional<double> memory_gb;
};

/// [[override]]: for some datasets, some methods (by name or label), or the runs where both agree.
struct Override {
  std::vector<std::string> datasets;  ///< empty: all
  std::vector<std::string> methods;   ///< empty: all
  Sampling sampling;
  Limits limits;
  std::optional<bool> artefacts;
};

/// [[method]]: a method and its own parameters; several values of one make a grid.
struct MethodEntry {
  std::string name;
  std::string label;
  std::map<std::string, std::vector<ParameterValue>> parameters;
  Place place;
};

/// [[vary]]: every run of the base again with one value changed, once for each of these; an ablation, where lists
/// would make a grid. It goes over overrides: what is varied is varied everywhere.
struct Variation {
  std::string table;   ///< "sampling", "method" or "reference": the part of the key before the first dot
  std::string method;  ///< of table "method": label, or name, of the entries that it changes
  std::string name;    ///< what is changed: the part of the key after the last dot
  std::vector<ParameterValue> values;
  Place place;

  /// Whether runs of this entry change at all.
  bool changes(const MethodEntry& entry) const;
};

/// match = "vertices", match_to = "…": quality at different counts is no comparison, so every other run of a row (same
/// dataset, sizing, reference k, seed and repeat) is brought to the number of vertices that this entry's run came to.
struct Match {
  std::string to;  ///< label, or name, of a method entry
  Place place;
};

/// [[also]]: a further grid, for a figure of its own. Its runs stay out of the tables that compare.
struct Aside {
  std::vector<std::string> datasets;
  std::vector<std::uint64_t> seeds{1};
  Sampling sampling;
  std::vector<MethodEntry> methods;
};

struct Config {
  std::string name;  ///< the file's stem, and "-quick" where [quick] was applied
  std::string title;
  std::vector<std::string> datasets;
  std::vector<std::uint64_t> seeds{1};
  int repeats = 1;         ///< runs of every cell, for the spread of their seconds
  bool timing = false;     ///< runs go one at a time whatever --jobs says; by default where there are repeats
  bool artefacts = false;  ///< runs leave their medial axis, sizing and particles behind as VTP points
  Sampling sampling;
  std::vector<Override> overrides;
  std::vector<Variation> variations;
  std::vector<MethodEntry> methods;
  std::optional<Match> match;
  std::vector<Aside> also;
  Limits limits;
  std::vector<int> reference_k{default_reference_k};
  std::optional<std::filesystem::path> published;
};

enum class Size { full, quick };

/// Reads and checks a config. Every mistake is a UsageError with file, line and column: unknown keys, methods, datasets
/// and parameters (with the nearest valid name), numbers that are not finite and positive, none or several kinds of
/// sizing, empty lists, labels used twice, overrides and variations that touch nothing, a match to no or several
/// entries.
Config read_config(const std::filesystem::path& path, Size size = Size::full);

/// Gives every method entry that has a parameter of this name the value, in the place of what the config says:
/// "key=value" of the command line. Throws UsageError where no entry has it or the value is out of its range.
void set_parameter(Config& config, const std::string& setting);

/// `base` changed by an override: another kind of sizing replaces the base's, the same kind only the values given.
Sampling merged(const Sampling& base, const Sampling& change);
/// Throws UsageError at the sampling's place unless it asks for exactly one kind of sizing.
void check_kind(const Sampling& sampling);

/// What a [[vary]] of [sampling] puts over the base; empty for another table.
Sampling variation_sampling(const Variation& variation, const ParameterValue& value);

/// The config as TOML again, everything resolved; reading it gives the same plan. `published` names the copied file.
std::string to_toml(const Config& config, const std::string& published);
/// What decides the runs of a config: two configs of equal identity may share a results folder. Title, limits, labels,
/// artefacts and published figures are not part of it.
std::string identity(const Config& config);

}  // namespace isobench
