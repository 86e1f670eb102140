#include "isobench/methods/mesh_files/mesh_files.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/testing/file_size_limit.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

// The coordinates need more than single precision or six digits.
TriangleMesh octahedron() {
  TriangleMesh mesh;
  const double r = 100.0 + 1.0 / 3.0;
  mesh.vertices = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  mesh.vertex_data["h0"] = {0.1, 0.2, 0.3, 0.4, 0.5, 1.0 / 3.0};
  mesh.triangle_data["radius_ratio"] = {1, 2, 3, 4, 5, 6, 7, 8};
  return mesh;
}

class MeshFiles : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& bytes) const {
    return test_folder_.write(name, bytes);
  }
  std::string written(const std::string& name) const {
    write_mesh(octahedron(), folder_ / name);
    return read_text(folder_ / name);
  }
  /// The error message when these bytes are read; nothing may be printed.
  std::string error(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path path = file(name, bytes);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string message = "no error";
    try {
      read_mesh(path);
    } catch (const DataError& caught) {
      message = caught.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    if (message != "no error") {
      EXPECT_TRUE(message.starts_with(path.string() + ":")) << message;
      message.erase(0, path.string().size() + 1);
    }
    return message;
  }
  TestFolder test_folder_;
  std::filesystem::path folder_ = test_folder_.path();
};

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

// As 3D Slicer marks it.
TEST_F(MeshFiles, SayWhichWayTheAxesPoint) {
  TriangleMesh mesh = octahedron();
  for (const char* name : {"a.vtp", "a.ply", "a.off", "a.obj", "a.stl"}) {
    EXPECT_EQ(written(name).find("SPACE"), std::string::npos) << name;
    mesh.space = "LPS";
    write_mesh(mesh, folder_ / name);
    expect_contains(read_text(folder_ / name), std::string(name) == "a.vtp" ? "Name=\"SPACE\"" : "SPACE=LPS");
    EXPECT_EQ(read_mesh(folder_ / name).triangles.size(), mesh.triangles.size()) << name;
  }
}

TEST_F(MeshFiles, KeepEveryBitInAllFormatsOfDoubles) {
  const TriangleMesh mesh = octahedron();
  for (const char* name : {"a.vtp", "a.ply", "a.off", "a.obj", "A.PLY"}) {
    write_mesh(mesh, folder_ / name);
    const TriangleMesh back = read_mesh(folder_ / name);
    EXPECT_EQ(back.vertices, mesh.vertices) << name;
    EXPECT_EQ(back.triangles, mesh.triangles) << name;
  }
}

TEST_F(MeshFiles, VtpKeepsTheData) {
  written("a.vtp");
  const TriangleMesh back = read_mesh(folder_ / "a.vtp");
  EXPECT_EQ(back.vertex_data, octahedron().vertex_data);
  EXPECT_EQ(back.triangle_data, octahedron().triangle_data);
}

TEST_F(MeshFiles, VtpIsBinaryAndCompressed) {
  const std::string bytes = written("a.vtp");
  expect_contains(bytes, "<AppendedData encoding=\"raw\">");
  expect_contains(bytes, "vtkZLibDataCompressor");
  expect_contains(bytes, "type=\"Float64\" Name=\"Points\"");
}

TEST_F(MeshFiles, StlMergesCornersAndKeepsTheOrientation) {
  const TriangleMesh mesh = octahedron();
  written("a.stl");
  const TriangleMesh back = read_mesh(folder_ / "a.stl");
  ASSERT_EQ(back.vertices.size(), 6U);
  ASSERT_EQ(back.triangles.size(), 8U);
  for (std::size_t t = 0; t < 8; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d difference = back.vertices[back.triangles[t][c]] - mesh.vertices[mesh.triangles[t][c]];
      EXPECT_LT(difference.norm(), 1e-5);  // single precision at 100 mm
    }
  }
}

