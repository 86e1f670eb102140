#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <new>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

// What the words on the command line are parsed into, and what to do once they are.
struct CommandLine {
  CommonArguments common;
  bool quiet = false;
  bool verbose = false;
  RunArguments run;
  SubmitArguments submit;
  std::filesystem::path report_folder;
  std::filesystem::path status_folder;
  CompareArguments compare;
  MeshArguments mesh;
  MeasureArguments measure;
  std::string topic;
  std::vector<std::string> fetch;
  CellArguments cell;
  std::function<int()> action;
};

void add_common(CLI::App& verb, CommandLine& line) {
  verb.add_option("--threads", line.common.threads, "threads to compute with (default: all cores)")
      ->check(CLI::NonNegativeNumber);
  verb.add_flag("-q,--quiet", line.quiet, "no progress");
  verb.add_flag("-v,--verbose", line.verbose, "every stage a line");
}

// The rest of a report takes seconds, and packages of its own.
void add_tables_only(CLI::App& verb, CommandLine& line) {
  verb.add_flag("--tables-only", line.common.tables_only, "of the report only the tables: no plots, pictures and page")
      ->envname("ISOBENCH_TABLES_ONLY");
}

void add_surface(CLI::App& verb, SurfaceArguments& surface) {
  verb.add_option("--dataset", surface.dataset, "a name of `isobench list datasets`");
  verb.add_option("--volume", surface.volume, "a file: NRRD, MetaImage, NIfTI, VTI, INRIMAGE");
  verb.add_option("--isovalue", surface.isovalue, "with --volume: the value of F at the surface");
  verb.add_option("--inside", surface.inside, "with --volume: whether the object is above or below the isovalue")
      ->check(CLI::IsMember({"above", "below"}))
      ->capture_default_str();
  verb.add_option("--smooth", surface.smooth, "with --volume: Gaussian sigma in voxels")->check(CLI::NonNegativeNumber);
}

void add_sizing(CLI::App& verb, SizingRequest& sizing) {
  verb.add_option("--epsilon", sizing.epsilon, "adaptive: edges up to 2 epsilon times the local feature size");
  verb.add_option("--delta", sizing.delta, "adaptive: Lipschitz bound of the sizing");
  verb.add_option("--floor", sizing.floor, "adaptive: shortest edge asked for, voxels")->capture_default_str();
  verb.add_option("--edge-length", sizing.edge_length, "uniform: edge length, mm");
  verb.add_option("--vertices", sizing.vertices, "uniform: number of vertices");
}

// Which experiment, and how it differs from its config.
void add_experiment(CLI::App& verb, RunArguments& run) {
  verb.add_option(
          "config", run.config,
          "TOML file, e.g. experiments/quick.toml; or a results folder, to go on with it or, with --out, to make "
          "all of it again and compare")
      ->required();
  verb.add_option("--out", run.out, "folder for <experiment>/ (default: results)");
  verb.add_option("--set", run.set, "a parameter of the methods: key=value; another experiment, so give --out");
  verb.add_option("--seed", run.seeds, "of everything random, in the place of the config's: 7 or 1,2,3; give --out")
      ->delimiter(',')
      ->allow_extra_args(false);  // the next word is the config
  verb.add_flag("--quick", run.quick, "the config's [quick] variant");
}

void add_run(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand("run", "Run an experiment; what is done already is not done again");
  add_experiment(*verb, line.run);
  verb->add_option("--only", line.run.only, "only the runs that a glob names, e.g. 'skull/*'");
  verb->add_option("--cells", line.run.cells,
                   "only cells of a results folder's plan, by number, e.g. 3-7,12; no report is written");
  verb->add_option("--jobs", line.run.jobs, "runs at a time")->check(CLI::Range(1, 1024))->capture_default_str();
  verb->add_flag("--force", line.run.force, "run again what is done");
  verb->add_flag("--dry-run", line.run.dry_run, "only say what would be run");
  add_tables_only(*verb, line);
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return run_verb(line.run, line.common); }; });
}

void add_cluster(CLI::App& app, CommandLine& line) {
  SubmitArguments& submit = line.submit;
  CLI::App* verb = app.add_subcommand("submit", "Hand an experiment's missing and failed cells to Slurm");
  add_experiment(*verb, submit.run);
  verb->add_option("--chunk", submit.chunk, "cells a task (default: as many as take some minutes)")
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--throttle", submit.throttle, "tasks at a time")->check(CLI::PositiveNumber);
  verb->add_flag("--exclusive-timing", submit.exclusive, "a node for each task, so that its seconds count");
  verb->add_option("sbatch", submit.sbatch, "after --: more for sbatch, e.g. -- --partition=long");
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return submit_verb(line.submit, line.common); }; });

  CLI::App* status = app.add_subcommand("status", "Where every cell of a results folder is");
  status->add_option("folder", line.status_folder, "e.g. results/paper")->required();
  add_common(*status, line);
  status->callback([&line] { line.action = [&line] { return status_verb(line.status_folder, line.common); }; });
}

void add_report(CLI::App& app, CommandLine& line) {
  CLI::App* verb =
      app.add_subcommand("report", "The page, tables and results.csv of a results folder, from what is stored");
  verb->add_option("folder", line.report_folder, "e.g. results/paper")->required();
  add_tables_only(*verb, line);
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return report_verb(line.report_folder, line.common); }; });
}

