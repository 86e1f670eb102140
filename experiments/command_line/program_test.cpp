// Exit codes and messages of the program, and what its verbs print.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/experiments/terminal/terminal.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

class ProgramVerbs : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments) { return run_program(folder_.path(), arguments); }
  void expect(const std::vector<std::string>& arguments, int code, const std::string& sentence) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << "got: " << outcome.err;
    EXPECT_EQ(outcome.out, "");  // stdout is for results
  }
  TestFolder folder_;
};

const std::vector<std::string> mesh_torus = {"mesh", "--dataset", "torus", "--method", "marching-cubes", "-q"};

TEST_F(ProgramVerbs, UsageMistakesExitWith2) {
  expect({"rnu"}, 2, "did you mean 'run'?");
  expect({"run", "nowhere.toml"}, 2, "nowhere.toml");
  expect({"mesh", "--dataset", "torsu", "--epsilon", "1", "--delta", "0.5"}, 2, "did you mean 'torus'?");
  expect(with(mesh_torus, {"--epsilon", "-1", "--delta", "0.3"}), 2, "epsilon");
  expect(with(mesh_torus, {"--epsilon", "nan", "--delta", "0.3"}), 2, "epsilon");
  expect(with(mesh_torus, {"--epsilon", "much", "--delta", "0.3"}), 2, "--epsilon");
  expect(with(mesh_torus, {"--edge-length", "2", "--vertices", "100"}), 2, "edge");
  expect(with(mesh_torus, {"--edge-length", "2", "-o", "mesh.stp"}), 2, "unknown ending '.stp'");
  expect(with(mesh_torus, {"--edge-length", "2", "-o", "."}), 2, ".: is a folder; name a file in it");
  expect(with(mesh_torus, {"--edge-length", "2", "-o", "no/such/mesh.ply"}), 2, "does not exist");
  expect(with(mesh_torus, {"--edge-length", "2", "--frobnicate"}), 2,
         "unknown option '--frobnicate'; see isobench mesh");
  expect(with(mesh_torus, {"--edge-lenght", "2"}), 2, "did you mean '--edge-length'?");
  expect({"list", "methods", "metrics"}, 2, "unexpected argument 'metrics'");
  expect({"mesh", "--dataset", "torus", "--edge-length", "2", "--method", "partcles"}, 2, "did you mean 'particles'?");
  expect({"mesh", "--dataset", "torus", "--edge-length", "2", "--set", "sweps=3"}, 2, "did you mean 'sweeps'?");
  expect({"mesh", "--volume", "scan.nrrd", "--edge-length", "2"}, 2, "--isovalue");
  expect({"measure", "mesh.ply", "--epsilon", "0.5"}, 2, "--epsilon needs the surface");
  expect({"measure", "mesh.ply", "--volume", "scan.nrrd"}, 2, "--isovalue");
  expect({"measure", "mesh.ply", "--isovalue", "1"}, 2, "--volume");
  expect({"measure", "mesh.ply", "--dataset", "torus", "--volume", "scan.nrrd"}, 2, "either --dataset or --volume");
  expect({"list", "metohds"}, 2, "did you mean 'methods'?");
}

TEST_F(ProgramVerbs, BadDataExitWith3) {
  expect({"mesh", "--volume", "nowhere.nrrd", "--isovalue", "1", "--edge-length", "2", "-q"}, 3, "nowhere.nrrd");
  folder_.write("empty.nrrd", "");
  expect({"mesh", "--volume", "empty.nrrd", "--isovalue", "1", "--edge-length", "2", "-q"}, 3, "empty.nrrd");
  folder_.write("mesh.ply", "no mesh\n");
  expect({"measure", "mesh.ply", "--dataset", "torus", "-q"}, 3, "mesh.ply");
  expect({"report", "results/none"}, 3, "not a results folder");
}

