// One call measures everything of a mesh: the figures and histograms that the metrics declare.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/metric.h"

namespace isobench {

/// Raised when the meaning or the value of a figure changes: stored results of another revision are not reused. A new
/// figure does not raise it.
inline constexpr int metrics_revision = 5;

/// A value or "not measured" for each declared figure. A figure may also be unknown: the program that wrote the record
/// did not declare it yet, or nobody asked for it. Names that no metric declares are mistakes in the code and throw
/// std::logic_error.
///
/// Very many of these are held at once: a figure takes 8 bytes.
class Measurement {
 public:
  /// Nothing is measured.
  Measurement();

  /// std::nullopt where the figure was not measured.
  std::optional<double> figure(std::string_view name) const { return at(figure_index(name)); }
  /// NaN where the figure was not measured: for means and plots, which leave out what is not finite.
  double number(std::string_view name) const { return values_[figure_index(name)]; }
  /// A value that is not finite counts as not measured. Throws std::logic_error for a count that is no whole number.
  void set(std::string_view name, std::optional<double> value) { set_at(figure_index(name), value); }

  /// The same by the place in declared_figures().
  std::optional<double> at(std::size_t figure) const;
  double number_at(std::size_t figure) const { return values_[figure]; }
  void set_at(std::size_t figure, std::optional<double> value);

  /// Whether the program that measured knew the figure and was to measure it.
  bool is_known(std::size_t figure) const;
  void set_unknown(std::size_t figure);

  /// Without bins where it was not measured.
  const Histogram& histogram(std::string_view name) const { return histograms_[histogram_index(name)]; }
  Histogram& histogram(std::string_view name) { return histograms_[histogram_index(name)]; }
  const Histogram& histogram_at(std::size_t index) const { return histograms_[index]; }
  Histogram& histogram_at(std::size_t index) { return histograms_[index]; }

 private:
  std::vector<double> values_;          ///< one for each declared figure; NaN: not measured
  std::vector<Histogram> histograms_;   ///< one for each declared histogram
  std::vector<std::uint16_t> unknown_;  ///< figures, sorted
};

/// What a mesh is measured against, as far as it is known. Whatever is missing leaves the figures that need it "not
/// measured".
struct MeasuredAgainst {
  const Isosurface* surface = nullptr;  ///< in whose lattice frame the mesh is
  const SizingField* sizing = nullptr;
  const CertifiedTopology* topology = nullptr;  ///< of the surface; computed where it is not given
};

/// Which metrics measure() calls.
enum class MetricChoice {
  usual,  ///< those whose `when` is `always`; the figures of the others stay unknown
  all,
};

/// Measures a mesh by every metric that has what it needs, and adds data arrays for viewers to the mesh: "radius_ratio"
/// for each triangle; "valence", "h0" and "distance" for each vertex. Shared parts, such as the mesh's edges, are
/// computed once.
/// Throws DataError for a mesh without triangles, indices out of range or coordinates that are not finite or beyond
/// 1e12 mm; Cancelled.
Measurement measure(TriangleMesh& mesh, const MeasuredAgainst& against, Monitor& monitor,
                    MetricChoice choice = MetricChoice::all);

/// Against a surface and a sizing.
Measurement measure(TriangleMesh& mesh, const Isosurface& surface, const SizingField& sizing, Monitor& monitor);

}  // namespace isobench
