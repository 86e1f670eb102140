// Angles between the triangles and the surface.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "isobench/metrics/foot_points/foot_points.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const TriangleMesh& mesh = input.mesh();
  const std::vector<FootPoint> feet = foot_points(input.surface(), centroids(mesh));
  if (!any_projected(feet)) return;
  double area = 0.0;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t n = 0; n < feet.size(); ++n) {
    const Triangle& t = mesh.triangles[n];
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const Eigen::Vector3d twice = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    if (!feet[n].exists || !(twice.norm() > 0.0)) continue;
    const Eigen::Vector3d normal = feet[n].normal();
    const double angle = std::atan2(twice.cross(normal).norm(), twice.dot(normal)) * 180.0 / std::numbers::pi;
    area += twice.norm();
    sum += twice.norm() * angle;
    largest = std::max(largest, angle);
  }
  if (!(area > 0.0)) return;
  output.set("normal_angle_mean", sum / area);
  output.set("normal_angle_max", largest);
}

}  // namespace

Metric metric_normals() {
  Metric metric;
  metric.name = "normals";
  metric.stage = "distance";
  metric.needs = Needs::surface;
  metric.figures = {
      {.name = "normal_angle_mean",
       .unit = "°",
       .definition =
           "Mean angle between a triangle and the surface F = c, weighted by area: from the triangle's normal "
           "to that of the surface at the projection of the triangle's centroid."},
      {.name = "normal_angle_max",
       .unit = "°",
       .definition = "Largest angle of normal_angle_mean. It is over 90° where a triangle is upside down. Triangles "
                     "without area do not count."}};
  for (FigureDeclaration& figure : metric.figures) {
    figure.better = Better::smaller;
    figure.unmeasured = "the mesh has no area or no point of it could be projected to the surface";
  }
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
