// The verbs of the command line, each in verb_<name>.cpp, and their arguments, which command_line.cpp fills in.
// A verb returns the program's exit code: 0 done, 1 some runs failed, 3 no run had usable data, 130 interrupted. It
// throws UsageError (exit code 2) and DataError (3).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/experiments/command_line/surface_arguments.h"
#include "isobench/experiments/runner/progress.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct CommonArguments {
  int threads = 0;  ///< 0: all cores
  Verbosity verbosity = Verbosity::normal;
  bool tables_only = false;  ///< a report has no plots, pictures and page
};

struct RunArguments {
  std::filesystem::path config;              ///< a config, or a results folder: its stored config is run
  std::string only = "*";                    ///< a glob: see selected() in plan/plan.h
  std::optional<std::filesystem::path> out;  ///< default: "results", or the folder that the results folder is in
  std::vector<std::string> set;              ///< key=value, each replaces the config's value
  std::vector<std::uint64_t> seeds;          ///< replace the config's seeds; empty: keep them
  int jobs = 1;
  bool force = false;
  bool dry_run = false;
  bool quick = false;
  std::string cells;  ///< "3-7,12": run only these cells of a results folder's plan and write no report; "": all
};
int run_verb(const RunArguments& arguments, const CommonArguments& common);

struct SubmitArguments {
  RunArguments run;                     ///< which experiment
  std::optional<std::size_t> chunk;     ///< cells per task; default: as many as take five minutes, if that is known
  std::optional<std::size_t> throttle;  ///< tasks at a time
  bool exclusive = false;               ///< a whole node for each task; its seconds are marked as measured alone
  std::vector<std::string> sbatch;      ///< further arguments for sbatch
};
/// Submits the missing and failed cells to Slurm as job arrays, and after them a job that writes the report.
int submit_verb(const SubmitArguments& arguments, const CommonArguments& common);

/// Prints where every cell of a results folder is: done, running, waiting, failed or missing.
int status_verb(const std::filesystem::path& folder, const CommonArguments& common);

/// Writes the reports of a results folder from what is stored.
int report_verb(const std::filesystem::path& folder, const CommonArguments& common);

struct CompareArguments {
  std::filesystem::path a;
  std::filesystem::path b;
  double tolerance = 0.0;  ///< relative
};
/// Prints what differs between two results folders. Returns 1 if more differs than seconds, memory and circumstances.
int compare_verb(const CompareArguments& arguments, const CommonArguments& common);

struct MeshArguments {
  SurfaceArguments surface;
  SizingRequest sizing;  ///< empty: ε 0.5 and δ 0.3, or nothing for a method that ignores the sizing
  std::string method = "particles";
  std::vector<std::string> set;  ///< key=value
  std::uint64_t seed = 1;
  std::filesystem::path output;
  std::filesystem::path artefacts;  ///< folder for the medial axis, the sizing and the particles
  std::optional<double> max_vertices;
};
/// Meshes one volume, prints the mesh's figures and writes it to a file.
int mesh_verb(const MeshArguments& arguments, const CommonArguments& common);

struct MeasureArguments {
  std::filesystem::path mesh;     ///< a file, or a results folder: each of its meshes, as its record states
  SurfaceArguments surface;       ///< without one, only the figures that need no surface are measured
  std::optional<double> epsilon;  ///< without it, edges are not compared with h0
  std::optional<double> delta;    ///< with epsilon, for h, the size that was asked for; 0.3 if not given
  double floor = 0.5;             ///< voxels
  bool metrics_of_use = false;    ///< of a results folder; a mesh file is measured by all metrics
  bool json = false;
};
int measure_verb(const MeasureArguments& arguments, const CommonArguments& common);

/// Prints what there is. `topic` is datasets, methods, metrics, columns, experiments, or empty for all of them.
int list_verb(const std::string& topic);

/// Downloads datasets into the cache, all of them if none is named, and prints the paths of their files.
int fetch_verb(std::vector<std::string> datasets, const CommonArguments& common);

/// Prints version, commit, compiler and libraries. Called for the option --version; it is no verb of the command line.
int version_verb();

struct CellArguments {
  std::filesystem::path plan;
  std::string run;
  std::filesystem::path folder;
  std::optional<double> match_vertices;  ///< given if and only if the run has a match_to
  int progress_fd = -1;                  ///< file descriptor to write progress to
};
/// Hidden from the user: does one run of a plan. `run` starts it as a child process.
int cell_verb(const CellArguments& arguments, const CommonArguments& common);

}  // namespace isobench
