// What a metric is given to measure, and where it puts what it measured.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isobench/metrics/measurement.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

// Their headers are long, and few metrics need them.
struct FiniteElements;
struct ScreenedSystem;

/// A mesh with what it is measured against. Parts that several metrics need are computed at the first call and kept.
/// Without locks: metrics run one after the other.
class MetricInput {
 public:
  /// Keeps references.
  MetricInput(const TriangleMesh& mesh, const MeasuredAgainst& against, Monitor& monitor);
  ~MetricInput();
  MetricInput(const MetricInput&) = delete;
  MetricInput& operator=(const MetricInput&) = delete;

  /// In the lattice frame of the surface; a mesh that is measured without a surface is in its file's frame.
  const TriangleMesh& mesh() const { return mesh_; }
  const Isosurface& surface() const { return *against_.surface; }  ///< precondition: the metric needs it
  const SizingField& sizing() const { return *against_.sizing; }   ///< precondition: the metric needs it
  /// For metrics of a mesh alone that judge it by what was asked for, where that is known; else nullptr.
  const SizingField* sizing_if_given() const { return against_.sizing; }
  /// Whether there is a sizing, and it is not the same everywhere.
  bool is_adaptive() const { return against_.sizing != nullptr && !against_.sizing->uniform(); }
  Monitor& monitor() const { return monitor_; }

  const std::vector<HalfEdge>& half_edges();
  const MeshEdges& edges();
  const FiniteElements& finite_elements();
  /// Its seconds are booked to a stage "factorize" of the metric that asks first. Precondition: the finite elements are
  /// regular.
  const ScreenedSystem& screened_system();
  /// step_factor() for h² = finite_elements().mean_squared_edge() everywhere: h² times the largest eigenvalue of M⁻¹K.
  /// std::nullopt where it is not found. Precondition: the finite elements are regular.
  std::optional<double> uniform_step_factor();
  /// h0 at each vertex, mm. Precondition: the metric needs the sizing. One interpolation a vertex, all threads.
  const std::vector<double>& h0();
  /// Of the surface itself. Precondition: the metric needs the surface. For its cost see certified_topology().
  const CertifiedTopology& topology();

 private:
  const TriangleMesh& mesh_;
  const MeasuredAgainst& against_;
  Monitor& monitor_;
  std::optional<std::vector<HalfEdge>> half_edges_;
  std::optional<MeshEdges> edges_;
  std::unique_ptr<const FiniteElements> finite_elements_;
  std::unique_ptr<const ScreenedSystem> screened_system_;
  std::optional<std::optional<double>> step_factor_;  ///< the inner one: whether it was found
  std::optional<std::vector<double>> h0_;
  std::optional<CertifiedTopology> topology_;
};

/// Takes what one metric measures. Throws std::logic_error for a figure or histogram that this metric does not declare.
class MetricOutput {
 public:
  MetricOutput(const Metric& metric, Measurement& measurement, TriangleMesh& mesh)
      : metric_(metric), measurement_(measurement), mesh_(mesh) {}

  /// std::nullopt, or a number that is not finite, leaves the figure "not measured".
  void set(std::string_view figure, std::optional<double> value);
  void set(std::string_view histogram, Histogram counts);
  /// Data arrays for viewers; they are stored with the mesh.
  void add_vertex_data(const std::string& name, std::vector<double> values);
  void add_triangle_data(const std::string& name, std::vector<double> values);

 private:
  const Metric& metric_;
  Measurement& measurement_;
  TriangleMesh& mesh_;
};

}  // namespace isobench
