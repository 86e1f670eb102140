#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <limits>

#include "isobench/datasets/formats/vtk/vtk_messages.h"
#include "isobench/datasets/formats/vtk/vtk_xml.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/vtk_cells.h"

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
  file.fail(name.empty() ? "its points have no coordinates" : "its cells have no " + name);
}

void add_points(const VtkXmlFile& file, const VtkElement& piece, std::size_t count,
                std::vector<Eigen::Vector3d>& vertices) {
  const VtkElement* points = piece.child("Points");
  if (count == 0) return;
  if (points == nullptr) file.fail("its points have no coordinates");
  const VtkElement& array = array_of(file, *points, "");
  const std::string components = array.attribute("NumberOfComponents", "3");
  if (components != "3") file.fail(fmt::format("its points have {} coordinates; three are needed", components));
  const std::vector<double> coordinates = file.numbers(array, 3 * count);
  for (std::size_t v = 0; v < count; ++v) vertices.emplace_back(coordinates.data() + 3 * v);
}

VtkCells cells_of(const VtkXmlFile& file, const VtkElement& parent, std::size_t count) {
  VtkCells cells;
  cells.ends = file.numbers(array_of(file, parent, "offsets"), count);
  const double corners = cells.ends.back();
  if (!(corners >= 0.0 && corners < 1e12)) file.fail("damaged: its last cell ends nowhere; copy or export it again");
  cells.corners = file.numbers(array_of(file, parent, "connectivity"), static_cast<std::size_t>(corners));
  return cells;
}

/// Adds the cells of a piece of polygons, in the order in which VTK numbers them; `first` is the number of its first
/// point.
void add_poly_data(const VtkXmlFile& file, const VtkElement& piece, std::size_t first, VtkCellAdder& adder) {
  struct Kind {
    const char* count;
    const char* element;
    VtkCellType type;
  };
  static constexpr Kind kinds[] = {{"NumberOfVerts", "Verts", VtkCellType::vertex},
                                   {"NumberOfLines", "Lines", VtkCellType::line},
                                   {"NumberOfPolys", "Polys", VtkCellType::polygon},
                                   {"NumberOfStrips", "Strips", VtkCellType::strip}};
  for (const Kind& kind : kinds) {
    const std::size_t count = file.count(piece, kind.count);
    if (count == 0) continue;
    const VtkElement* cells = piece.child(kind.element);
    if (cells == nullptr) file.fail(fmt::format("it counts {} of {}, but has none", count, kind.element));
    adder.add(cells_of(file, *cells, count), kind.type, first);
  }
}

void add_grid(const VtkXmlFile& file, const VtkElement& piece, std::size_t first, VtkCellAdder& adder) {
  const std::size_t count = file.count(piece, "NumberOfCells");
  if (count == 0) return;
  const VtkElement* cells = piece.child("Cells");
  if (cells == nullptr) file.fail(fmt::format("it counts {} cells, but has none", count));
  const std::vector<double> types = file.numbers(array_of(file, *cells, "types"), count);
  adder.add(cells_of(file, *cells, count), types, first);
}

/// Calls use(name, values) for the scalar arrays of a piece; TriangleMesh has no vectors.
template <typename Use>
void for_each_scalars(const VtkXmlFile& file, const VtkElement* source, std::size_t count, Use use) {
  if (source == nullptr) return;
  for (const VtkElement& array : source->children) {
    const std::string name = array.attribute("Name");
    if (array.name != "DataArray" || name.empty() || !VtkXmlFile::is_numeric(array)) continue;
    if (array.attribute("NumberOfComponents", "1") == "1") use(name, file.numbers(array, count));
  }
}

/// Adds the values of one piece. Arrays that are not in every piece are dropped; of two with one name, the first is
/// kept. `count` values of the piece follow the `before` of earlier pieces.
class PieceData {
 public:
  PieceData(DataArrays& arrays, std::size_t before, std::size_t count)
      : arrays_(arrays), before_(before), count_(count) {}
  PieceData(const PieceData&) = delete;
  PieceData& operator=(const PieceData&) = delete;
  ~PieceData() {
    std::erase_if(arrays_, [this](const auto& entry) { return entry.second.size() != before_ + count_; });
  }
  void add(const std::string& name, const std::vector<double>& values) {
    if (before_ > 0 && !arrays_.contains(name)) return;
    std::vector<double>& array = arrays_[name];
    if (array.size() == before_) array.insert(array.end(), values.begin(), values.end());
  }

 private:
  DataArrays& arrays_;
  std::size_t before_;
  std::size_t count_;
};

void add_point_data(const VtkXmlFile& file, const VtkElement& piece, std::size_t count, std::size_t before,
                    DataArrays& arrays) {
  PieceData data(arrays, before, count);
  for_each_scalars(file, piece.child("PointData"), count,
                   [&](const std::string& name, const std::vector<double>& values) { data.add(name, values); });
}

/// Data of a cell become data of the polygons that were made of it.
void add_cell_data(const VtkXmlFile& file, const VtkElement& piece, const std::vector<std::size_t>& polygons_of_cells,
                   std::size_t before, PolygonMesh& mesh) {
  PieceData data(mesh.polygon_data, before, mesh.size() - before);
  for_each_scalars(file, piece.child("CellData"), polygons_of_cells.size(),
                   [&](const std::string& name, const std::vector<double>& values) {
                     std::vector<double> of_polygons;
                     for (std::size_t c = 0; c < values.size(); ++c) {
                       of_polygons.insert(of_polygons.end(), polygons_of_cells[c], values[c]);
                     }
                     data.add(name, of_polygons);
                   });
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

PolygonMesh read_vtp(const std::filesystem::path& path) {
  // Its beginning says what it holds; VtkXmlFile looks for the same words at the same place.
  const std::string head = read_bytes(path).substr(0, 4096);
  if (head.find("<VTKFile") == std::string::npos) {
    not_of_format(path, head, "a VTK XML file", "it has no element VTKFile");
  }
  const bool grid = head.find("\"UnstructuredGrid\"") != std::string::npos;
  const VtkXmlFile file(path, grid ? "UnstructuredGrid" : "PolyData");
  PolygonMesh mesh;
  VtkCellAdder adder(mesh, path);
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    const std::size_t vertices = mesh.vertices.size();
    const std::size_t polygons = mesh.size();
    const std::size_t points = file.count(piece, "NumberOfPoints");
    add_points(file, piece, points, mesh.vertices);
    (grid ? add_grid : add_poly_data)(file, piece, vertices, adder);
    add_point_data(file, piece, points, vertices, mesh.vertex_data);
    add_cell_data(file, piece, adder.take_polygons_of_cells(), polygons, mesh);
  }
  adder.add_notes();
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
  Artefact artefact;
  for (const VtkElement& piece : file.data().children) {
    if (piece.name != "Piece") continue;
    const std::size_t before = artefact.points.size();
    const std::size_t count = file.count(piece, "NumberOfPoints");
    add_points(file, piece, count, artefact.points);
    add_point_data(file, piece, count, before, artefact.data);
  }
  return artefact;
}

void write_vtp(const TriangleMesh& mesh, const std::filesystem::path& path) {
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk(mesh.vertices));
  data->SetPolys(cells);
  add_arrays(mesh.vertex_data, *data->GetPointData());
  add_arrays(mesh.triangle_data, *data->GetCellData());
  if (!mesh.space.empty()) {
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue(mesh.space);
    data->GetFieldData()->AddArray(space);
  }
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
