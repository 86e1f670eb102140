#include "isobench/reports/runs/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

using Answer = std::optional<bool>;

Answer is_zero(const Measurement& m, const char* figure) {
  const std::optional<double> value = m.figure(figure);
  return value ? Answer(*value == 0.0) : std::nullopt;
}

Answer are_equal(const Measurement& m, const char* figure, const char* reference) {
  const std::optional<double> a = m.figure(figure);
  const std::optional<double> b = m.figure(reference);
  return a && b ? Answer(*a == *b) : std::nullopt;
}

// One "no" decides, whatever is unknown besides.
Answer both(Answer a, Answer b) {
  if ((a && !*a) || (b && !*b)) return false;
  return a && b ? Answer(true) : std::nullopt;
}

Answer angles_within(const Measurement& m, const AngleBounds& bounds) {
  const std::optional<double> smallest = m.figure("angle_min");
  const std::optional<double> largest = m.figure("angle_max");
  return both(smallest ? Answer(*smallest >= bounds.smallest) : std::nullopt,
              largest ? Answer(*largest <= bounds.largest) : std::nullopt);
}

Answer closed_answer(const Measurement& m) {
  return m.figure("boundary_edges") ? Answer(is_closed_manifold(m)) : std::nullopt;
}

Answer topology_answer(const Measurement& m) {
  // Without a proof of F = c nobody knows, not even of a mesh with holes.
  if (!m.figure("euler_reference") || !m.figure("components_reference")) return std::nullopt;
  return both(closed_answer(m),
              both(are_equal(m, "euler", "euler_reference"), are_equal(m, "components", "components_reference")));
}

std::string angles_between(const AngleBounds& bounds) {
  return fmt::format("angles {}–{}°", bounds.smallest, bounds.largest);
}

std::string angle_column(const AngleBounds& bounds) {
  return fmt::format("angles_{}_{}", bounds.smallest, bounds.largest);
}

std::string angle_definition(const AngleBounds& bounds) {
  return fmt::format("Whether every angle of every triangle is between {}° and {}°.", bounds.smallest, bounds.largest);
}

}  // namespace

const std::vector<Check>& checks() {
  static const std::vector<Check> all = {
      {"closed_manifold", "closed manifold",
       "Whether the mesh is a closed, oriented manifold: no boundary edges, non-manifold edges, misoriented edges "
       "or pinches.",
       closed_answer},
      {"right_topology", "right topology",
       "Whether the mesh is a closed manifold, and its components and Euler characteristic are those of F = c. Not "
       "measured where those of F = c are not known.",
       topology_answer},
      {"no_self_intersections", "no self-intersections", "Whether no two triangles of the mesh intersect.",
       [](const Measurement& m) { return is_zero(m, "self_intersections"); }},
      {angle_column(narrow_angles), angles_between(narrow_angles), angle_definition(narrow_angles),
       [](const Measurement& m) { return angles_within(m, narrow_angles); }},
      {angle_column(wide_angles), angles_between(wide_angles), angle_definition(wide_angles),
       [](const Measurement& m) { return angles_within(m, wide_angles); }},
      {"valences_5_7", "valences 5–7", "Whether every vertex has five, six or seven edges.",
       [](const Measurement& m) { return is_zero(m, "valence_extreme_count"); }},
      {"no_edge_above_h0", "no edge above h0", "Whether no edge is longer than the mean of h0 at its two ends.",
       [](const Measurement& m) { return is_zero(m, "edge_over_h0_exceed_count"); }}};
  return all;
}

const Check& check(const std::string& column) {
  const auto found =
      std::find_if(checks().begin(), checks().end(), [&column](const Check& each) { return each.column == column; });
  if (found == checks().end()) throw std::logic_error("no check is called '" + column + "'");
  return *found;
}

std::optional<bool> passes(const Check& check, const RunRecord& run) {
  return run.measurement ? check.passes(*run.measurement) : std::nullopt;
}

}  // namespace isobench
