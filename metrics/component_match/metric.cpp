// Which components of F = c a mesh shows as they are: where a wrong topology comes from.
#include <algorithm>

#include "isobench/methods/mesh/component_match.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const CertifiedTopology& topology = input.topology();
  if (!topology.is_regular || topology.is_open) return;
  const ComponentMatch match = match_components(input.mesh(), input.surface(), topology);
  const auto count = [&match](Shown shown) {
    return static_cast<double>(std::count(match.shown.begin(), match.shown.end(), shown));
  };
  output.set("components_lost", count(Shown::lost));
  output.set("components_joined", count(Shown::joined));
  output.set("components_different", count(Shown::different));
  output.add_vertex_data("component", {match.of_vertex.begin(), match.of_vertex.end()});
}

FigureDeclaration number_of(const std::string& name, const std::string& definition) {
  return {.name = name,
          .definition = "Number of components of F = c " + definition,
          .kind = Kind::count,
          .compared = Compared::exactly,
          .better = Better::smaller,
          .unmeasured = "the surface leaves the volume"};
}

}  // namespace

Metric metric_component_match() {
  Metric metric;
  metric.name = "component_match";
  metric.needs = Needs::surface;
  metric.figures = {
      number_of("components_lost", "on which the mesh has no vertex: islands and cavities that it lacks."),
      number_of("components_joined", "whose part of the mesh is connected to that of another one."),
      number_of("components_different",
                "of which the mesh has several pieces, or one with another Euler characteristic: holes, or tunnels "
                "and bridges too many or too few.")};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
