// The verbs of the command line, each in a verb_*.cpp; cli.cpp turns words into these structs.
// Every verb returns the exit code: 0 done, 1 some runs failed, 2 usage, 3 data, 130 interrupted; 2 and 3 mostly come
// as UsageError and DataError.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/experiments/command_line/surface_arguments.h"
#include "isobench/experiments/runner/progress.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/metric.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct CommonArguments {
  int threads = 0;  ///< 0: all cores
  Verbosity verbosity = Verbosity::normal;
  bool tables_only = false;  ///< of the verbs that make a report: no plots, pictures and page
};

struct RunArguments {
  std::filesystem::path config;  ///< or a results folder, whose stored config is run
  std::string only = "*";
  std::optional<std::filesystem::path> out;  ///< default: "results", or where the results folder is
  std::vector<std::string> set;              ///< key=value, over the config's
  std::vector<std::uint64_t> seeds;          ///< in the place of the config's; empty: those
  int jobs = 1;
  bool force = false;
  bool dry_run = false;
  bool quick = false;
  std::string cells;  ///< "3-7,12": these of a results folder's frozen plan alone, without a report; "": all
};
int run_verb(const RunArguments& arguments, const CommonArguments& common);

/// An experiment's plan, written into its results folder.
struct FrozenPlan {
  std::filesystem::path folder;
  std::vector<RunRequest> plan;
};
/// Of a config, or of a results folder that has one; honours config, out, set, seeds and quick.
FrozenPlan freeze_plan(const RunArguments& arguments);
/// plan.json of a results folder. Throws UsageError where there is none.
std::vector<RunRequest> read_plan(const std::filesystem::path& folder);

struct SubmitArguments {
  RunArguments run;                     ///< which experiment
  std::optional<std::size_t> chunk;     ///< cells a task; default: what takes five minutes, as far as that is known
  std::optional<std::size_t> throttle;  ///< tasks at a time
  bool exclusive = false;               ///< a node for each task, its seconds marked so
  std::vector<std::string> sbatch;      ///< words for sbatch
};
/// Hands the cells that are missing or failed to Slurm as job arrays, and a report after them.
int submit_verb(const SubmitArguments& arguments, const CommonArguments& common);

/// Says where every cell of a results folder is.
int status_verb(const std::filesystem::path& folder, const CommonArguments& common);

/// Makes the reports of a results folder from what is stored.
int report_verb(const std::filesystem::path& folder, const CommonArguments& common);

struct CompareArguments {
  std::filesystem::path a;
  std::filesystem::path b;
  double tolerance = 0.0;  ///< relative
};
/// What differs between two results folders; 1 where it is more than seconds, memory and provenance.
int compare_verb(const CompareArguments& arguments, const CommonArguments& common);

struct MeshArguments {
  SurfaceArguments surface;
  SizingRequest sizing;  ///< empty: ε 0.5 and δ 0.3, or nothing for a method that ignores the sizing
  std::string method = "particles";
  std::vector<std::string> set;  ///< key=value
  std::uint64_t seed = 1;
  std::filesystem::path output;
  std::filesystem::path artefacts;  ///< folder for the medial axis, the sizing and the particles
};
int mesh_verb(const MeshArguments& arguments, const CommonArguments& common);

struct MeasureArguments {
  std::filesystem::path mesh;     ///< a file, or a results folder: all of its meshes again, each as its record says
  SurfaceArguments surface;       ///< without one, only the figures that need no surface are measured
  std::optional<double> epsilon;  ///< without it, edges are not compared with h0
  double floor = 0.5;             ///< voxels
  int reference_k = default_reference_k;
  bool json = false;
};
int measure_verb(const MeasureArguments& arguments, const CommonArguments& common);

/// `topic` is datasets, methods, metrics, columns, experiments or empty for all of them.
int list_verb(const std::string& topic);
int fetch_verb(std::vector<std::string> datasets, const CommonArguments& common);
int version_verb();

struct CellArguments {
  std::filesystem::path plan;
  std::string run;
  std::filesystem::path folder;
  std::optional<double> match_vertices;  ///< of a run with match_to
  int progress_fd = -1;
};
/// Hidden: one run of a plan, started by `run` as a child process.
int cell_verb(const CellArguments& arguments, const CommonArguments& common);

/// The whole command line.
int command_line(int argc, char** argv);

}  // namespace isobench
