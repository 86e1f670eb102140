#include "isobench/reports/tables/summary.h"

#include <fmt/format.h>

#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

std::string defects(const Measurement& m) {
  std::string text = is_closed_manifold(m) ? "closed manifold" : "";
  const auto add = [&](const char* figure, const char* what) {
    if (m.number(figure) > 0.0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", m.number(figure), what);
  };
  add("boundary_edges", "boundary edges");
  add("nonmanifold_edges", "non-manifold edges");
  add("misoriented_edges", "misoriented edges");
  add("nonmanifold_vertices", "pinched vertices");
  add("self_intersections", "self-intersections");
  return text;
}

/// Every mesh that was measured against a surface has this figure.
bool has_surface(const Measurement& m) { return m.figure("distance_unprojected").has_value(); }

/// Why a figure has no value.
std::string not_measured(const Measurement& m, const char* figure) {
  const FigureDeclaration& declared = declared_figure(figure);
  const Needs needs = metric_of_figure(figure_index(figure)).needs;
  if (needs != Needs::mesh && !has_surface(m)) {
    return std::string("not measured: needs a surface (--dataset or --volume)") +
           (needs == Needs::sizing ? " and a sizing (--epsilon)" : "");
  }
  if (needs == Needs::sizing) return "not measured: needs a sizing (--epsilon)";
  return "not measured: " + (declared.unmeasured.empty() ? "the mesh has no such figure" : declared.unmeasured);
}

/// A value with this many significant digits, and its unit.
std::string value_text(const Measurement& m, const char* figure, int digits) {
  const std::optional<double> value = m.figure(figure);
  if (!value) return not_measured(m, figure);
  return fmt::format("{:.{}g} {}", *value, digits, declared_figure(figure).unit);
}

std::string valence_line(const Measurement& m) {
  if (!m.figure("valence_6_percent")) return not_measured(m, "valence_6_percent");
  return fmt::format("5: {:.1f} %, 6: {:.1f} %, 7: {:.1f} %, outside: {} vertices", m.number("valence_5_percent"),
                     m.number("valence_6_percent"), m.number("valence_7_percent"), m.number("valence_extreme_count"));
}

std::string edge_lines(const Measurement& m) {
  if (!m.figure("edge_over_h0_max")) return fmt::format("edges / h0    {}\n", not_measured(m, "edge_over_h0_max"));
  std::string text =
      fmt::format("edges / h0    max {:.3f}, {} above 1 ({:.4f} % of edges)\n", m.number("edge_over_h0_max"),
                  m.number("edge_over_h0_exceed_count"), m.number("edge_over_h0_exceed_percent"));
  // For a method without its own h0, this line would repeat the one above.
  if (m.figure("edge_over_own_h0_max") != m.figure("edge_over_h0_max")) {
    text += fmt::format("edges/own h0  max {:.3f}, {:.4f} % of edges above 1\n", m.number("edge_over_own_h0_max"),
                        m.number("edge_over_own_h0_exceed_percent"));
  }
  return text;
}

std::string topology_line(const Measurement& m) {
  if (!m.figure("euler_reference")) {
    return fmt::format("components {}, Euler {} (surface {})", m.number("components"), m.number("euler"),
                       not_measured(m, "euler_reference"));
  }
  return fmt::format("components {} (surface {}), Euler {} (surface {})", m.number("components"),
                     m.number("components_reference"), m.number("euler"), m.number("euler_reference"));
}

std::string distance_line(const Measurement& m) {
  if (!m.figure("distance_max")) return not_measured(m, "distance_max");
  return "mean " + value_text(m, "distance_mean", 4) + ", max " + value_text(m, "distance_max", 4);
}

/// A line of one metric's figures. None where nobody asked for them; the reason where `figure` was not measured.
std::string line_of(const Measurement& m, const char* name, const char* figure, const std::string& text) {
  if (!m.is_known(figure_index(figure))) return "";
  return fmt::format("{:<14}{}\n", name, m.figure(figure) ? text : not_measured(m, figure));
}

/// What the mesh is worth to a simulation.
std::string use_lines(const Measurement& m) {
  const auto of = [&m](const char* figure) { return m.number(figure); };
  return line_of(m, "weights", "negative_weights",
                 fmt::format("{} negative, {:.3g} % of the triangles obtuse", of("negative_weights"),
                             of("obtuse_percent"))) +
         line_of(m, "vertex areas", "vertex_area_min",
                 fmt::format("{:.3f} to {:.3f} of what was asked for", of("vertex_area_min"), of("vertex_area_max"))) +
         line_of(m, "normals", "normal_angle_mean",
                 fmt::format("mean {:.3g}°, max {:.3g}°", of("normal_angle_mean"), of("normal_angle_max"))) +
         line_of(m, "curvature", "curvature_max",
                 fmt::format("error {:.3g} of its root mean square", of("curvature_max"))) +
         line_of(m, "time step", "step_factor",
                 fmt::format("factor {:.4g}, with consistent mass {:.4g}", of("step_factor"),
                             of("step_factor_consistent"))) +
         line_of(m, "condition", "condition",
                 fmt::format("{:.4g} L²/h², {} steps of conjugate gradients", of("condition"), of("cg_iterations"))) +
         line_of(m, "Poisson", "poisson_max",
                 fmt::format("largest error {:.3g}, root mean square {:.3g}", of("poisson_max"), of("poisson_l2"))) +
         line_of(m, "gradient", "gradient_max",
                 fmt::format("error {:.3g} of its root mean square", of("gradient_max"))) +
         line_of(m, "pattern", "pattern_steps",
                 fmt::format("{} explicit steps; with the step of a good mesh, {:.3g} % of the time is stable",
                             of("pattern_steps"), of("pattern_stable_percent")));
}

}  // namespace

std::string summary_text(const Measurement& m) {
  std::string text =
      fmt::format("size          {} vertices, {} triangles\n", m.number("vertices"), m.number("triangles"));
  text += fmt::format("radius ratio  min {:.4f}, 0.1 percentile {:.4f}, average {:.4f}\n", m.number("radius_ratio_min"),
                      m.number("radius_ratio_p01"), m.number("radius_ratio_avg"));
  text += fmt::format("angles        {:.1f}° to {:.1f}°\n", m.number("angle_min"), m.number("angle_max"));
  text += fmt::format("valence       {}\n", valence_line(m));
  text += edge_lines(m);
  text += fmt::format("topology      {}\n", topology_line(m));
  text += fmt::format("mesh          {}\n", defects(m));
  text += fmt::format("area          {}\n", value_text(m, "area", 6));
  text += fmt::format("volume        {}\n", value_text(m, "volume", 6));
  text += fmt::format("distance      {}\n", distance_line(m));
  return text + use_lines(m);
}

}  // namespace isobench
