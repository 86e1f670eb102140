// Scripts of a few lines stand in for external programs.
#include <gtest/gtest.h>

#include <sstream>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/external/exchange.h"
#include "isobench/methods/external/program.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;
using Settings = std::map<std::string, std::string>;

/// A sphere on a lattice that is rotated, mirrored and far from the origin of the world.
Isosurface mirrored_sphere() {
  FloatVolume volume = sample_phantom(phantom("sphere"), 24);
  volume.lattice.direction << 0, 0, 1, 1, 0, 0, 0, -1, 0;
  volume.lattice.origin = {100.0, -50.0, 7.0};
  for (float& sample : volume.samples) sample += 10.0F;
  return {std::move(volume), 10.0};
}

struct Trial {
  TriangleMesh mesh;
  std::string error;
  std::string log;
  std::string notes;
  std::map<std::string, double> counters;
  double program_memory_mb = 0.0;
  double program_cpu_seconds = 0.0;
  std::vector<std::string> left_behind;
};

Trial run(const std::string& script, Settings settings = {}, const std::string& arguments = "{mesh} {output}") {
  const TestFolder folder;
  const fs::path program = folder.write("program.sh", script);
  fs::create_directory(folder.path() / "run");
  const Method& external = method("external");
  Parameters parameters(external.parameters);
  settings.try_emplace("command", "sh " + program.string() + " " + arguments);
  for (const auto& [name, value] : settings) parameters.set_text(external.parameters, name, value);
  const Isosurface surface = mirrored_sphere();
  SizingRequest request;
  request.edge_length = 4.0;
  Monitor monitor;
  monitor.keep_files_in(folder.path() / "run");
  Trial result;
  try {
    result.mesh = external.mesh(MeshingTask(surface, request, parameters, 7), monitor);
  } catch (const Error& error) {
    result.error = error.what();
  }
  result.log = read_text_or_empty(folder.path() / "run" / "external.txt");
  for (const std::string& note : monitor.notes()) result.notes += note + "\n";
  result.counters = monitor.counters();
  result.program_memory_mb = monitor.program_memory_mb();
  for (const StageTime& stage : monitor.stages()) {
    if (stage.name == "program") result.program_cpu_seconds = stage.cpu_seconds;
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "run")) {
    result.left_behind.push_back(entry.path().filename().string());
  }
  std::sort(result.left_behind.begin(), result.left_behind.end());
  return result;
}

void expect_the_sphere(const TriangleMesh& mesh, const std::string& what) {
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U) << what;
  EXPECT_EQ(facts.euler, 2) << what;
  EXPECT_GT(facts.volume, 0.0) << what;
  const Isosurface surface = mirrored_sphere();
  for (const Eigen::Vector3d& x : mesh.vertices) {
    const Jet jet = surface.value_gradient(x);
    // STL has single precision, and the sphere is 100 mm from the origin.
    ASSERT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-4) << what;
  }
}

TEST(External, AMeshComesBackAsItWentInEveryFormatAndFrame) {
  for (const std::string frame : {"lattice", "world"}) {
    for (const std::string ending : {".ply", ".off", ".obj", ".stl", ".vtp"}) {
      const Trial made =
          run("cp \"$1\" \"$2\"", {{"mesh", "mesh" + ending}, {"output", "output" + ending}, {"frame", frame}});
      EXPECT_EQ(made.error, "");
      expect_the_sphere(made.mesh, std::string(frame).append(" ").append(ending));
      EXPECT_EQ(made.counters.at("external/components turned"), 0.0) << frame << ending;
    }
  }
}

TEST(External, AnOutputInAnotherFrameIsBroughtHome) {
  // The program gets the lattice frame and answers in node numbers or in world coordinates.
  const Isosurface surface = mirrored_sphere();
  Monitor monitor;
  const TestFolder folder;
  const Trial local = run("cp \"$1\" \"$2\"");
  TriangleMesh index = local.mesh;
  for (Eigen::Vector3d& x : index.vertices) x = x.cwiseQuotient(surface.lattice().spacing);
  write_mesh(index, folder.path() / "index.ply");
  write_mesh(to_world(local.mesh, surface.lattice()), folder.path() / "world.ply");
  for (const std::string frame : {"index", "world"}) {
    const std::string path = (folder.path() / (frame + ".ply")).string();
    const Trial made = run("cp " + path + " \"$2\"", {{"output_frame", frame}});
    EXPECT_EQ(made.error, "");
    expect_the_sphere(made.mesh, frame);
  }
}

