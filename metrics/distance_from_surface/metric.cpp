#include "isobench/metrics/distance_from_surface/distance_from_surface.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const DistanceFromSurface figures = measure_distance_from_surface(input.mesh(), input.surface(), input.monitor());
  output.set("distance_from_surface_mean", figures.mean);
  output.set("distance_from_surface_max", figures.max);
}

}  // namespace

Metric metric_distance_from_surface() {
  Metric metric;
  metric.name = "distance_from_surface";
  metric.stage = "distance";
  metric.needs = Needs::surface;
  metric.figures = {
      {.name = "distance_from_surface_mean",
       .unit = "mm",
       .definition = "Mean distance of the surface F = c to the mesh, weighted by area. It shows parts of the surface "
                     "that the mesh misses; distance_mean does not. It is taken at the vertices of marching cubes on "
                     "the data's lattice and at the centroids of its triangles, projected to F = c.",
       .better = Better::smaller,
       .column = 901},
      {.name = "distance_from_surface_max",
       .unit = "mm",
       .definition = "Largest distance to the mesh, over the points of distance_from_surface_mean.",
       .better = Better::smaller,
       .column = 902}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
