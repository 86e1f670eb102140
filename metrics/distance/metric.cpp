#include <fmt/format.h>

#include "isobench/metrics/distance/distance.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

/// Says why distances are not what they seem. A point in a hundred may be missed by a good mesh of a rough surface.
void note_unprojected(MetricInput& input, const DistanceFigures& figures) {
  const std::string hint = hint_of_boxes(input.mesh(), input.surface());
  if (!figures.any_projected()) {
    input.monitor().note(
        fmt::format("distances could not be measured: Newton's steps reach the surface from none of the "
                    "mesh's {} points{}",
                    figures.points, hint));
  } else if (figures.unprojected * 100 > figures.points) {
    input.monitor().note(
        fmt::format("distances are estimates in part: Newton's steps do not reach the surface from {} of "
                    "the mesh's {} points{}",
                    figures.unprojected, figures.points, hint));
  } else if (is_elsewhere(input.mesh(), input.surface(), figures)) {
    input.monitor().note("the mesh is far from the surface" + hint);
  }
}

void measure(MetricInput& input, MetricOutput& output) {
  std::vector<double> at_vertices;
  const DistanceFigures figures = measure_distance(input.mesh(), input.edges(), input.surface(), &at_vertices);
  output.set("distance_unprojected", static_cast<double>(figures.unprojected));
  note_unprojected(input, figures);
  if (!figures.any_projected()) return;
  output.set("distance_mean", figures.mean);
  output.set("distance_max", figures.max);
  output.set("distance_vertex_max", figures.vertex_max);
  output.set("distance_mean_voxels", figures.mean_voxels);
  output.set("distance_max_voxels", figures.max_voxels);
  output.add_vertex_data("distance", std::move(at_vertices));
}

FigureDeclaration distance(const std::string& name, const std::string& unit, const std::string& definition,
                           int column) {
  return {.name = name,
          .unit = unit,
          .definition = definition,
          .better = Better::smaller,
          .unmeasured = "no point of the mesh could be projected to the surface",
          .column = column};
}

FigureDeclaration mean(FigureDeclaration figure) {
  figure.unmeasured = "the mesh has no area or no point of it could be projected to the surface";
  return figure;
}

}  // namespace

Metric metric_distance() {
  Metric metric;
  metric.name = "distance";
  metric.needs = Needs::surface;
  metric.in_every_record = true;
  metric.figures = {
      mean(distance(
          "distance_mean", "mm",
          "Mean distance of the mesh to the surface F = c, weighted by area. It is taken at the corners, edge "
          "midpoints and centroid of each triangle: from each of these points, Newton's steps along the gradient "
          "go to the surface, and the distance is that to the point reached. If they do not reach the surface, it "
          "is |F − c|/|∇F|, at most the diagonal of the volume.",
          29)),
      distance("distance_max", "mm", "Largest distance to the surface F = c, over the points of distance_mean.", 30),
      distance("distance_vertex_max", "mm",
               "Largest distance of a vertex to the surface F = c. Vertices without a triangle do not count.",
               no_column),
      mean(distance("distance_mean_voxels", "voxels",
                    "distance_mean in voxels. A voxel is the geometric mean of the lattice's spacings.", no_column)),
      distance("distance_max_voxels", "voxels", "distance_max in voxels.", no_column),
      {.name = "distance_unprojected",
       .definition = "Number of points from which Newton's steps did not reach the surface. Their distance is "
                     "|F − c|/|∇F|.",
       .kind = Kind::count,
       .better = Better::smaller,
       .column = no_column}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
