#include "isobench/experiments/command_line/command_line.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/experiments/command_line/help_formatter.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

// The parsed words of the command line, and the verb to run.
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

// An option of a verb. `value` stands for its value in the help: "N", "FILE".
template <class Variable>
CLI::Option* add(CLI::App& verb, const std::string& names, Variable& variable, const std::string& value,
                 const std::string& description) {
  return verb.add_option(names, variable, description)->option_text(value);
}

void add_verbosity(CLI::App& verb, CommandLine& line, const std::string& quiet, const std::string& verbose) {
  verb.add_flag("-q,--quiet", line.quiet, quiet);
  verb.add_flag("-v,--verbose", line.verbose, verbose);
}

void add_threads(CLI::App& verb, CommandLine& line, const std::string& description) {
  add(verb, "--threads", line.common.threads, "N", description)->check(CLI::NonNegativeNumber);
}

// The options of every verb that computes something.
void add_common(CLI::App& verb, CommandLine& line, const std::string& quiet = "print no progress") {
  add_threads(verb, line, "number of threads to compute with (default: all cores)");
  add_verbosity(verb, line, quiet, "print each stage on a line of its own");
}

// Plots, pictures and page take seconds and need packages of their own.
void add_tables_only(CLI::App& verb, CommandLine& line) {
  verb.add_flag(
          "--tables-only", line.common.tables_only,
          "write only the tables and results.csv, without plots, pictures and page (or set ISOBENCH_TABLES_ONLY=1)")
      ->envname("ISOBENCH_TABLES_ONLY");
}

void add_surface(CLI::App& verb, SurfaceArguments& surface) {
  add(verb, "--dataset", surface.dataset, "NAME", "a name from `isobench list datasets`, or the path of a manifest");
  add(verb, "--volume", surface.volume, "FILE", "a volume in a format of docs/INPUTS.md: " + volume_formats_text());
  add(verb, "--isovalue", surface.isovalue, "C", "with --volume: the surface is where the volume has this value");
  verb.add_flag("--exact-isovalue", surface.choices.exact_isovalue,
                "with --volume: refuse an isovalue at which F = C touches itself or fills space, instead of moving it");
  add(verb, "--inside", surface.inside, "SIDE",
      fmt::format("with --volume: the object lies where values are above or below C (default: {})", surface.inside))
      ->check(CLI::IsMember({"above", "below"}));
  add(verb, "--labels", surface.labels, "L,...",
      "with --volume, in place of --isovalue: the object is where the volume has one of these labels; thick slices are "
      "interpolated by distances")
      ->delimiter(',')
      ->allow_extra_args(false);
  add(verb, "--resample", surface.resample, "MM",
      "with --volume: interpolate at a spacing of MM mm along each axis, or of X,Y,Z")
      ->delimiter(',')
      ->allow_extra_args(false);
  add(verb, "--smooth", surface.smooth, "S",
      "with --volume: smooth by a Gaussian with a sigma of S voxels (default: 0; of labels: 1)")
      ->check(CLI::NonNegativeNumber);
  add(verb, "--kernel", surface.kernel, "NAME",
      fmt::format("with --volume: the spline that F is made of (default: {})", surface.kernel))
      ->check(CLI::IsMember({"bspline", "interpolating-bspline", "catmull-rom"}));
  add(verb, "--step", surface.part.step, "N", "with --volume: step N of a series in time; the first is 0");
  add(verb, "--component", surface.part.component, "N", "with --volume: component N of vectors or colours, from 0");
  add(verb, "--array", surface.part.array, "NAME", "with --volume: this array of a VTI file");
  add(verb, "--segment", surface.part.segment, "NAME", "with --volume: this segment of a segmentation (.seg.nrrd)");
  add(verb, "--series", surface.part.series, "N", "with --volume: this series of a folder of DICOM files");
  add(verb, "--save-manifest", surface.save_manifest, "FILE",
      "with --volume: write a manifest to FILE, beside the volume, that gives the same surface as a data set");
  add(verb, "--border", surface.border, "HOW",
      fmt::format(
          "with --volume: close an object that reaches the volume's border, outside it, or refuse it (default: {})",
          surface.border))
      ->check(CLI::IsMember({"close", "refuse"}));
  add(verb, "--frame", surface.frame, "FRAME",
      fmt::format("the mesh's coordinates: lps, ras, lattice, or those of the volume's file (default: {})",
                  surface.frame))
      ->check(CLI::IsMember({"file", "lps", "ras", "lattice"}));
  add(verb, "--min-component", surface.choices.min_component, "V",
      "leave out islands and cavities of the surface that enclose less than V mm³ (default: none)")
      ->check(CLI::NonNegativeNumber);
}

