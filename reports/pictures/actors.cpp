#include "isobench/reports/pictures/actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

#include <array>

namespace isobench {

namespace {

vtkSmartPointer<vtkPoints> to_vtk(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& shift) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const Eigen::Vector3d place = positions[n] + shift;
    points->SetPoint(static_cast<vtkIdType>(n), place.data());
  }
  return points;
}

vtkSmartPointer<vtkDoubleArray> to_vtk(const std::vector<double>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

vtkSmartPointer<vtkPolyData> to_vtk(const Scene& scene) {
  const TriangleMesh& mesh = *scene.mesh;
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(to_vtk(mesh.vertices, Eigen::Vector3d::Zero()));
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(to_vtk(scene.values));
  data->GetPointData()->SetScalars(to_vtk(scene.vertex_values));
  return data;
}

// Viridis: its steps look even, also to colour-blind readers. Low values are dark.
vtkSmartPointer<vtkColorTransferFunction> viridis(double low, double high) {
  auto scale = vtkSmartPointer<vtkColorTransferFunction>::New();
  const auto at = [low, high](double share) { return low + share * (high - low); };
  scale->AddRGBPoint(at(0.0), 0.267, 0.005, 0.329);
  scale->AddRGBPoint(at(0.25), 0.229, 0.322, 0.546);
  scale->AddRGBPoint(at(0.5), 0.128, 0.567, 0.551);
  scale->AddRGBPoint(at(0.75), 0.369, 0.789, 0.383);
  scale->AddRGBPoint(at(1.0), 0.993, 0.906, 0.144);
  return scale;
}

vtkSmartPointer<vtkScalarsToColors> colours(const Scene& scene) {
  if (!scene.logarithmic) return viridis(scene.low, scene.high);
  // A table, because the colour bar knows logarithms of tables only.
  constexpr int colours = 256;
  const auto even = viridis(0.0, colours - 1.0);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(colours);
  table->SetTableRange(scene.low, scene.high);
  table->SetScaleToLog10();
  for (int n = 0; n < colours; ++n) {
    std::array<double, 3> colour{};
    even->GetColor(n, colour.data());
    table->SetTableValue(n, colour[0], colour[1], colour[2]);
  }
  return table;
}

vtkSmartPointer<vtkActor> actor_of(const Scene& scene, vtkScalarsToColors* scale) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(to_vtk(scene));
  mapper->SetLookupTable(scale);
  mapper->UseLookupTableScalarRangeOn();
  if (scene.vertex_values.empty())
    mapper->SetScalarModeToUseCellData();
  else
    mapper->SetScalarModeToUsePointData();
  mapper->SetScalarVisibility(scene.values.empty() && scene.vertex_values.empty() ? 0 : 1);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.85, 0.85, 0.82);
  actor->GetProperty()->SetEdgeVisibility(scene.edges ? 1 : 0);
  actor->GetProperty()->SetEdgeColor(0.1, 0.1, 0.1);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

// Points as small balls, moved a little towards the eye so that the surface does not hide them.
vtkSmartPointer<vtkActor> points_of(const Scene& scene, const View& view, vtkScalarsToColors* scale) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk(scene.points, 0.01 * view.half_height * view.towards.normalized()));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n) cells->InsertNextCell({n});
  data->SetVerts(cells);
  data->GetPointData()->SetScalars(to_vtk(scene.point_values));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(scale);
  mapper->SetScalarVisibility(scene.point_values.empty() ? 0 : 1);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.27, 0.55);
  actor->GetProperty()->SetPointSize(static_cast<float>(scene.point_size));
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

// The outline of one triangle, moved towards the eye so that nothing hides it.
vtkSmartPointer<vtkActor> outline_of(const Scene& scene, const View& view) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const Triangle& triangle = scene.mesh->triangles[*scene.outlined];
  const Eigen::Vector3d lift = 0.9 * view.eye_distance * view.towards.normalized();
  lines->InsertNextCell(4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d corner = scene.mesh->vertices[triangle[i % 3]] + lift;
    lines->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.1, 0.1);
  actor->GetProperty()->SetLineWidth(3.0F);
  actor->GetProperty()->LightingOff();
  return actor;
}

// A red point with a white rim: two points, moved close to the eye so that nothing hides them.
vtkSmartPointer<vtkActor> mark_of(const Scene& scene, const View& view, bool rim) {
  // The rim is behind by more than the points bulge, which are drawn as balls.
  const double depth = 0.9 * view.eye_distance - (rim ? 0.1 * view.half_height : 0.0);
  const Eigen::Vector3d direction = view.towards.normalized();
  const double lift = depth - (*scene.marked - view.focus).dot(direction);
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk({*scene.marked}, lift * direction));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0});
  data->SetVerts(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(rim ? 1.0 : 0.9, rim ? 1.0 : 0.1, rim ? 1.0 : 0.1);
  actor->GetProperty()->SetPointSize(rim ? 20.0F : 14.0F);
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkScalarBarActor> bar_of(const Scene& scene, vtkScalarsToColors* scale) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(scale);
  bar->SetTitle(scene.legend.c_str());
  bar->SetVerticalTitleSeparation(10);
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat(scene.label_format);
  bar->SetOrientationToVertical();
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(0.1, 0.1);
  bar->SetWidth(0.6);
  bar->SetHeight(0.8);
  for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetColor(0.0, 0.0, 0.0);
    text->SetFontSize(14);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  return bar;
}

}  // namespace

void add_actors(const Scene& scene, const View& view, vtkRenderer& picture, vtkRenderer& strip) {
  const auto scale = colours(scene);
  if (scene.mesh != nullptr && !scene.mesh->triangles.empty()) picture.AddActor(actor_of(scene, scale));
  if (!scene.points.empty()) picture.AddActor(points_of(scene, view, scale));
  if (scene.outlined) picture.AddActor(outline_of(scene, view));
  for (const bool rim : {true, false}) {
    if (scene.marked) picture.AddActor(mark_of(scene, view, rim));
  }
  if (!scene.legend.empty()) strip.AddActor2D(bar_of(scene, scale));
}

}  // namespace isobench