void add_compare(CLI::App& app, CommandLine& line) {
  CompareArguments& compare = line.compare;
  CLI::App* verb = app.add_subcommand("compare", "What differs between two results folders, figure by figure");
  verb->add_option("a", compare.a, "e.g. results/paper")->required();
  verb->add_option("b", compare.b, "another one")->required();
  verb->add_option("--tolerance", compare.tolerance, "relative difference of two numbers to let pass")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return compare_verb(line.compare, line.common); }; });
}

void add_mesh(CLI::App& app, CommandLine& line) {
  MeshArguments& mesh = line.mesh;
  CLI::App* verb = app.add_subcommand(
      "mesh", "Mesh a dataset or a volume file; without a sizing it takes --epsilon 0.5 --delta 0.3");
  add_surface(*verb, mesh.surface);
  add_sizing(*verb, mesh.sizing);
  verb->add_option("--method", mesh.method, "a name of `isobench list methods`")->capture_default_str();
  verb->add_option("--set", mesh.set, "a parameter of the method: key=value");
  verb->add_option("--seed", mesh.seed, "of everything random")->capture_default_str();
  verb->add_option("-o,--output", mesh.output, "file to write: .vtp, .ply, .off, .obj, .stl");
  verb->add_option("--artefacts", mesh.artefacts,
                   "folder for medial-axis.vtp, sizing.vtp, particles.vtp, as far as the method has them");
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return mesh_verb(line.mesh, line.common); }; });
}

void add_measure(CLI::App& app, CommandLine& line) {
  MeasureArguments& measure = line.measure;
  CLI::App* verb = app.add_subcommand(
      "measure",
      "Measure a mesh file, by itself or against the surface of a dataset or volume file; or every mesh of a results "
      "folder again");
  verb->add_option("mesh", measure.mesh,
                   "a mesh of any program, in mm and, with a surface, in its world coordinates; or a results folder")
      ->required();
  add_surface(*verb, measure.surface);
  verb->add_option("--epsilon", measure.epsilon, "compare edges with h0 of this epsilon; needs a surface");
  verb->add_option("--floor", measure.floor, "of h0, voxels")->capture_default_str();
  verb->add_option("--reference-k", measure.reference_k, "refinement of the reference topology")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  verb->add_flag("--json", measure.json, "every figure, as JSON");
  add_tables_only(*verb, line);
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return measure_verb(line.measure, line.common); }; });
}

void add_others(CLI::App& app, CommandLine& line) {
  CLI::App* list = app.add_subcommand("list", "What there is, with parameters, units, ranges and defaults");
  list->add_option("topic", line.topic, "datasets, methods, metrics, columns (of results.csv) or experiments");
  list->callback([&line] { line.action = [&line] { return list_verb(line.topic); }; });

  CLI::App* fetch = app.add_subcommand("fetch", "Bring data into the cache, checked by SHA-256");
  fetch->add_option("dataset", line.fetch, "names of `isobench list datasets` (default: all)");
  add_common(*fetch, line);
  fetch->callback([&line] { line.action = [&line] { return fetch_verb(line.fetch, line.common); }; });

  CLI::App* cell = app.add_subcommand("cell", "")->group("");
  cell->add_option("--plan", line.cell.plan)->required();
  cell->add_option("--run", line.cell.run)->required();
  cell->add_option("--folder", line.cell.folder)->required();
  cell->add_option("--match-vertices", line.cell.match_vertices);
  cell->add_option("--progress-fd", line.cell.progress_fd);
  add_common(*cell, line);
  cell->callback([&line] { line.action = [&line] { return cell_verb(line.cell, line.common); }; });
}

// CLI11 only says that a word was not expected.
void check_verb(int argc, char** argv) {
  const std::vector<std::string> verbs = {"run",  "submit",  "status", "report", "compare",
                                          "mesh", "measure", "list",   "fetch",  "cell"};
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string word = argv[1];
  if (std::find(verbs.begin(), verbs.end(), word) != verbs.end()) return;
  throw UsageError("unknown verb '" + word + "'" + suggestion(word, {verbs.begin(), verbs.end() - 1}));
}

int parse_and_run(int argc, char** argv) {
  check_verb(argc, argv);
  CLI::App app("isobench: isosurface meshing methods side by side, measured by the same metrics", "isobench");
  CommandLine line;
  bool version = false;
  app.add_flag("--version", version, "version, commit and libraries");
  app.require_subcommand(0, 1);
  add_run(app, line);
  add_cluster(app, line);
  add_report(app, line);
  add_compare(app, line);
  add_mesh(app, line);
  add_measure(app, line);
  add_others(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    throw UsageError(std::string(error.what()) + "; see isobench " +
                     (argc > 1 && argv[1][0] != '-' ? std::string(argv[1]) + " " : "") + "--help");
  }
  if (version) return version_verb();
  if (!line.action) {
    fmt::print("{}", app.help());
    return 2;
  }
  line.common.verbosity = line.quiet ? Verbosity::quiet : line.verbose ? Verbosity::verbose : Verbosity::normal;
  std::unique_ptr<tbb::global_control> control;
  if (line.common.threads > 0) {
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(line.common.threads));
  }
  return line.action();
}

}  // namespace

int command_line(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "isobench: {}\n", error.what());
    return 2;
  } catch (const DataError& error) {
    fmt::print(stderr, "isobench: {}\n", error.what());
    return 3;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "isobench: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "isobench: {}\n", error.what());
    return 1;
  }
}

}  // namespace isobench
