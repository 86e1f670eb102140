#include "isobench/reports/pictures/field_scene.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace isobench {

namespace {

// The numbers of a field; empty where the mesh does not have it.
std::vector<double> numbers_of(const FieldDeclaration& field, const std::map<std::string, std::vector<double>>& data) {
  const auto found = data.find(field.name);
  return found == data.end() ? std::vector<double>() : found->second;
}

// The place that a run's figures name.
std::optional<Eigen::Vector3d> marked_place(const FieldDeclaration& field, const RunRecord& run) {
  if (field.mark.empty()) return std::nullopt;
  Eigen::Vector3d place;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    place[axis] = run.measurement->number(field.mark + std::array{"_x", "_y", "_z"}[static_cast<std::size_t>(axis)]);
  }
  return place.allFinite() ? std::optional(place) : std::nullopt;
}

}  // namespace

double high_value(const FieldDeclaration& field, const TriangleMesh& mesh) {
  std::vector<double> values = numbers_of(field, mesh.vertex_data);
  if (values.empty()) values = numbers_of(field, mesh.triangle_data);
  if (values.empty()) return 0.0;
  const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), high, values.end());
  return *high;
}

Scene field_scene(const FieldDeclaration& field, const TriangleMesh& mesh, const RunRecord& run, double brightest) {
  Scene scene;
  scene.mesh = &mesh;
  scene.vertex_values = numbers_of(field, mesh.vertex_data);
  scene.values = numbers_of(field, mesh.triangle_data);
  scene.legend = field.legend;
  scene.high = field.brightest.value_or(std::max(brightest, 1e-300));
  if (field.scale == FieldScale::logarithmic) {
    scene.logarithmic = true;
    scene.low = 1e-3 * scene.high;
    scene.label_format = "%.0e";
    for (std::vector<double>* values : {&scene.values, &scene.vertex_values}) {
      for (double& value : *values) value = std::max(value, scene.low);
    }
  }
  scene.edges = field.view == FieldView::mark;
  scene.marked = marked_place(field, run);
  return scene;
}

}  // namespace isobench