void add_sizing(CLI::App& verb, SizingRequest& sizing) {
  add(verb, "--epsilon", sizing.epsilon, "E", "adaptive: edges of at most 2 E times the local feature size");
  add(verb, "--delta", sizing.delta, "D", "adaptive: edge lengths change by at most D mm per mm");
  add(verb, "--floor", sizing.floor, "F",
      fmt::format("adaptive: edges of at least F voxels (default: {})", sizing.floor));
  add(verb, "--edge-length", sizing.edge_length, "L", "uniform: edges of L mm");
  add(verb, "--vertices", sizing.vertices, "N", "uniform: edges of one length, chosen to give about N vertices");
}

// Which experiment, and how it differs from its config.
void add_experiment(CLI::App& verb, RunArguments& run) {
  verb.add_option("config", run.config,
                  "a TOML file such as experiments/quick.toml, or a results folder; a results folder is continued or, "
                  "with --out, computed again in another folder and compared with it")
      ->required();
  add(verb, "--out", run.out, "FOLDER", "write the results to FOLDER/<name of the experiment> (default: results)");
  add(verb, "--set", run.set, "KEY=VALUE",
      "set a parameter in every method that has it; this is another experiment, so give another --out");
  add(verb, "--seed", run.seeds, "N,...",
      "seeds of the random numbers, in place of the config's, e.g. 7 or 1,2,3; this is another experiment, so give "
      "another --out")
      ->delimiter(',')
      ->allow_extra_args(false);  // the next word is the config
  verb.add_flag("--quick", run.quick, "run the smaller variant that the config describes in [quick]");
}

void add_run(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand("run", "Run an experiment; runs that are done already are kept");
  add_experiment(*verb, line.run);
  add(*verb, "--only", line.run.only, "GLOB",
      "run only runs whose dataset/label, dataset/method or name matches GLOB, e.g. 'skull/*'");
  add(*verb, "--cells", line.run.cells, "LIST",
      "run only these cells of a results folder's plan, by number, e.g. 3-7,12; writes no report");
  add(*verb, "--jobs", line.run.jobs, "N", fmt::format("number of runs at a time (default: {})", line.run.jobs))
      ->check(CLI::Range(1, 1024));
  verb->add_flag("--force", line.run.force, "run again what is done already");
  verb->add_flag("--dry-run", line.run.dry_run, "print what would be run, and run nothing");
  add_tables_only(*verb, line);
  add_common(*verb, line, "print neither progress nor tables");
  verb->callback([&line] { line.action = [&line] { return run_verb(line.run, line.common); }; });
}

void add_submit(CLI::App& app, CommandLine& line) {
  SubmitArguments& submit = line.submit;
  CLI::App* verb = app.add_subcommand("submit", "Submit the missing and failed runs of an experiment to Slurm");
  add_experiment(*verb, submit.run);
  add(*verb, "--chunk", submit.chunk, "N", "number of cells per task (default: as many as take about five minutes)")
      ->check(CLI::Range(1, 1000000));
  add(*verb, "--throttle", submit.throttle, "N", "number of tasks at a time (default: no limit)")
      ->check(CLI::PositiveNumber);
  verb->add_flag("--exclusive-timing", submit.exclusive,
                 "give each task a node of its own and mark its seconds as measured alone");
  verb->add_option("sbatch", submit.sbatch, "after --: further arguments for sbatch, e.g. -- --partition=long");
  add_threads(*verb, line, "processors of each task, and threads of its runs (default: what Slurm gives a task)");
  add_verbosity(*verb, line, "without effect", "without effect");
  verb->callback([&line] { line.action = [&line] { return submit_verb(line.submit, line.common); }; });
}