TEST_F(ProgramVerbs, HostileFilesExitWith3AndOneSentence) {
  const auto refused = [&](const std::string& name, const std::string& bytes, const std::string& sentence) {
    SCOPED_TRACE(name);
    folder_.write(name, bytes);
    const bool mesh = name.starts_with("mesh");
    const Outcome outcome = mesh ? run({"measure", name, "--dataset", "torus", "-q"})
                                 : run({"mesh", "--volume", name, "--isovalue", "1", "--edge-length", "2", "--method",
                                        "marching-cubes", "-q"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  refused("mesh.off", "OFF\n3 1 0\n" + corners + "3 0 1 3\n", "names vertex 3, but the vertices are 0 to 2");
  refused("mesh2.off", "OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "are not finite");
  refused("mesh3.off", "OFF\n3 0 0\n" + corners, "no triangles");
  refused("mesh4.off", "OFF\n900000000000 900000000000 0\n" + corners, "truncated");
  refused("mesh.stl", std::string(80, ' ') + "\xff\xff\xff\xff", "truncated");
  refused("mesh.vtp",
          "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"900000000000\"/></PolyData></VTKFile>",
          "no coordinates");
  refused("scan.nrrd", "NRRD0004\ntype: float\ndimension: 3\nsizes: 60000 60000 200\nencoding: raw\n\n1234",
          "truncated");
  refused("scan.mha",
          "NDims = 3\nDimSize = 2147483647 2147483647 2147483647\nElementType = MET_FLOAT\n"
          "ElementDataFile = LOCAL\n",
          "not that of a 3-D volume");
  refused("scan.vti", "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"5 -5 0 9 0 9\"/></VTKFile>",
          "not that of a 3-D");
}

TEST_F(ProgramVerbs, DegenerateMeshesAreMeasured) {
  // Triangles without area, with one corner three times, with two corners at one place, and far away have figures, too.
  folder_.write("flat.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n2 0 0\n1 0 0\n1e9 0 0\n3 0 1 2\n3 1 1 1\n3 0 1 3\n3 0 2 4\n");
  const Outcome outcome = run({"measure", "flat.off", "--dataset", "torus", "--json", "-q"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"radius_ratio_min\": 0"), std::string::npos) << outcome.out;
  folder_.write("far.off", "OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1e300 0\n3 0 1 2\n");
  expect({"measure", "far.off", "--dataset", "torus", "-q"}, 3, "coordinates must be in mm");
}

TEST_F(ProgramVerbs, ARecordFromElsewhereRemovesNothingOutsideItsFolder) {
  folder_.write("precious/run.json", "{}");
  const std::string request =
      R"({"run": "../../precious", "dataset": "torus", "dataset_checksum": "0", "method": "marching-cubes",
"method_revision": 1, "label": "x", "parameters": {}, "epsilon": null, "delta": null, "floor_voxels": 0.5,
"edge_length": 2.0, "vertices": null, "match_scale": 1.0, "seed": 1, "metrics_revision": 0,
"limit_minutes": null, "limit_memory_gb": null})";
  folder_.write("results/x/plan.json", R"({"schema_version": 1, "runs": [)" + request + "]}");
  expect({"measure", "results/x"}, 3, "'../../precious' cannot be the name of a run's folder");
  expect({"report", "results/x"}, 3, "plan.json");
  expect({"cell", "--plan", "results/x/plan.json", "--run", "../../precious", "--folder", "."}, 3, "plan.json");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "precious/run.json"));
}

TEST_F(ProgramVerbs, RunsWithoutUsableDataExitWith3AndAreRecorded) {
  folder_.write("own.toml", R"(title = "own"
licence = "own"
source = "own"
isovalue = 0.5
inside = "above"
prepare = []
[data]
folder = "own"
files = [ { name = "scan.nrrd", sha256 = "0000000000000000000000000000000000000000000000000000000000000000" } ]
)");
  std::filesystem::create_directory(folder_.path() / "own");
  folder_.write("own/scan.nrrd", "NRRD0004\n");
  folder_.write("x.toml", R"(dataset = "own.toml"
[sampling]
edge_length = 2
[[method]]
name = "marching-cubes"
)");
  const Outcome outcome = run({"run", "x.toml"});
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("| failed: "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("scan.nrrd"), std::string::npos) << outcome.err;
}

