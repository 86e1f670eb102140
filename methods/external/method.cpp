#include "isobench/methods/method.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <fstream>

#include "isobench/foundation/files/scratch_folder.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/names.h"
#include "isobench/methods/external/command_line.h"
#include "isobench/methods/external/exchange.h"
#include "isobench/methods/external/program.h"

namespace isobench {
namespace external {
namespace {

namespace fs = std::filesystem;

constexpr const char* log_name = "external.txt";

// The files of a run: the folder in which the program works, and the log. The run's folder `kept_in` keeps the log, and
// keeps the program's folder if `keep` is set. Without such a folder everything is removed.
class Workplace {
 public:
  Workplace(const fs::path& kept_in, bool keep) : keep_(keep && !kept_in.empty()) {
    if (kept_in.empty()) scratch_.emplace(fs::temp_directory_path(), "isobench-external-");
    const fs::path& home = kept_in.empty() ? scratch_->path() : kept_in;
    log_ = home / log_name;
    folder_ = home / (keep_ ? "external" : ".external");
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~Workplace() {
    std::error_code ignored;
    if (!keep_) fs::remove_all(folder_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const fs::path& folder() const { return folder_; }
  const fs::path& log() const { return log_; }
  bool log_stays() const { return !scratch_; }

 private:
  std::optional<ScratchFolder> scratch_;  // if nothing is kept
  fs::path folder_;
  fs::path log_;
  bool keep_;
};

// How a program ended, and the last lines of what it printed.
struct Logged {
  ProgramEnd end;
  std::string tail;
};

// Runs a program; the log gets its command line before its output and its end after it.
Logged run_logged(const std::vector<std::string>& words, const Workplace& place, std::size_t lines, Monitor& monitor) {
  std::ofstream(place.log(), std::ios::app) << "$ " << joined(words) << '\n' << std::flush;
  const std::uintmax_t begin = fs::file_size(place.log());
  Logged logged;
  logged.end = run_program({words, place.folder(), place.log(), threads_in_use()}, monitor);
  logged.tail = last_lines(place.log(), lines, begin);
  std::ofstream(place.log(), std::ios::app)
      << fmt::format("[{}, {:.3f} s]\n", to_string(logged.end.exit), logged.end.seconds);
  return logged;
}

void note_version(const MeshingTask& task, const Workplace& place, Monitor& monitor) {
  const std::vector<std::string> words = split_words(task.parameters.text("version"));
  if (words.empty()) return;
  std::string version = "unknown";
  try {
    const Logged logged = run_logged(words, place, 1, monitor);
    if (logged.end.exit.succeeded() && !logged.tail.empty()) version = logged.tail;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {  // a mesh of an unknown version is still a mesh
  }
  monitor.note("external: version " + version);
}

std::string files_in(const fs::path& folder, const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::find(known.begin(), known.end(), name) == known.end()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  if (names.size() > 5) names.resize(5);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string log_text(const Logged& logged) { return logged.tail.empty() ? "" : "; its log ends: " + logged.tail; }

// The file that the program had to write. Throws Error if the program failed or did not write it.
fs::path output_of(const MeshingTask& task, const Workplace& place, const std::string& program, const Logged& logged) {
  if (!logged.end.exit.succeeded()) {
    throw Error(program + " " + to_string(logged.end.exit) + log_text(logged));
  }
  const std::string& name = task.parameters.text("output");
  if (fs::is_regular_file(place.folder() / name)) return place.folder() / name;
  std::vector<std::string> ours = {name};
  for (const char* file : file_parameters) ours.push_back(task.parameters.text(file));
  const std::string others = files_in(place.folder(), ours);
  throw Error(fmt::format("{} succeeded but did not write {} in its working folder{}{}", program, name,
                          others.empty() ? "" : "; it wrote " + others + " there", log_text(logged)));
}

std::vector<std::string> placeholders(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    const std::vector<std::string> of_word = placeholders_in(word);
    names.insert(names.end(), of_word.begin(), of_word.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  std::vector<std::string> words = split_words(task.parameters.text("command"));
  if (words.empty()) throw UsageError("external needs a command");
  find_program(words.front());  // throws before any work is done for the program
  const Workplace place(monitor.files(), task.parameters.flag("keep"));
  note_version(task, place, monitor);
  const std::map<std::string, Value> values = hand_over(task, placeholders(words), place.folder(), monitor);
  for (std::string& word : words) word = filled(word, values);
  monitor.note("external: ran " + joined(words));
  if (place.log_stays()) monitor.note(fmt::format("external: its output is in {}", log_name));
  Logged logged;
  {
    const auto stage = monitor.stage("program");
    logged = run_logged(words, place, 3, monitor);
  }
  monitor.book_program_memory(logged.end.peak_memory_mb);
  monitor.set("external/program seconds", logged.end.seconds);
  monitor.set("external/program peak MB", logged.end.peak_memory_mb);
  return take_back(task, output_of(task, place, words.front(), logged), monitor);
}

// What is wrong with a command line, as far as can be told without running it; "" if nothing is.
std::string command_problem(const std::string& text) {
  try {
    const std::vector<std::string> words = split_words(text);
    if (words.empty()) return "give the program and its arguments";
    const std::vector<std::string> known = known_placeholders();
    for (const std::string& name : placeholders(words)) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      return "unknown placeholder {" + name + "}" + suggestion(name, known);
    }
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

std::string version_problem(const std::string& text) {
  try {
    split_words(text);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

template <const char* const* Endings>
std::string name_problem(const std::string& name) {
  if (!is_plain_name(name)) return "'" + name + "' is not the plain name of a file";
  const std::string ending = fs::path(name).extension().string();
  std::string known;
  for (const char* const* one = Endings; *one != nullptr; ++one) {
    if (ending == *one) return "";
    known += (known.empty() ? "" : ", ") + std::string(*one);
  }
  return "'" + name + "' must have one of these endings: " + known;
}

constexpr const char* volume_endings[] = {".nrrd", ".vti", nullptr};
constexpr const char* mesh_endings[] = {".ply", ".off", ".obj", ".stl", ".vtp", nullptr};
constexpr const char* output_endings[] = {".ply", ".off",  ".obj",  ".stl", ".vtp", ".vtk",
                                          ".vtu", ".nrrd", ".nhdr", ".xyz", ".txt", nullptr};

ParameterSpec file(const char* name, const char* standard, const char* description,
                   std::string (*problem)(const std::string&)) {
  ParameterSpec spec{name, std::string(standard), "", description};
  spec.problem = problem;
  return spec;
}

ParameterSpec choice(const char* name, std::vector<std::string> choices, const char* description) {
  ParameterSpec spec{name, choices.front(), "", description};
  spec.choices = std::move(choices);
  return spec;
}

ParameterSchema schema() {
  ParameterSpec command{"command", std::string(), "", "the program and its arguments, with {placeholders}"};
  command.required = true;
  command.problem = command_problem;
  ParameterSpec version{"version", std::string(), "",
                        "a command that prints the version of the program as its last line"};
  version.problem = version_problem;
  return {
      command,
      version,
      file("volume", "volume.nrrd", "name of the file {volume}, NRRD or VTI", name_problem<volume_endings>),
      choice("values", {"coefficients", "nodes", "samples"},
             "what the volume contains: the coefficients of the spline, F at the nodes, or the prepared samples"),
      file("mesh", "mesh.ply", "name of the file {mesh}, the marching-cubes mesh of F = c", name_problem<mesh_endings>),
      file("sizing", "sizing.nrrd", "name of the file {sizing}, h at the nodes in mm", name_problem<volume_endings>),
      choice("frame", {"lattice", "world"}, "frame of the files that the program gets"),
      file("output", "output.ply", "name of the file {output}, the mesh or points that the program writes",
           name_problem<output_endings>),
      choice("returns", {"mesh", "points"},
             "what the output contains; .nrrd, .nhdr, .xyz and .txt always contain points"),
      choice("output_frame", {"same", "lattice", "world", "index"}, "frame of the output; same: that of `frame`"),
      {"project", false, "", "project the vertices of the output to F = c"},
      {"keep", false, "", "keep the working folder of the program, \"external\", with the run"}};
}

}  // namespace

int threads_in_use() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

bool returns_points(const Parameters& parameters) {
  const std::string ending = fs::path(parameters.text("output")).extension().string();
  const bool bare = ending == ".nrrd" || ending == ".nhdr" || ending == ".xyz" || ending == ".txt";
  return bare || parameters.text("returns") == "points";
}

}  // namespace external

Method method_external() {
  Method method;
  method.name = "external";
  method.summary = "Any program: it gets F as a volume or as a marching-cubes mesh, and writes a mesh or points";
  method.deterministic = false;
  method.parameters = external::schema();
  method.mesh = external::mesh;
  return method;
}

}  // namespace isobench