TEST_F(MeshFiles, AsciiStlAndABinaryOneThatBeginsWithSolidAreToldApart) {
  const auto ascii = file("a.stl",
                          "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -0\nvertex 1 0 0\nvertex 0 1 0\n"
                          "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
                          "vertex 0 1e0 -0\nendloop\nendfacet\nendsolid x\n");
  EXPECT_EQ(read_mesh(ascii).vertices.size(), 4U);
  std::string bytes = written("b.stl");
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_mesh(file("b.stl", bytes)).triangles.size(), 8U);
}

TEST_F(MeshFiles, PlyOfOtherProgramsIsRead) {
  const auto text = file("a.ply",
                         "ply\r\nformat ascii 1.0\r\ncomment made elsewhere\r\nelement vertex 3\r\nproperty float x\r\n"
                         "property float y\r\nproperty float z\r\nproperty uchar red\r\nelement face 1\r\n"
                         "property list uchar int vertex_index\r\nproperty float quality\r\nend_header\r\n"
                         "0 0 0 255\r\n1 0 0 255\r\n0 1 0.5 255\r\n3 0 1 2 0.9\r\n");
  const TriangleMesh mesh = read_mesh(text);
  EXPECT_EQ(mesh.vertices.at(2), Eigen::Vector3d(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));

  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string zero(4, '\0');
  const std::string one("\x3f\x80\0\0", 4);
  big += zero + zero + zero + one + zero + zero + zero + one + zero;
  big += std::string("\x03\0\0\0\0\0\0\0\x01\0\0\0\x02", 13);
  const TriangleMesh swapped = read_mesh(file("b.ply", big));
  EXPECT_EQ(swapped.vertices.at(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(swapped.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(MeshFiles, ObjCornersMayCountBackAndCarryNormals) {
  const auto path = file("a.obj",
                         "# comment\no thing\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 +1 0\ns off\n"
                         "f 1//1 2//1 3//1\nf -3 -2 -1 # again\n");
  EXPECT_EQ(read_mesh(path).triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
}

TEST_F(MeshFiles, OffMayCarryColoursCommentsAndCountsOnTheFirstLine) {
  const auto path =
      file("a.off", "COFF 3 1 0\n# corners\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n\n0 1 0 1 1 1 1\n3 0 1 2\n");
  EXPECT_EQ(read_mesh(path).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(MeshFiles, ThatAreMissingEmptyOrFoldersAreDataErrors) {
  for (const std::string ending : {"vtp", "ply", "off", "obj", "stl"}) {
    EXPECT_THROW(read_mesh(folder_ / ("none." + ending)), DataError) << ending;
    EXPECT_EQ(error("empty." + ending, ""), " the file is empty") << ending;
    const std::filesystem::path folder = folder_ / ("folder." + ending);
    std::filesystem::create_directory(folder);
    EXPECT_THROW(read_mesh(folder), DataError) << ending;
  }
}

TEST_F(MeshFiles, CutAnywhereAreDataErrors) {
  for (const std::string name : {"a.vtp", "a.ply", "a.off", "a.stl"}) {
    const std::string bytes = written(name);
    std::set<std::size_t> lengths{1, 3, 10, 100, 200};
    for (int tenth = 1; tenth < 10; ++tenth) lengths.insert(bytes.size() * static_cast<std::size_t>(tenth) / 10);
    if (name != "a.vtp" && name != "a.off") lengths.insert(bytes.size() - 1);
    for (const std::size_t length : lengths) {
      if (length >= bytes.size()) continue;
      EXPECT_NE(error(name, bytes.substr(0, length)), "no error") << name << ' ' << length;
    }
  }
}

TEST_F(MeshFiles, OfAnotherKindAreDataErrors) {
  for (const std::string name : {"a.vtp", "a.ply", "a.off", "a.obj", "a.stl"}) {
    for (const std::string& foreign : {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0", 20), std::string("hello\n"),
                                       std::string("<VTKFile type=\"ImageData\"></VTKFile>\n")}) {
      EXPECT_NE(error(name, foreign), "no error") << name;
    }
  }
}

// A VTP file in ASCII with three vertices and the given connectivity and offsets of its polygons.
std::string vtp_text(const std::string& points, const std::string& connectivity, const std::string& offsets) {
  const std::string number_of_polys = std::to_string(std::count(offsets.begin(), offsets.end(), ' ') + 1);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         number_of_polys + "\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
         points + "</DataArray></Points>\n<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray></Polys>\n</Piece></PolyData></VTKFile>\n";
}

TEST_F(MeshFiles, VtpOfOtherProgramsIsReadAndChecked) {
  const std::string points = "0 0 0 1 0 0 0 1 0";
  EXPECT_EQ(read_mesh(file("a.vtp", vtp_text(points, "0 1 2", "3"))).triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(read_mesh(file("a.vtp", vtp_text(points, "0 1 2 0", "4"))).triangles.size(), 1U) << "a corner twice";
  expect_contains(error("a.vtp", vtp_text(points, "0 1 3", "3")), "not there");
  expect_contains(error("a.vtp", vtp_text(points, "0 1 -2", "3")), "not there");
  expect_contains(error("a.vtp", vtp_text("0 0 0 1 nan 0 0 1 0", "0 1 2", "3")), "not finite");
  EXPECT_NE(error("a.vtp", vtp_text(points, "0 1 2", "900")), "no error");
  EXPECT_NE(error("a.vtp", vtp_text("0 0 0 1", "0 1 2", "3")), "no error");
}

TEST_F(MeshFiles, WithIndicesOutOfRangeAreDataErrors) {
  expect_contains(error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "the face names vertex 3, but");
  expect_contains(error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "the face names vertex -1, but");
  expect_contains(error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "not there");
  expect_contains(error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), "not there");
  std::string ply = written("a.ply");
  ply[ply.size() - 4] = 6;
  expect_contains(error("a.ply", ply),
                  "face 7 names a vertex that is not there (the file has 6, and faces count from 0)");
}

TEST_F(MeshFiles, WithCoordinatesThatAreNotFiniteAreDataErrors) {
  expect_contains(error("a.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "vertex 1 are not finite");
  expect_contains(error("a.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n"), "vertex 1 are not finite");
  TriangleMesh mesh = octahedron();
  mesh.vertices[3].x() = std::nan("");
  for (const char* name : {"b.vtp", "b.ply", "b.off", "b.obj", "b.stl"}) {
    write_mesh(mesh, folder_ / name);
    EXPECT_THROW(read_mesh(folder_ / name), DataError) << name;
  }
}

TEST_F(MeshFiles, WithoutTrianglesAreDataErrors) {
  TriangleMesh mesh;
  for (const char* name : {"a.vtp", "a.ply", "a.off", "a.stl"}) {
    write_mesh(mesh, folder_ / name);
    EXPECT_THROW(read_mesh(folder_ / name), DataError) << name;
  }
  expect_contains(error("a.obj", "v 0 0 0\n"), "no triangles");
}

TEST_F(MeshFiles, WithHalfATriangleOrAnAxisTwiceAreDataErrors) {
  expect_contains(error("a.stl", "solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendsolid\n"), "fewer than three");
  expect_contains(
      error("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float x\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
      "x, y and z");
}

TEST_F(MeshFiles, MessagesAreShortAndPrintable) {
  const std::string message = error("a.off", "OFF\n1 1 0\n\x1b[2J\xff" + std::string(1000000, 'x') + " 0 0\n");
  expect_contains(message, "\\x1b[2J\\xff");
  EXPECT_LT(message.size(), 1200U);
}

TEST_F(MeshFiles, HugeCountsInAHeaderDoNotExhaustTheMemory) {
  const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
  expect_contains(
      error("a.ply", "ply\nformat ascii 1.0\nelement vertex 900000000000\n" + vertex + "end_header\n0 0 0\n"),
      "truncated");
  expect_contains(error("a.ply", "ply\nformat ascii 1.0\nelement nothing 900000000000000\nend_header\n"),
                  "no triangles");
  expect_contains(error("a.off", "OFF\n900000000000 1 0\n0 0 0\n"), "truncated");
}

TEST_F(MeshFiles, OfUnknownEndingsAreUsageErrors) {
  EXPECT_THROW(write_mesh(octahedron(), folder_ / "a.vtk"), UsageError) << "is only read";
  for (const char* name : {"a.xyz", "a", "a.msh"}) {
    EXPECT_THROW(write_mesh(octahedron(), folder_ / name), UsageError) << name;
    EXPECT_THROW(read_mesh(folder_ / name), UsageError) << name;
  }
}

TEST_F(MeshFiles, PathsAreCheckedBeforeTheWork) {
  const auto problem = [](const std::filesystem::path& path) -> std::string {
    try {
      check_mesh_path(path);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* name : {"a.stl", "a.STL", "A.Ply", "a.vtp"}) EXPECT_EQ(problem(folder_ / name), "") << name;
  EXPECT_EQ(problem("a.obj"), "");
  expect_contains(problem(folder_), folder_.string() + ": is a folder; name a file in it");
  expect_contains(problem(folder_ / "new" / ""), "is a folder; name a file in it");
  expect_contains(problem(folder_ / "no" / "a.stl"), "does not exist; make it first");
  expect_contains(problem(folder_ / "a.vtk"),
                  "unknown ending '.vtk'; meshes are written to files that end in .vtp, .ply");
  std::filesystem::create_directory(folder_ / "folder.stl");
  expect_contains(problem(folder_ / "folder.stl"), "is a folder");
}

TEST_F(MeshFiles, ThatCannotBeWrittenAreErrors) {
  for (const char* name : {"a.vtp", "a.ply", "a.off", "a.obj", "a.stl"}) {
    testing::internal::CaptureStderr();
    EXPECT_THROW(write_mesh(octahedron(), folder_ / "no" / "such" / name), Error) << name;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;
  }
}

TEST_F(MeshFiles, ArtefactsArePointsInTheWorld) {
  Lattice lattice;
  lattice.origin = {10.0, 20.0, 30.0};
  lattice.direction.col(0) = -Eigen::Vector3d::UnitX();
  Artefact axis;
  axis.points = {{1.0 / 3.0, 0, 0}, {0, 1, 2}};
  axis.data["radius"] = {0.25, 1.0 / 7.0};
  write_artefacts({{"medial-axis", axis}}, lattice, folder_);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder_ / "medial-axis.vtp").c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  ASSERT_EQ(data.GetNumberOfPoints(), 2);
  EXPECT_EQ(data.GetNumberOfVerts(), 2) << "without vertices a viewer shows nothing";
  Eigen::Vector3d x;
  data.GetPoint(0, x.data());
  EXPECT_EQ(x, Eigen::Vector3d(10.0 - 1.0 / 3.0, 20.0, 30.0));
  ASSERT_NE(data.GetPointData()->GetArray("radius"), nullptr);
  EXPECT_EQ(data.GetPointData()->GetArray("radius")->GetTuple1(1), 1.0 / 7.0);
  EXPECT_THROW(write_artefacts({{"medial-axis", axis}}, lattice, folder_ / "nowhere"), Error);
}

TEST_F(MeshFiles, OnAFullDiskTheOldFileStays) {
  const FileSizeLimit full(100);
  for (const char* ending : {"vtp", "ply", "off", "obj", "stl"}) {
    const std::string name = std::string("mesh.") + ending;
    const std::filesystem::path path = file(name, "old");
    try {
      written(name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find(path.string() + ": cannot be written: File too large; "), 0U)
          << error.what();
    }
    EXPECT_EQ(read_text(path), "old");
  }
  const auto files = std::distance(std::filesystem::directory_iterator(folder_), {});
  EXPECT_EQ(files, 5);
}

}  // namespace
}  // namespace isobench