TEST_F(ProgramVerbs, MeshThenMeasureAgree) {
  const Outcome meshed = run(with(mesh_torus, {"--epsilon", "0.5", "--delta", "0.3", "-o", "torus.vtp"}));
  ASSERT_EQ(meshed.code, 0) << meshed.err;
  EXPECT_EQ(meshed.err, "");
  EXPECT_NE(meshed.out.find("Euler 0 (surface 0"), std::string::npos) << meshed.out;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "torus.vtp"));
  const Outcome measured = run({"measure", "torus.vtp", "--dataset", "torus", "--epsilon", "0.5", "-q"});
  ASSERT_EQ(measured.code, 0) << measured.err;
  // The mesh went to world coordinates, into a file and back, and still has the same figures, line by line. Those of
  // use are measured only when asked for.
  const std::size_t begin = meshed.out.find("size ");
  const std::size_t end = meshed.out.find("frame   ");
  const std::size_t of_use = measured.out.find("time step ");
  ASSERT_NE(end, std::string::npos) << meshed.out;
  ASSERT_NE(of_use, std::string::npos) << measured.out;
  EXPECT_EQ(measured.out.substr(0, of_use), meshed.out.substr(begin, end - begin));
}

TEST_F(ProgramVerbs, MeshLeavesArtefactsInAFolder) {
  const std::vector<std::string> sized = {"mesh", "--dataset", "sphere", "--epsilon", "1", "--delta", "0.5", "-q"};
  expect(with(sized, {"--artefacts", "nowhere"}), 2, "nowhere");
  std::filesystem::create_directory(folder_.path() / "here");
  const Outcome outcome = run(with(sized, {"--artefacts", "here"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "here" / "medial-axis.vtp"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "here" / "topology.vtp"));
}

TEST_F(ProgramVerbs, MeshWithoutASizingTakesThePapersAndSaysSo) {
  const std::vector<std::string> ball = {"mesh", "--dataset", "small.toml"};
  const std::string says = "no sizing was given: taking --epsilon 0.5 --delta 0.3\n";
  folder_.write("small.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  const Outcome unsized = run(ball);
  ASSERT_EQ(unsized.code, 0) << unsized.err;
  EXPECT_NE(unsized.err.find(says), std::string::npos) << unsized.err;
  const Outcome sized = run(with(ball, {"--epsilon", "0.5", "--delta", "0.3"}));
  EXPECT_EQ(sized.err.find(says), std::string::npos) << sized.err;
  EXPECT_EQ(unsized.out.substr(0, unsized.out.find("\ntime")), sized.out.substr(0, sized.out.find("\ntime")));
  expect(with(ball, {"--epsilon", "0.5"}), 2, "epsilon is given without delta");
}

TEST_F(ProgramVerbs, MeshSaysWhatItWillCostAndRefusesTooMuch) {
  folder_.write("small.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  const std::vector<std::string> ball = {"mesh", "--dataset", "small.toml"};
  const Outcome done = run(with(ball, {"--edge-length", "4"}));
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(done.err.find("expected: about "), std::string::npos) << done.err;
  EXPECT_EQ(done.out.find("note "), std::string::npos) << done.out;
  for (const std::vector<std::string>& coarse :
       {std::vector<std::string>{"--edge-length", "500"}, {"--vertices", "3"}}) {
    const Outcome least = run(with(ball, coarse));
    EXPECT_EQ(least.code, 0) << least.err;
    EXPECT_NE(least.out.find(coarse[0] == "--vertices" ? "3 vertices were asked for" : "less than one edge of 500 mm"),
              std::string::npos)
        << least.out;
  }
  expect(with(ball, {"--edge-length", "1e-5", "-q"}), 2, "of memory are free; ask for longer edges");
  expect(with(ball, {"--edge-length", "4", "--max-vertices", "50", "-q"}), 2, "more than --max-vertices 50; ");
  expect(with(ball, {"--epsilon", "0.5", "--delta", "0.3", "--max-vertices", "20", "-q"}), 2, "more than --max-vert");
}

TEST_F(ProgramVerbs, AMethodThatIgnoresTheSizingNeedsNone) {
  for (const char* method : {"marching-cubes", "flying-edges"}) {
    const Outcome outcome = run({"mesh", "--dataset", "torus", "--method", method, "-q"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.find("sizing that was asked for"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("edges / h0    not measured: needs a sizing (--epsilon)\n"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("distance      mean "), std::string::npos) << outcome.out;
  }
}

// The value of a figure in the JSON that `measure --json` prints, as text.
std::string json_value(const Outcome& measured, const std::string& figure) {
  EXPECT_EQ(measured.code, 0) << measured.err;
  const std::string key = fmt::format("\"{}\": ", figure);
  const std::size_t at = measured.out.find(key);
  if (at == std::string::npos) return "absent";
  const std::size_t start = at + key.size();
  return measured.out.substr(start, measured.out.find_first_of(",\n", start) - start);
}

TEST_F(ProgramVerbs, MeasureAsJsonKnowsWhatItWasNotAsked) {
  ASSERT_EQ(run(with(mesh_torus, {"--edge-length", "2", "-o", "torus.ply"})).code, 0);
  const Outcome measured = run({"measure", "torus.ply", "--dataset", "torus", "--json", "-q"});
  for (const char* figure :
       {"edge_over_h0_max", "edge_over_h0_exceed_count", "edge_over_own_h0_max", "floor_area_percent"}) {
    EXPECT_EQ(json_value(measured, figure), "null") << figure;
  }
  EXPECT_EQ(json_value(measured, "euler"), "0");
  EXPECT_EQ(json_value(measured, "euler_reference"), "0");
  EXPECT_GT(std::stod(json_value(measured, "distance_max")), 0.0);
  const Outcome sized = run({"measure", "torus.ply", "--dataset", "torus", "--epsilon", "0.5", "--json", "-q"});
  EXPECT_GT(std::stod(json_value(sized, "edge_over_h0_max")), 0.0);
}

TEST_F(ProgramVerbs, MeasureSaysWhatItDidWithTheMeshOfAnotherProgram) {
  // A cube of quadrilaterals, inside out; then a mesh in metres.
  folder_.write(
      "cube.obj",
      "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nf 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\n"
      "f 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
  const std::string inside_out = run({"measure", "cube.obj", "-q"}).out;
  for (const char* line :
       {"note          cube.obj: 6 of its 6 faces have more than three corners (up to 4); they were cut into "
        "12 triangles\n",
        "note          the mesh is inside out: it is closed, and"}) {
    EXPECT_NE(inside_out.find(line), std::string::npos) << inside_out;
  }
  folder_.write("metres.off", "OFF\n3 1 0\n.02 0 0\n.021 0 0\n0.02 0.001 0\n3 0 1 2\n");
  const std::string metres = run({"measure", "metres.off", "--dataset", "torus", "-q"}).out;
  for (const char* line :
       {"note          the mesh is far from the surface; the diagonal of its bounding box is 0.00141 mm",
        "is the mesh in metres? Lengths must be in mm\n"}) {
    EXPECT_NE(metres.find(line), std::string::npos) << metres;
  }
}

TEST_F(ProgramVerbs, MeasureOfAMeshAloneGivesWhatNeedsNoSurface) {
  // A cube of 2 mm, its sides cut into triangles; then the same without one of them.
  const std::string corners = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n";
  const std::string eleven =
      "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n";
  folder_.write("cube.off", "OFF\n8 12 0\n" + corners + eleven + "3 3 4 7\n");
  folder_.write("open.off", "OFF\n8 11 0\n" + corners + eleven);
  const Outcome closed = run({"measure", "cube.off", "--json", "-q"});
  EXPECT_EQ(json_value(closed, "vertices"), "8");
  EXPECT_DOUBLE_EQ(std::stod(json_value(closed, "volume")), 8.0);
  EXPECT_EQ(std::stod(json_value(closed, "area")), 24.0);
  EXPECT_EQ(json_value(closed, "euler"), "2");
  EXPECT_EQ(json_value(closed, "boundary_edges"), "0");
  EXPECT_EQ(json_value(closed, "self_intersections"), "0");
  EXPECT_EQ(std::stod(json_value(closed, "angle_max")), 90.0);
  for (const char* figure : {"distance_mean", "distance_from_surface_max", "euler_reference",
                             "edge_over_h0_exceed_count", "edge_over_h0_max"}) {
    EXPECT_EQ(json_value(closed, figure), "null") << figure;
  }
  const Outcome open = run({"measure", "open.off", "--json", "-q"});
  EXPECT_EQ(json_value(open, "volume"), "null");
  EXPECT_EQ(json_value(open, "boundary_edges"), "3");

  const std::string text = run({"measure", "open.off", "-q"}).out;
  for (const char* line :
       {"size          8 vertices, 11 triangles\n",
        "edges / h0    not measured: needs a surface (--dataset or --volume) and a sizing (--epsilon)\n",
        "distance      not measured: needs a surface (--dataset or --volume)\n", "area          22 mm²\n",
        "volume        not measured: the mesh is not closed or its triangles are not oriented alike\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "in:\n" << text;
  }
}

TEST_F(ProgramVerbs, AnIsovalueWithoutASurfaceIsMovedOrRefused) {
  // Two blocks of a mask that share an edge: F is 0.5 along it.
  std::string mask;
  for (int n = 0; n < 16 * 16 * 16; ++n) {
    const auto within = [](int at, int first) { return at >= first && at < first + 4; };
    const int i = n % 16;
    const int j = n / 16 % 16;
    const int k = n / 256;
    mask += within(k, 4) && ((within(i, 4) && within(j, 4)) || (within(i, 8) && within(j, 8))) ? '\1' : '\0';
  }
  folder_.write("mask.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 16 16 16\nencoding: raw\n\n" + mask);
  const std::vector<std::string> surface = {"--volume", "mask.nrrd", "--isovalue", "0.5", "-q"};
  const std::string note = "mask.nrrd: F = 0.5 touches itself or fills space in 3 cells, near (";
  const Outcome meshed = run(with({"mesh", "--edge-length", "1", "-o", "mesh.ply"}, surface));
  EXPECT_EQ(meshed.code, 0) << meshed.err;
  EXPECT_NE(meshed.out.find("note          " + note), std::string::npos) << meshed.out;
  EXPECT_NE(meshed.out.find("mesh          closed manifold\n"), std::string::npos) << meshed.out;
  const Outcome measured = run(with({"measure", "mesh.ply", "--json"}, surface));
  EXPECT_EQ(json_value(measured, "euler_reference"), "2");
  EXPECT_NE(measured.err.find(note), std::string::npos) << measured.err;
  expect(with({"mesh", "--edge-length", "1", "--exact-isovalue"}, surface), 3, "isovalue 0.5 is no regular value of F");
  expect({"mesh", "--dataset", "torus", "--edge-length", "1", "--exact-isovalue"}, 2, "exact-isovalue = true");
}

TEST_F(ProgramVerbs, SpecksAreNamedAndLeftOutIfAskedFor) {
  // A block, and three voxels by themselves.
  std::string mask;
  for (int n = 0; n < 20 * 20 * 20; ++n) {
    const int i = n % 20;
    const int j = n / 20 % 20;
    const int k = n / 400;
    const bool block = i >= 3 && i < 11 && j >= 3 && j < 11 && k >= 3 && k < 11;
    const bool voxel = i == 15 && j == 15 && (k == 4 || k == 10 || k == 16);
    mask += block || voxel ? '\1' : '\0';
  }
  folder_.write("mask.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 20 20 20\nencoding: raw\n\n" + mask);
  const std::vector<std::string> surface = {"--volume", "mask.nrrd", "--isovalue", "0.2", "-q"};
  for (const char* method : {"particles", "marching-cubes"}) {
    const std::vector<std::string> mesh = with({"mesh", "--edge-length", "1", "--method", method}, surface);
    const Outcome all = run(mesh);
    ASSERT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.out.find("components 4 (surface 4)"), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("mask.nrrd: 3 of 4 components of F = c enclose fewer than 10 voxels (10 mm³); "
                           "--min-component 10 leaves them out\n"),
              std::string::npos)
        << all.out;
    const Outcome one = run(with(mesh, {"--min-component", "10"}));
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_NE(one.out.find("components 1 (surface 1), Euler 2 (surface 2)"), std::string::npos) << one.out;
    EXPECT_NE(one.out.find("3 of 4 components of F = c enclose less than 10 mm³ and are left out"), std::string::npos)
        << one.out;
  }
}

TEST_F(ProgramVerbs, MeasureAgainstAVolumeFileTakesTheOptionsOfMesh) {
  // 100 − |x − (10, 10, 10)|² on 21³ nodes, so that the object above 36 is a ball of radius 8.
  std::string samples;
  for (int k = 0; k < 21; ++k) {
    for (int j = 0; j < 21; ++j) {
      for (int i = 0; i < 21; ++i) {
        const auto value = static_cast<float>(100 - (i - 10) * (i - 10) - (j - 10) * (j - 10) - (k - 10) * (k - 10));
        samples.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
    }
  }
  folder_.write("ball.nrrd",
                "NRRD0004\ntype: float\ndimension: 3\nsizes: 21 21 21\nendian: little\nencoding: raw\n\n" + samples);
  const std::vector<std::string> surface = {"--volume", "ball.nrrd", "--isovalue", "36", "--smooth", "0.5"};
  const std::vector<std::string> sizing = {"--epsilon", "0.5"};
  const Outcome meshed = run(with(with({"mesh", "--method", "marching-cubes", "-q", "-o", "ball.stl"}, surface),
                                  {"--epsilon", "0.5", "--delta", "0.3"}));
  ASSERT_EQ(meshed.code, 0) << meshed.err;
  const Outcome same = run(with(with({"measure", "ball.stl", "--json", "-q"}, surface), sizing));
  EXPECT_LT(std::stod(json_value(same, "distance_vertex_max")), 1e-5) << "STL has coordinates in single precision";
  EXPECT_EQ(json_value(same, "euler_reference"), "2");
  EXPECT_GT(std::stod(json_value(same, "edge_over_h0_max")), 0.0);
  // A ball of radius 7 instead of 8.
  const Outcome other =
      run({"measure", "ball.stl", "--volume", "ball.nrrd", "--isovalue", "51", "--inside", "below", "--json", "-q"});
  EXPECT_GT(std::stod(json_value(other, "distance_mean")), 0.5);
  EXPECT_EQ(json_value(other, "edge_over_h0_max"), "null");
}

TEST_F(ProgramVerbs, ListAndVersionSayWhatThereIs) {
  const Outcome methods = run({"list", "methods"});
  EXPECT_EQ(methods.code, 0);
  EXPECT_NE(methods.out.find("particles"), std::string::npos);
  EXPECT_NE(methods.out.find("sweeps"), std::string::npos);
  const Outcome all = run({"list"});
  for (const char* word : {"datasets:", "torus", "metrics:", "radius_ratio_min", "columns:", "seconds_total",
                           "experiments:", "quick.toml"}) {
    EXPECT_NE(all.out.find(word), std::string::npos) << word;
  }
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  for (const char* pattern : {"isobench [0-9]+\\.", "commit ", "VTK [0-9]+\\.", "CGAL [0-9]+\\."}) {
    EXPECT_TRUE(std::regex_search(version.out, std::regex(pattern))) << pattern << " in " << version.out;
  }
}

TEST_F(ProgramVerbs, ListsAreWrappedToTheTerminalAndNotInAFile) {
  std::size_t longest = 0;
  const Outcome to_file = run_program(folder_.path(), {"list"}, {{"COLUMNS", ""}});
  for (const std::string& line : lines(to_file.out)) longest = std::max(longest, character_count(line));
  EXPECT_GT(longest, 200U) << "an entry of a list in a file is one line";
  for (const char* const columns : {"60", "100"}) {
    const Outcome list = run_program(folder_.path(), {"list"}, {{"COLUMNS", columns}});
    EXPECT_EQ(list.code, 0) << list.err;
    for (const std::string& line : lines(list.out)) {
      // A single word, such as an address, may be longer than the terminal is wide.
      const bool one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
      EXPECT_TRUE(one_word || character_count(line) <= std::stoul(columns)) << line;
    }
  }
}

TEST_F(ProgramVerbs, HelpDescribesEveryVerb) {
  const Outcome help = run_program(folder_.path(), {"--help"}, {{"COLUMNS", "80"}});
  EXPECT_EQ(help.code, 0);
  for (const char* verb : {"run", "mesh", "measure", "list", "fetch", "report", "compare", "submit", "status"}) {
    EXPECT_NE(help.out.find(std::string("\n  ") + verb + " "), std::string::npos) << verb;
    const Outcome of_verb = run_program(folder_.path(), {verb, "--help"}, {{"COLUMNS", "80"}});
    EXPECT_EQ(of_verb.code, 0) << of_verb.err;
    for (const std::string& line : lines(of_verb.out)) EXPECT_LE(character_count(line), 80U) << line;
  }
  EXPECT_EQ(help.out.find("cell "), std::string::npos) << "the verb that run starts is hidden";
}

TEST_F(ProgramVerbs, DryRunTouchesNothing) {
  const Outcome outcome =
      run({"run", std::string(ISOBENCH_EXPERIMENTS) + "/quick.toml", "--dry-run", "--only", "torus/*"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("to do      torus-particles-e0.5-d0.3-s1-"), std::string::npos) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "results"));
}

TEST_F(ProgramVerbs, SetAndSeedMakeAnotherExperiment) {
  const std::string config = std::string(ISOBENCH_EXPERIMENTS) + "/quick.toml";
  const auto plan = [&](const std::vector<std::string>& more) {
    return run(with({"run", config, "--dry-run", "--only", "torus/particles"}, more)).out;
  };
  EXPECT_NE(plan({"--seed", "7"}).find("to do      torus-particles-e0.5-d0.3-s7-"), std::string::npos);
  const std::string several = plan({"--seed", "3,5"});
  for (const char* name : {"to do      torus-particles-e0.5-d0.3-s3-", "to do      torus-particles-e0.5-d0.3-s5-"}) {
    EXPECT_NE(several.find(name), std::string::npos) << several;
  }
  EXPECT_EQ(run({"run", "--seed", "3,5", config, "--dry-run", "--only", "torus/particles"}).out, several);
  expect({"run", config, "--dry-run", "--seed", "3,x"}, 2, "--seed");
  const int sweeps = Parameters(method("particles").parameters).integer("sweeps");
  EXPECT_EQ(plan({"--set", fmt::format("sweeps={}", sweeps)}), plan({}));
  EXPECT_NE(plan({"--set", fmt::format("sweeps={}", sweeps + 1)}), plan({}));
  expect({"run", config, "--dry-run", "--set", "swepes=5"}, 2, "did you mean 'sweeps'?");
}

TEST_F(ProgramVerbs, TheProjectsOwnConfigsAreSound) {
  for (const auto& entry : std::filesystem::directory_iterator(ISOBENCH_EXPERIMENTS)) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run({"run", entry.path().string(), "--dry-run"});
    EXPECT_EQ(outcome.code, 0) << entry.path() << outcome.err;
    EXPECT_NE(outcome.out, "");
  }
}

}  // namespace
}  // namespace isobench
