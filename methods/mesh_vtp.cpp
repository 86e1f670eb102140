#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>
#include <new>

#include "datasets/error.h"
#include "datasets/vtk_messages.h"
#include "methods/mesh_files.h"
#include "methods/mesh_formats.h"

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

// Scalars only: normals and the like have no place in TriangleMesh.
DataArrays scalar_arrays(vtkFieldData& source, std::size_t count) {
  DataArrays arrays;
  for (int a = 0; a < source.GetNumberOfArrays(); ++a) {
    vtkDataArray* array = source.GetArray(a);
    if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfComponents() != 1) continue;
    if (static_cast<std::size_t>(array->GetNumberOfTuples()) != count) continue;
    std::vector<double>& values = arrays[array->GetName()];
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n) values.push_back(array->GetTuple1(n));
  }
  return arrays;
}

std::uint32_t to_index(vtkIdType id) {
  // What does not fit becomes an index that no mesh has, for read_mesh() to report.
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  return id < 0 || id >= kNone ? kNone : static_cast<std::uint32_t>(id);
}

TriangleMesh from_vtk(vtkPolyData& data, const std::filesystem::path& path) {
  TriangleMesh mesh;
  for (vtkIdType v = 0; v < data.GetNumberOfPoints(); ++v) {
    Eigen::Vector3d& vertex = mesh.vertices.emplace_back();
    data.GetPoint(v, vertex.data());
  }
  if (data.GetNumberOfVerts() + data.GetNumberOfLines() + data.GetNumberOfStrips() > 0) {
    bad_mesh(path, "holds points, lines or strips; only triangles can be read");
  }
  vtkCellArray* cells = data.GetPolys();
  for (vtkIdType t = 0; t < cells->GetNumberOfCells(); ++t) {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(t, corners, ids);
    if (corners != 3) bad_mesh(path, "holds polygons other than triangles");
    mesh.triangles.push_back({to_index(ids[0]), to_index(ids[1]), to_index(ids[2])});
  }
  mesh.vertex_data = scalar_arrays(*data.GetPointData(), mesh.vertices.size());
  mesh.triangle_data = scalar_arrays(*data.GetCellData(), mesh.triangles.size());
  return mesh;
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
  write_bytes("", path);  // says so if the place cannot be written to
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  if (writer->Write() != 1 || writer->GetErrorCode() != 0 || messages.failed()) {
    throw Error(path.string() + ": writing failed; is the disk full?");
  }
}

}  // namespace

TriangleMesh read_vtp(const std::filesystem::path& path) {
  // VTK would take any XML of its own for a mesh, and crash on some of it.
  if (read_bytes(path).substr(0, 4096).find("PolyData") == std::string::npos) {
    bad_mesh(path, "is no VTP file: it does not announce PolyData");
  }
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  try {
    reader->Update();
  } catch (const std::bad_alloc&) {
    bad_mesh(path, "is damaged: it announces more data than memory can hold");
  }
  if (messages.failed() || reader->GetErrorCode() != 0) {
    bad_mesh(path, "is damaged or truncated (VTK: " + messages.first_error() + ")");
  }
  return from_vtk(*reader->GetOutput(), path);
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
