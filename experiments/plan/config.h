// An experiment as its TOML file describes it. experiments/README.md explains every key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/methods/parameters.h"

namespace isobench {

/// [sampling]: how long edges shall be. Exactly one kind of sizing: epsilon and delta, edge_length, or vertices.
/// Several values make a grid.
struct Sampling {
  std::vector<double> epsilon;
  std::vector<double> delta;
  std::vector<double> edge_length;  ///< mm
  std::vector<double> vertices;
  std::vector<double> floor;  ///< voxels; empty: the default of SizingRequest
  Place place;
};

/// [limits]: of each run; no limit where not set.
struct Limits {
  std::optional<double> minutes;
  std::optional<double> memory_gb;  ///< 10⁹ bytes
};

/// [[override]]: other values for the runs of some datasets, of some methods, or of both.
struct Override {
  std::vector<std::string> datasets;  ///< empty: all
  std::vector<std::string> methods;   ///< names or labels; empty: all
  Sampling sampling;
  Limits limits;
  std::optional<bool> artefacts;
};

/// [[method]]: a method and its parameters. Several values of a parameter make a grid.
struct MethodEntry {
  std::string name;
  std::string label;                  ///< tells apart several entries of one method; the name by default
  std::vector<std::string> datasets;  ///< it runs on these alone; empty: on all of the experiment
  std::map<std::string, std::vector<ParameterValue>> parameters;
  Place place;

  bool runs_on(const std::string& dataset) const;
};

/// [[vary]]: one value changed at a time, as an ablation needs it. Without variations an experiment has its base runs;
/// each value here adds all of them again with that one change. The change replaces the value of an override, too.
struct Variation {
  std::string table;   ///< "sampling" or "method": the part of the key before the first dot
  std::string method;  ///< of table "method": label or name of the entries that it changes
  std::string name;    ///< the key within the table, or the parameter: the part of the key after the last dot
  std::vector<ParameterValue> values;
  Place place;

  /// Whether it changes the runs of this entry.
  bool changes(const MethodEntry& entry) const;
};

/// match = "vertices" with match_to = "…": the quality of meshes can be compared only at equal numbers of vertices. The
/// sizing of every other run of a row is scaled until its mesh has as many as the mesh of this entry. The runs of a row
/// have dataset, sizing, seed and repeat in common.
struct Match {
  std::string to;  ///< label of a method entry
  Place place;
};

/// [[also]]: runs beside those of the experiment, for a figure that needs its own. Tables of comparison leave them out.
struct Aside {
  std::vector<std::string> datasets;
  std::vector<std::uint64_t> seeds{1};
  Sampling sampling;
  std::vector<MethodEntry> methods;
};

struct Config {
  std::string
      name;  ///< of the results folder: the file's name without ".toml", with "-quick" where [quick] was applied
  std::string title;
  std::vector<std::string> datasets;
  std::vector<std::uint64_t> seeds{1};
  int repeats = 1;              ///< how often each run is made, for the spread of its seconds
  bool timing = false;          ///< one run at a time, whatever --jobs says; the default where repeats > 1
  bool artefacts = false;       ///< runs also keep medial axis, sizing and particles, as VTP points
  bool metrics_of_use = false;  ///< runs are also measured by the metrics that take seconds (When::on_request)
  double min_component = 0.0;   ///< mm³: components of F = c that enclose less are left out of every mesh
  Sampling sampling;
  std::vector<Override> overrides;
  std::vector<Variation> variations;
  std::vector<MethodEntry> methods;
  std::optional<Match> match;
  std::vector<Aside> also;
  Limits limits;
  std::optional<std::filesystem::path> published;
};

enum class ConfigVariant {
  full,    ///< the experiment as it is
  quick,   ///< the smaller one that its [quick] describes
  stored,  ///< the config of a results folder, which an older version may have written
};

/// Reads and checks a config. Every mistake is a UsageError with file, line and column: unknown keys, methods, datasets
/// and parameters (with the nearest valid name), numbers that are not finite and positive, no kind of sizing or
/// several, empty lists, labels used twice, overrides and variations that change no run, a match to no entry or to
/// several, a glob that matches no dataset. Globs are replaced by the names that they match.
Config read_config(const std::filesystem::path& path, ConfigVariant variant = ConfigVariant::full);

/// Sets a parameter, "key=value", in every method entry that has it, and so replaces the config's values. Throws
/// UsageError where no entry has it or the value is out of its range.
void set_parameter(Config& config, const std::string& setting);

/// `base` with the changes of an override. Another kind of sizing replaces that of the base; the same kind replaces
/// only the values that it gives.
Sampling merged(const Sampling& base, const Sampling& change);
/// Throws UsageError at the sampling's place unless it asks for exactly one kind of sizing.
void check_kind(const Sampling& sampling);

/// The change that a [[vary]] of [sampling] makes to the base; an empty one for other tables.
Sampling variation_sampling(const Variation& variation, const ParameterValue& value);

/// The config as TOML, with [quick] applied or left out; read again, it gives the same plan. `published` is the path to
/// write for the published figures.
std::string to_toml(const Config& config, const std::string& published);
/// A text that is equal for two configs if and only if they have the same runs and so may share a results folder.
/// Title, limits, labels, artefacts, metrics of use and published figures make no difference.
std::string identity(const Config& config);

}  // namespace isobench