void add_status(CLI::App& app, CommandLine& line) {
  CLI::App* verb =
      app.add_subcommand("status", "Show which cells of a results folder are done, running, waiting or failed");
  verb->add_option("folder", line.status_folder, "a results folder, e.g. results/paper")->required();
  add_verbosity(*verb, line, "without effect", "list every cell");
  verb->callback([&line] { line.action = [&line] { return status_verb(line.status_folder, line.common); }; });
}

void add_report(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand(
      "report", "Write the tables, results.csv and the page of a results folder again, without meshing");
  verb->add_option("folder", line.report_folder, "a results folder, e.g. results/paper")->required();
  add_tables_only(*verb, line);
  add_common(*verb, line, "print neither progress nor tables");
  verb->callback([&line] { line.action = [&line] { return report_verb(line.report_folder, line.common); }; });
}

void add_compare(CLI::App& app, CommandLine& line) {
  CompareArguments& compare = line.compare;
  CLI::App* verb = app.add_subcommand(
      "compare",
      "Compare two results folders, figure by figure; exit code 1 if they differ in more than seconds and memory");
  verb->add_option("a", compare.a, "a results folder, e.g. results/paper")->required();
  verb->add_option("b", compare.b, "another one")->required();
  add(*verb, "--tolerance", compare.tolerance, "T",
      fmt::format("ignore relative differences of up to T, 0 to 1 (default: {})", compare.tolerance))
      ->check(CLI::Range(0.0, 1.0));
  add_verbosity(*verb, line, "print nothing and only set the exit code", "print seconds and all differences");
  verb->callback([&line] { line.action = [&line] { return compare_verb(line.compare, line.common); }; });
}

void add_mesh(CLI::App& app, CommandLine& line) {
  MeshArguments& mesh = line.mesh;
  CLI::App* verb =
      app.add_subcommand("mesh", "Mesh one dataset or volume file; default sizing: --epsilon 0.5 --delta 0.3");
  add_surface(*verb, mesh.surface);
  add_sizing(*verb, mesh.sizing);
  add(*verb, "--method", mesh.method, "NAME",
      fmt::format("a name from `isobench list methods` (default: {})", mesh.method));
  add(*verb, "--set", mesh.set, "KEY=VALUE", "set a parameter of the method; may be given several times");
  add(*verb, "--seed", mesh.seed, "N", fmt::format("seed of the random numbers (default: {})", mesh.seed));
  add(*verb, "-o,--output", mesh.output, "FILE", "write the mesh to FILE: .vtp, .ply, .off, .obj or .stl");
  add(*verb, "--artefacts", mesh.artefacts, "FOLDER",
      "write topology.vtp (where small features decide the topology), and medial-axis.vtp, sizing.vtp and "
      "particles.vtp if the method has them, to FOLDER");
  add(*verb, "--max-vertices", mesh.max_vertices, "N",
      "refuse, before the work, a mesh that would have more vertices (default: as many as the free memory holds)")
      ->check(CLI::PositiveNumber);
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return mesh_verb(line.mesh, line.common); }; });
}

void add_measure(CLI::App& app, CommandLine& line) {
  MeasureArguments& measure = line.measure;
  CLI::App* verb =
      app.add_subcommand("measure",
                         "Measure a mesh file, by itself or against the surface of a dataset or volume; or "
                         "every mesh of a results folder again");
  verb->add_option("mesh", measure.mesh,
                   "a mesh file of any program, in mm and, if a surface is given, in the surface's world coordinates; "
                   "or a results folder")
      ->required();
  add_surface(*verb, measure.surface);
  add(*verb, "--epsilon", measure.epsilon, "E",
      "compare edges with h0, the longest edge that this epsilon allows; needs a surface");
  add(*verb, "--delta", measure.delta, "D",
      "with --epsilon: the delta that the mesh was asked for, by whose sizes areas and time steps are judged (default: "
      "0.3)");
  add(*verb, "--floor", measure.floor, "F", fmt::format("h0 is at least F voxels (default: {})", measure.floor));
  verb->add_flag("--metrics-of-use", measure.metrics_of_use,
                 "of a results folder: add the metrics that take seconds, such as the condition of linear systems, to "
                 "every run; a mesh file always has them");
  verb->add_flag("--json", measure.json, "print every figure as JSON");
  add_tables_only(*verb, line);
  add_common(*verb, line);
  verb->callback([&line] { line.action = [&line] { return measure_verb(line.measure, line.common); }; });
}

