#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/reference_topology/reference_topology.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const ReferenceTopology topology = reference_topology(input.surface(), input.reference_k(), input.monitor());
  output.set("components_reference", static_cast<double>(topology.components));
  output.set("euler_reference", static_cast<double>(topology.euler));
  output.set("reference_k", topology.k);
}

}  // namespace

Metric metric_reference_topology() {
  Metric metric;
  metric.name = "reference_topology";
  metric.stage = "reference";
  metric.needs = Needs::surface;
  metric.in_every_record = true;
  metric.figures = {
      {.name = "components_reference",
       .definition = "Connected components of the surface F = c itself, counted without any mesh. The count takes the "
                     "signs of F − c on a lattice that is refined reference_k times, and further around critical "
                     "points of F, and cuts its cells into Kuhn tetrahedra.",
       .kind = Kind::count,
       .compared = Compared::exactly,
       .column = 21},
      {.name = "euler_reference",
       .definition = "Euler characteristic of the surface F = c itself: edges − triangles + tetrahedra whose corners "
                     "differ in the sign of F − c, on the same refined lattice as components_reference. The outermost "
                     "two layers of nodes count as outside.",
       .kind = Kind::integer,
       .compared = Compared::exactly,
       .column = 23},
      {.name = "reference_k",
       .definition = "How many times finer the lattice of the reference count is than the data's lattice.",
       .kind = Kind::count,
       .compared = Compared::exactly,
       .column = 24}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
