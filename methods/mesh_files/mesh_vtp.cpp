#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>

#include "isobench/datasets/formats/vtk/vtk_messages.h"
#include "isobench/datasets/formats/vtk/vtk_xml.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

namespace {

using DataArrays = std::map<std::string, std::vector<double>>;

void add_arrays(const DataArrays& arrays, vtkFieldData& target) {
  for (const auto& [name, values] : arrays) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    for (std::size_t n = 0; n < values.size(); ++n) array->SetValue(static_cast<vtkIdType>(n), values[n]);
    target.AddArray(array);
  }
}

const VtkElement& array_of(const VtkXmlFile& file, const VtkElement& parent, const std::string& name) {
  for (const VtkElement& array : parent.children) {
    if (array.name == "DataArray" && (name.empty() || array.attribute("Name") == name)) return array;
  }
  file.fail(name.empty() ? "its points have no coordinates" : "its polygons have no " + name);
}

void add_points(const VtkXmlFile& file, const VtkElement& piece, std::size_t count, TriangleMesh& mesh) {
  const VtkElement* points = piece.child("Points");
  if (count == 0) return;
  if (points == nullptr) file.fail("its points have no coordinates");
  const std::vector<double> coordinates = file.numbers(array_of(file, *points, ""), 3 * count);
  for (std::size_t v = 0; v < count; ++v) mesh.vertices.emplace_back(coordinates.data() + 3 * v);
}

/// Adds the triangles of a piece; `first` is the number of the piece's first point.
void add_triangles(const VtkXmlFile& file, const VtkElement& piece, std::size_t count, std::size_t first,
                   TriangleMesh& mesh) {
  const VtkElement* polygons = piece.child("Polys");
  if (count == 0) return;
  if (polygons == nullptr) file.fail("its polygons have no corners");
  const std::vector<double> ends = file.numbers(array_of(file, *polygons, "offsets"), count);
  for (std::size_t t = 0; t < count; ++t) {
    if (ends[t] != static_cast<double>(3 * (t + 1))) file.fail("holds polygons other than triangles");
  }
  const std::vector<double> corners = file.numbers(array_of(file, *polygons, "connectivity"), 3 * count);
  const auto offset = static_cast<double>(first);
  for (std::size_t t = 0; t < count; ++t) {
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const double corner = corners[3 * t + c];
      triangle[c] = to_index(corner < 0.0 ? corner : corner + offset);
    }
  }
}

/// Adds the scalar arrays of a piece; TriangleMesh has no vectors. Arrays that are not in every piece are dropped.
void add_data(const VtkXmlFile& file, const VtkElement* source, std::size_t count, std::size_t before,
              DataArrays& arrays) {
  if (source != nullptr) {
    for (const VtkElement& array : source->children) {
      const std::string name = array.attribute("Name");
      if (array.name != "DataArray" || name.empty() || !VtkXmlFile::is_numeric(array)) continue;
      if (array.attribute("NumberOfComponents", "1") != "1" || (before > 0 && !arrays.contains(name))) continue;
      if (arrays[name].size() != before) continue;  // of two arrays with one name, the first is read
      const std::vector<double> values = file.numbers(array, count);
      arrays[name].insert(arrays[name].end(), values.begin(), values.end());
    }
  }
  std::erase_if(arrays, [&](const auto& entry) { return entry.second.size() != before + count; });
}

vtkSmartPointer<vtkPoints> to_vtk(const std::vector<Eigen::Vector3d>& positions) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t n = 0; n < positions.size(); ++n) {
    points->SetPoint(static_cast<vtkIdType>(n), positions[n].data());
  }
  return points;
}

void write_poly_data(vtkPolyData* data, const std::filesystem::path& path) {
  // In memory, because VTK does not say why a file cannot be written.
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  if (writer->Write() != 1 || writer->GetErrorCode() != 0 || messages.failed()) {
    throw Error(fmt::format("{}: VTK cannot write this mesh ({}); write another format, such as .ply", path.string(),
                            messages.first_error()));
  }
  write_text(path, writer->GetOutputString());
}

}  // namespace

TriangleMesh read_vtp(const std::filesystem::path& path) {
  read_bytes(path);  // throws if there is no such file
  const VtkXmlFile file(path, "PolyData");
  TriangleMesh mesh;
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    for (const char* others : {"NumberOfVerts", "NumberOfLines", "NumberOfStrips"}) {
      if (file.count(piece, others) > 0) file.fail("has vertices, lines or strips; only triangles can be read");
    }
    const std::size_t vertices = mesh.vertices.size();
    const std::size_t triangles = mesh.triangles.size();
    const std::size_t points = file.count(piece, "NumberOfPoints");
    const std::size_t polygons = file.count(piece, "NumberOfPolys");
    add_points(file, piece, points, mesh);
    add_triangles(file, piece, polygons, vertices, mesh);
    add_data(file, piece.child("PointData"), points, vertices, mesh.vertex_data);
    add_data(file, piece.child("CellData"), polygons, triangles, mesh.triangle_data);
  }
  return mesh;
}

std::set<std::string> data_names(const std::filesystem::path& path) {
  std::set<std::string> names;
  if (!std::filesystem::exists(path)) return names;
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  for (int n = 0; n < reader->GetNumberOfPointArrays(); ++n) names.insert(reader->GetPointArrayName(n));
  for (int n = 0; n < reader->GetNumberOfCellArrays(); ++n) names.insert(reader->GetCellArrayName(n));
  return names;
}

Artefact read_artefact(const std::filesystem::path& path) {
  read_bytes(path);  // throws if there is no such file
  const VtkXmlFile file(path, "PolyData");
  TriangleMesh points;
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    const std::size_t before = points.vertices.size();
    const std::size_t count = file.count(piece, "NumberOfPoints");
    add_points(file, piece, count, points);
    add_data(file, piece.child("PointData"), count, before, points.vertex_data);
  }
  return {std::move(points.vertices), std::move(points.vertex_data)};
}

void write_vtp(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk(mesh.vertices));
  data->SetPolys(cells);
  add_arrays(mesh.vertex_data, *data->GetPointData());
  add_arrays(mesh.triangle_data, *data->GetCellData());
  write_poly_data(data, path);
}

void write_artefacts(const std::map<std::string, Artefact>& artefacts, const Lattice& lattice,
                     const std::filesystem::path& folder) {
  for (const auto& [name, artefact] : artefacts) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& x : artefact.points) points.push_back(lattice.to_world(x));
    vtkNew<vtkCellArray> cells;
    for (vtkIdType n = 0; n < static_cast<vtkIdType>(points.size()); ++n) cells->InsertNextCell({n});
    vtkNew<vtkPolyData> data;
    data->SetPoints(to_vtk(points));
    data->SetVerts(cells);
    add_arrays(artefact.data, *data->GetPointData());
    write_poly_data(data, folder / (name + ".vtp"));
  }
}

}  // namespace isobench