void add_list(CLI::App& app, CommandLine& line) {
  CLI::App* list = app.add_subcommand(
      "list",
      "List datasets, methods, metrics, columns of results.csv and experiments, with units, ranges and defaults");
  list->add_option("topic", line.topic, "datasets, methods, metrics, columns or experiments (default: all of them)");
  list->callback([&line] { line.action = [&line] { return list_verb(line.topic); }; });
}

void add_fetch(CLI::App& app, CommandLine& line) {
  CLI::App* fetch = app.add_subcommand("fetch", "Download datasets into the cache and check their SHA-256");
  fetch->add_option("dataset", line.fetch, "names from `isobench list datasets` (default: all)");
  add_verbosity(*fetch, line, "print no progress", "print each stage on a line of its own");
  fetch->callback([&line] { line.action = [&line] { return fetch_verb(line.fetch, line.common); }; });
}

// Hidden: what `run` starts for every cell.
void add_cell(CLI::App& app, CommandLine& line) {
  CLI::App* cell = app.add_subcommand("cell", "")->group("");
  cell->add_option("--plan", line.cell.plan)->required();
  cell->add_option("--run", line.cell.run)->required();
  cell->add_option("--folder", line.cell.folder)->required();
  cell->add_option("--match-vertices", line.cell.match_vertices);
  cell->add_option("--progress-fd", line.cell.progress_fd);
  add_common(*cell, line);
  cell->callback([&line] { line.action = [&line] { return cell_verb(line.cell, line.common); }; });
}

// For an unknown verb or option CLI11 says only that it was not expected. These functions also name the nearest one.
void check_verb(const CLI::App& app, const std::string& word) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) {
    if (verb->get_name() == word) return;
    if (!verb->get_group().empty()) verbs.push_back(verb->get_name());
  }
  throw UsageError("unknown verb '" + word + "'" + suggestion(word, verbs));
}

std::string unexpected(const CLI::App& verb) {
  const std::string word = verb.remaining().empty() ? "" : verb.remaining().front();
  if (!word.starts_with("-")) return "unexpected argument '" + word + "'";
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& each : option->get_lnames()) known.push_back("--" + each);
  }
  const std::string nearest = nearest_name(name, known);
  return "unknown option '" + name + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

[[noreturn]] void throw_usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  const std::string verb = verbs.empty() ? "" : verbs.front()->get_name() + " ";
  const bool extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::string message = extra ? unexpected(verbs.empty() ? app : *verbs.front()) : error.what();
  throw UsageError(message + "; see isobench " + verb + "--help");
}

void add_verbs(CLI::App& app, CommandLine& line) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(0, 1);
  add_run(app, line);
  add_mesh(app, line);
  add_measure(app, line);
  add_list(app, line);
  add_fetch(app, line);
  add_report(app, line);
  add_compare(app, line);
  add_submit(app, line);
  add_status(app, line);
  add_cell(app, line);
  app.footer(
      "`isobench VERB --help` describes a verb. Exit codes: 0 done; 1 some runs failed (the others are stored), or "
      "another error; 2 a mistake in the command line or in a config; 3 data missing, damaged or without a surface; "
      "130 interrupted.");
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Meshes isosurfaces by several methods and measures every mesh in the same way.", "isobench");
  CommandLine line;
  bool version = false;
  add_verbs(app, line);
  app.add_flag("--version", version, "print version, commit and libraries");
  if (argc > 1 && argv[1][0] != '-') check_verb(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    throw_usage_error(app, error);
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

// Otherwise the end of the output, which is still in memory, would be lost without a word.
void flush_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error(std::string("the output cannot be written: ") + std::strerror(errno) + "; free some space");
}

}  // namespace

int command_line(int argc, char** argv) {
  try {
    const int code = parse_and_run(argc, argv);
    flush_output();
    return code;
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
