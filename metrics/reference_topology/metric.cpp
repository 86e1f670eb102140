#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const CertifiedTopology& topology = input.topology();
  // χ of a surface that ends at the lattice's border is not what a closed mesh should have.
  if (!topology.is_regular || topology.is_open) return;
  output.set("components_reference", static_cast<double>(topology.kept_components()));
  output.set("euler_reference", static_cast<double>(topology.euler));
}

constexpr const char* unmeasured = "the surface leaves the volume, or c is a critical value of F or too near to one";

}  // namespace

Metric metric_reference_topology() {
  Metric metric;
  metric.name = "reference_topology";
  metric.stage = "reference";
  metric.needs = Needs::surface;
  metric.in_every_record = true;
  metric.figures = {
      {.name = "components_reference",
       .definition = "Connected components of the surface F = c itself, proven without a mesh or samples: bounds on F "
                     "from its Bernstein coefficients show that the surface is one disc, or nothing, in each of many "
                     "boxes. Discs that share an edge are connected. Components below min_component are left out.",
       .kind = Kind::count,
       .compared = Compared::exactly,
       .unmeasured = unmeasured,
       .column = 21},
      {.name = "euler_reference",
       .definition = "Euler characteristic of the surface F = c itself, proven as components_reference is: points on "
                     "the edges of the boxes − arcs on their faces + discs in them. Components below min_component are "
                     "left out.",
       .kind = Kind::integer,
       .compared = Compared::exactly,
       .unmeasured = unmeasured,
       .column = 23}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
