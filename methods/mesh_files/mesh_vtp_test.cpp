// Reads VTP files from VTK's writer in all its modes, and lets VTK read ours.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "isobench/datasets/formats/vtk/test_vtk_writer.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {
namespace {

/// A strip of triangles with scalars, which are read, and vectors, which are not.
void fill(vtkPolyData& data, int count) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> h0;
  h0->SetName("h0");
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int v = 0; v < count + 2; ++v) {
    points->InsertNextPoint(v / 3.0, v % 2, 0.25 * v);
    h0->InsertNextValue(static_cast<float>(v));
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> ratio;
  ratio->SetName("radius_ratio");
  for (int t = 0; t < count; ++t) {
    cells->InsertNextCell({t, t + 1, t + 2});
    ratio->InsertNextValue(1.0F / static_cast<float>(t + 1));
  }
  data.SetPoints(points);
  data.SetPolys(cells);
  data.GetPointData()->AddArray(h0);
  data.GetPointData()->SetNormals(normals);
  data.GetCellData()->AddArray(ratio);
}

void expect_strip(const TriangleMesh& mesh, std::size_t count) {
  ASSERT_EQ(mesh.vertices.size(), count + 2);
  ASSERT_EQ(mesh.triangles.size(), count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto first = static_cast<std::uint32_t>(t);
    EXPECT_EQ(mesh.triangles[t], (Triangle{first, first + 1, first + 2}));
    EXPECT_EQ(mesh.triangle_data.at("radius_ratio")[t], 1.0F / static_cast<float>(t + 1));
  }
  for (std::size_t v = 0; v < count + 2; ++v) {
    const auto n = static_cast<double>(v);
    EXPECT_EQ(mesh.vertices[v], Eigen::Vector3d(n / 3.0, static_cast<double>(v % 2), 0.25 * n));
    EXPECT_EQ(mesh.vertex_data.at("h0")[v], n);
  }
  EXPECT_EQ(mesh.vertex_data.size(), 1U);
  EXPECT_EQ(mesh.triangle_data.size(), 1U);
}

TEST(ReadVtp, AllThatVtkWrites) {
  const TestFolder folder;
  const auto path = (folder.path() / "mesh.vtp").string();
  vtkNew<vtkPolyData> data;
  fill(*data, 100);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetBlockSize(512);  // several blocks, the last one shorter
  write_all_variants(*writer, path, [&path] { expect_strip(read_mesh(path), 100); });
}

TEST(ReadVtp, OursAreAsVtkReadsThem) {
  const TestFolder folder;
  const auto path = (folder.path() / "mesh.vtp").string();
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, 1.0 / 3.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  mesh.vertex_data["h0"] = {1.0, 2.0, 3.0, 4.0};
  write_mesh(mesh, path);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const TriangleMesh back = read_mesh(path);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPolys(), 4);
  for (int v = 0; v < 4; ++v) {
    const Eigen::Vector3d point(reader->GetOutput()->GetPoint(v));
    EXPECT_EQ(back.vertices[static_cast<std::size_t>(v)], point);
  }
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.vertex_data, mesh.vertex_data);
}

TEST(ReadVtp, NamesOfDataAreReadFromTheHead) {
  const TestFolder folder;
  const auto path = folder.path() / "mesh.vtp";
  EXPECT_EQ(data_names(path), std::set<std::string>());
  TriangleMesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(mesh, path);
  EXPECT_EQ(data_names(path), std::set<std::string>());
  mesh.vertex_data = {{"h0", {1.0, 2.0, 3.0}}, {"spots", {1.0, 2.0, 3.0}}};
  mesh.triangle_data["radius_ratio"] = {0.8};
  write_mesh(mesh, path);
  EXPECT_EQ(data_names(path), (std::set<std::string>{"h0", "radius_ratio", "spots"}));
}

TEST(ReadVtp, SeveralPiecesBecomeOneMesh) {
  const TestFolder folder;
  const auto piece = [](const std::string& data) {
    return "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><PointData>" + data +
           "</PointData><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0"
           "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
           "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">2 0 1</DataArray></Polys></Piece>\n";
  };
  const auto array = [](const std::string& name) {
    return "<DataArray type=\"Int8\" Name=\"" + name + "\" format=\"ascii\">1 2 3</DataArray>";
  };
  const TriangleMesh mesh = read_mesh(
      folder.write("mesh.vtp", "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>\n" +
                                   piece(array("both") + array("first")) + piece(array("both") + array("second")) +
                                   "</PolyData></VTKFile>\n"));
  EXPECT_EQ(mesh.vertices.size(), 6U);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 0, 1}, {5, 3, 4}}));
  EXPECT_EQ(mesh.vertex_data.size(), 1U);
  EXPECT_EQ(mesh.vertex_data.at("both"), (std::vector<double>{1, 2, 3, 1, 2, 3}));
}

}  // namespace
}  // namespace isobench
