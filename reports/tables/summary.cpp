#include "isobench/reports/tables/summary.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace isobench {

namespace {

std::string defects(const TopologyFigures& topology) {
  std::string text = topology.closed_manifold() ? "closed manifold" : "";
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(topology.boundary_edges, "boundary edges");
  add(topology.nonmanifold_edges, "non-manifold edges");
  add(topology.misoriented_edges, "misoriented edges");
  add(topology.nonmanifold_vertices, "pinched vertices");
  add(topology.self_intersections, "self-intersections");
  return text;
}

}  // namespace

std::string summary_text(const Measurement& m) {
  std::string text;
  text += fmt::format("size          {} vertices, {} triangles\n", m.vertices, m.triangles);
  text += fmt::format("radius ratio  min {:.4f}, 0.1 percentile {:.4f}, average {:.4f}\n", m.radius_ratio.min,
                      m.radius_ratio.p01, m.radius_ratio.avg);
  text += fmt::format("angles        {:.1f}° to {:.1f}°\n", m.angles.min, m.angles.max);
  text += fmt::format("valence       5: {:.1f} %, 6: {:.1f} %, 7: {:.1f} %, outside: {} vertices\n",
                      m.valence.v5_percent, m.valence.v6_percent, m.valence.v7_percent, m.valence.extreme_count);
  if (std::isfinite(m.edges.over_h0_max)) {
    text += fmt::format("edges / h0    max {:.3f}, {} above 1 ({:.4f} % of edges)\n", m.edges.over_h0_max,
                        m.edges.exceed_count, m.edges.exceed_percent);
    // Where the method has no field of its own, this would be the same line again.
    if (m.edges.over_own_h0_max != m.edges.over_h0_max) {
      text += fmt::format("edges/own h0  max {:.3f}, {:.4f} % of edges above 1\n", m.edges.over_own_h0_max,
                          m.edges.own_exceed_percent);
    }
  }
  text +=
      fmt::format("topology      components {} (surface {}), Euler {} (surface {}, counted at k = {})\n",
                  m.topology.components, m.reference.components, m.topology.euler, m.reference.euler, m.reference.k);
  text += fmt::format("mesh          {}\n", defects(m.topology));
  text += fmt::format("distance      mean {:.4g} mm, max {:.4g} mm\n", m.distance.mean, m.distance.max);
  return text;
}

void forget_edge_lengths(Measurement& measurement) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  measurement.edges.over_h0_max = unknown;
  measurement.edges.over_h0_mean = unknown;
  measurement.edges.exceed_percent = unknown;
  measurement.edges.exceed_triangle_percent = unknown;
  measurement.edges.floor_area_percent = unknown;
  measurement.edges.over_own_h0_max = unknown;
  measurement.edges.own_exceed_percent = unknown;
  measurement.edges.own_exceed_triangle_percent = unknown;
  measurement.edges.exceed_count = 0;
  measurement.edges.histogram = Histogram(0.0, 2.0, 200);
}

}  // namespace isobench