TEST(External, AMeshInsideOutIsTurned) {
  // Reverses the corners of each triangle.
  const Trial made = run("awk '/^f /{print $1, $4, $3, $2; next} {print}' \"$1\" > \"$2\"",
                         {{"mesh", "mesh.obj"}, {"output", "output.obj"}});
  EXPECT_EQ(made.error, "");
  expect_the_sphere(made.mesh, "turned");
  EXPECT_EQ(made.counters.at("external/components turned"), 1.0);
}

TEST(External, WhatIsNoTriangleIsReadAsItCanBe) {
  // Each triangle as a quadrilateral that names its last corner twice, and a line.
  const Trial made = run("awk '/^f /{print $0, $4; next} {print}' \"$1\" > \"$2\"; echo l 1 2 >> \"$2\"",
                         {{"mesh", "mesh.obj"}, {"output", "output.obj"}});
  EXPECT_EQ(made.error, "");
  expect_the_sphere(made.mesh, "quadrilaterals");
  EXPECT_NE(made.notes.find("output.obj: its 1 line is no part of a surface; left out\n"), std::string::npos)
      << made.notes;
}

TEST(External, BarePointsAreProjectedAndClosed) {
  // Prints the vertices of the marching-cubes mesh, rounded, one of them twice.
  const std::string script =
      "awk '/^v /{printf \"%.2f %.2f %.2f\\n\", $2, $3, $4} END {printf \"%.2f %.2f %.2f\\n\", $2, $3, $4}' \"$1\" | "
      "grep -v '^0.00 0.00' > \"$2\"; head -n 1 \"$2\" > first; cat first >> \"$2\"";
  const Settings settings = {{"mesh", "mesh.obj"}, {"output", "points.xyz"}, {"project", "true"}};
  const Trial made = run(script, settings);
  EXPECT_EQ(made.error, "");
  expect_the_sphere(made.mesh, "points");
  EXPECT_GE(made.counters.at("external/repeated points"), 1.0);
  EXPECT_GT(made.counters.at("external/projected max mm"), 0.0);
  EXPECT_LT(made.counters.at("external/projected max mm"), 0.01);
}

TEST(External, EveryPlaceholderHasItsValueAndFilesAreThere) {
  const Trial made =
      run("cp \"$1\" \"$2\"; shift 2; echo \"$@\"; test -s volume.nrrd && test -s sizing.nrrd && echo both; "
          "echo $OMP_NUM_THREADS; echo 'program 1.2' ",
          {{"version", "sh -c 'echo Version of the program; echo 1.2'"}},
          "{mesh} {output} {volume} {sizing} c={isovalue} {inside} h={edge_length} {edge_length_min} {edge_length_max} "
          "n={vertices} a={area} {voxel} s={seed} t={threads} {start} {edge_length*2}");
  EXPECT_EQ(made.error, "");
  const Isosurface surface = mirrored_sphere();
  const double area = mesh_facts(made.mesh).area;
  const double vertices = 2.0 * area / (std::sqrt(3.0) * 16.0);
  const std::string threads = std::to_string(external::threads_in_use());
  EXPECT_NE(made.log.find("volume.nrrd sizing.nrrd c=10 above h=4 4 4 n=" + std::to_string(std::llround(vertices))),
            std::string::npos)
      << made.log;
  EXPECT_NE(made.log.find(" s=7 t=" + threads + " " + fs::current_path().string() + " 8\nboth\n" + threads + "\n"),
            std::string::npos)
      << made.log;
  EXPECT_NE(made.notes.find("version 1.2\n"), std::string::npos) << made.notes;
  EXPECT_NE(made.notes.find("ran sh /"), std::string::npos) << made.notes;
  EXPECT_NE(made.log.find("[ended with exit code 0, "), std::string::npos) << made.log;
  EXPECT_EQ(made.left_behind, std::vector<std::string>{"external.txt"});
}

TEST(External, TheWorkingFolderIsKeptIfAskedFor) {
  const Trial made = run("cp \"$1\" \"$2\"", {{"keep", "true"}});
  EXPECT_EQ(made.left_behind, (std::vector<std::string>{"external", "external.txt", "mesh.ply", "output.ply"}));
}

