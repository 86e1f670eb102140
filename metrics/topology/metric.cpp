#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const TopologyFigures figures = measure_topology(input.mesh(), input.half_edges());
  output.set("components", static_cast<double>(figures.components));
  output.set("euler", static_cast<double>(figures.euler));
  output.set("boundary_edges", static_cast<double>(figures.boundary_edges));
  output.set("nonmanifold_edges", static_cast<double>(figures.nonmanifold_edges));
  output.set("misoriented_edges", static_cast<double>(figures.misoriented_edges));
  output.set("nonmanifold_vertices", static_cast<double>(figures.nonmanifold_vertices));
  output.set("self_intersections", static_cast<double>(figures.self_intersections));
}

FigureDeclaration defect(const std::string& name, const std::string& definition, int column) {
  return {.name = name,
          .definition = definition,
          .kind = Kind::count,
          .compared = Compared::exactly,
          .better = Better::smaller,
          .column = column};
}

}  // namespace

Metric metric_topology() {
  Metric metric;
  metric.name = "topology";
  metric.in_every_record = true;
  metric.figures = {
      {.name = "components",
       .definition = "Connected components of the mesh. Triangles are connected where they share an edge.",
       .kind = Kind::count,
       .compared = Compared::exactly,
       .column = 20},
      {.name = "euler",
       .definition = "Euler characteristic χ = vertices − edges + triangles of the mesh. Vertices without a triangle "
                     "do not count. A closed surface of genus g has χ = 2 − 2g.",
       .kind = Kind::integer,
       .compared = Compared::exactly,
       .column = 22},
      defect("boundary_edges", "Number of edges with a single triangle. A closed mesh has none.", 25),
      defect("nonmanifold_edges", "Number of edges with three or more triangles.", 26),
      defect("misoriented_edges", "Number of edges whose two triangles have opposite orientations.", no_column),
      defect("nonmanifold_vertices",
             "Number of vertices whose triangles form more than one fan (pinches). The ends of non-manifold edges "
             "count, too.",
             27),
      defect("self_intersections",
             "Number of pairs of triangles that meet elsewhere than in a vertex or edge that they share, by exact "
             "predicates (CGAL). Triangles without area are left out.",
             28)};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