TEST(External, TimeAndMemoryOfTheProgramAreBooked) {
  // A child of the program holds twenty megabytes of text.
  const Trial made =
      run("cp \"$1\" \"$2\"; sh -c 'x=$(head -c 20000000 /dev/zero | tr \"\\0\" x); sleep 0.6; echo ${#x}'");
  EXPECT_EQ(made.error, "");
  EXPECT_GT(made.program_memory_mb, 20.0);
  EXPECT_GT(made.program_cpu_seconds, 0.005);
  EXPECT_GT(made.counters.at("external/program seconds"), 0.5);
}

TEST(External, AFailureOfTheProgramIsReportedWithTheEndOfItsLog) {
  struct Defect {
    std::string script;
    std::string part;
  };
  const std::vector<Defect> defects = {
      {"echo out of luck; exit 3", "sh ended with exit code 3; its log ends: out of luck"},
      {"kill -SEGV $$", "sh ended by SIGSEGV"},
      {"echo done", "succeeded but did not write output.ply in its working folder; its log ends: done"},
      {"cp \"$1\" elsewhere.ply", "did not write output.ply in its working folder; it wrote elsewhere.ply there"},
      {"mkdir \"$2\"", "did not write output.ply"},
      {": > \"$2\"", "output.ply: the file is empty"},
      {"head -c 2000 \"$1\" > \"$2\"", "output.ply: "},
      {"printf 'ply\\nformat ascii 1.0\\nelement vertex 1\\nproperty float x\\nproperty float y\\nproperty float z\\n"
       "element face 1\\nproperty list uchar int vertex_indices\\nend_header\\n0 0 0\\n3 0 1 2\\n' > \"$2\"",
       "names a vertex that is not there"},
      {"printf 'ply\\nformat ascii 1.0\\nelement vertex 1\\nproperty float x\\nproperty float y\\nproperty float z\\n"
       "end_header\\nnan 0 0\\n' > \"$2\"",
       "not finite"},
  };
  for (const Defect& defect : defects) {
    const Trial made = run(defect.script);
    EXPECT_NE(made.error.find(defect.part), std::string::npos) << defect.script << '\n' << made.error;
    EXPECT_NE(made.log.find("$ sh "), std::string::npos) << made.log;
    EXPECT_EQ(made.left_behind, std::vector<std::string>{"external.txt"}) << defect.script;
  }
  const Trial none = run("", {{"command", "no-such-program-here {volume}"}});
  EXPECT_NE(none.error.find("no program 'no-such-program-here' in PATH"), std::string::npos) << none.error;
}

TEST(External, WhatAProgramLeavesRunningIsKilled) {
  const TestFolder folder;
  const std::string file = (folder.path() / "pid").string();
  const Trial made = run("setsid sh -c 'echo $$ > " + file + "; exec sleep 1000' & while [ ! -s " + file +
                         " ]; do sleep 0.01; done; cp \"$1\" \"$2\"");
  EXPECT_EQ(made.error, "");
  int pid = 0;
  std::ifstream(file) >> pid;
  ASSERT_GT(pid, 0);
  EXPECT_FALSE(fs::exists("/proc/" + std::to_string(pid) + "/exe"));
}

TEST(External, CancellingStopsTheProgram) {
  const TestFolder folder;
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(external::run_program({{"sleep", "1000"}, folder.path(), folder.path() / "log.txt", 0}, monitor),
               Cancelled);
}

TEST(External, MistakesShowBeforeAnythingRuns) {
  const ParameterSchema& schema = method("external").parameters;
  Parameters parameters(schema);
  const std::vector<std::pair<std::string, std::string>> wrong = {{"command", ""},
                                                                  {"command", "a {volum}"},
                                                                  {"command", "a 'b"},
                                                                  {"command", "a {volume"},
                                                                  {"command", "a {edge_length*}"},
                                                                  {"version", "a \"b"},
                                                                  {"volume", "volume.mha"},
                                                                  {"volume", "../volume.nrrd"},
                                                                  {"mesh", "mesh.nrrd"},
                                                                  {"output", "/tmp/mesh.ply"},
                                                                  {"output", "mesh.xml"},
                                                                  {"frame", "voxels"}};
  for (const auto& [name, value] : wrong) {
    EXPECT_THROW(parameters.set(schema, name, value), UsageError) << name << " = " << value;
  }
  try {
    parameters.set(schema, "command", "a {volum}");
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'volume'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace isobench
