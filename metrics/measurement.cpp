#include "isobench/metrics/measurement.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "isobench/foundation/error.h"
#include "isobench/metrics/finite_elements/screened_system.h"
#include "isobench/metrics/finite_elements/step_factor.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {

namespace {

void check_mesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw DataError("the mesh has no triangles; there is nothing to measure");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw DataError(fmt::format("vertex {} of the mesh is at ({}, {}, {}); coordinates must be finite numbers", v,
                                  mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()));
    }
    // A million kilometres. No mesh in mm reaches that far; much farther, squares of lengths overflow.
    if (mesh.vertices[v].cwiseAbs().maxCoeff() > 1e12) {
      throw DataError(
          fmt::format("vertex {} of the mesh is at ({}, {}, {}); coordinates must be in mm, within 1e12 of 0", v,
                      mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z()));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.vertices.size()) continue;
      throw DataError(fmt::format("triangle {} of the mesh names vertex {}, but there are {} vertices, counted from 0",
                                  t, v, mesh.vertices.size()));
    }
  }
}

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

bool has_what_it_needs(const Metric& metric, const MeasuredAgainst& against) {
  switch (metric.needs) {
    case Needs::mesh:
      return true;
    case Needs::surface:
      return against.surface != nullptr;
    case Needs::sizing:
      return against.sizing != nullptr;
  }
  return false;
}

void check_kind(const FigureDeclaration& figure, double value) {
  if (figure.kind == Kind::number) return;
  if (value == std::floor(value) && (value >= 0.0 || figure.kind == Kind::integer)) return;
  throw std::logic_error(fmt::format("{} is {}, which is no {}", figure.name, value,
                                     figure.kind == Kind::count ? "count" : "whole number"));
}

}  // namespace

Measurement::Measurement()
    : values_(declared_figures().size(), not_measured), histograms_(declared_histograms().size()) {}

std::optional<double> Measurement::at(std::size_t figure) const {
  return std::isnan(values_[figure]) ? std::nullopt : std::optional<double>(values_[figure]);
}

void Measurement::set_at(std::size_t figure, std::optional<double> value) {
  if (value && std::isfinite(*value)) {
    check_kind(declared_figures()[figure], *value);
    values_[figure] = *value;
  } else {
    values_[figure] = not_measured;
  }
  std::erase(unknown_, figure);
}

bool Measurement::is_known(std::size_t figure) const {
  return !std::binary_search(unknown_.begin(), unknown_.end(), figure);
}

void Measurement::set_unknown(std::size_t figure) {
  if (!is_known(figure)) return;
  values_[figure] = not_measured;
  unknown_.insert(std::lower_bound(unknown_.begin(), unknown_.end(), figure), static_cast<std::uint16_t>(figure));
}

MetricInput::MetricInput(const TriangleMesh& mesh, const MeasuredAgainst& against, Monitor& monitor)
    : mesh_(mesh), against_(against), monitor_(monitor) {}

MetricInput::~MetricInput() = default;

const std::vector<HalfEdge>& MetricInput::half_edges() {
  if (!half_edges_) half_edges_ = sorted_half_edges(mesh_);
  return *half_edges_;
}

const MeshEdges& MetricInput::edges() {
  if (!edges_) edges_ = mesh_edges(mesh_, half_edges());
  return *edges_;
}

const FiniteElements& MetricInput::finite_elements() {
  if (!finite_elements_) {
    finite_elements_ = std::make_unique<FiniteElements>(isobench::finite_elements(mesh_, half_edges()));
  }
  return *finite_elements_;
}

const ScreenedSystem& MetricInput::screened_system() {
  const FiniteElements& elements = finite_elements();
  if (!screened_system_) {
    const auto stage = monitor_.stage("factorize");
    screened_system_ = std::make_unique<ScreenedSystem>(isobench::screened_system(elements));
  }
  return *screened_system_;
}

std::optional<double> MetricInput::uniform_step_factor() {
  const FiniteElements& elements = finite_elements();
  if (!step_factor_) {
    const double h = std::sqrt(elements.mean_squared_edge());
    step_factor_ = isobench::step_factor(elements, Eigen::VectorXd::Constant(elements.size(), h), monitor_);
  }
  return *step_factor_;
}

const std::vector<double>& MetricInput::h0() {
  if (!h0_) {
    h0_.emplace(mesh_.vertices.size());
    tbb::parallel_for(std::size_t{0}, h0_->size(), [&](std::size_t v) { (*h0_)[v] = sizing().h0(mesh_.vertices[v]); });
  }
  return *h0_;
}

const CertifiedTopology& MetricInput::topology() {
  if (against_.topology != nullptr) return *against_.topology;
  if (!topology_) topology_ = certified_topology(surface(), monitor_);
  return *topology_;
}

void MetricOutput::set(std::string_view figure, std::optional<double> value) {
  const std::size_t index = figure_index(figure);
  if (metric_of_figure(index).name != metric_.name) {
    throw std::logic_error(
        fmt::format("the metric {} sets {}, which {} declares", metric_.name, figure, metric_of_figure(index).name));
  }
  measurement_.set_at(index, value);
}

void MetricOutput::set(std::string_view histogram, Histogram counts) {
  const std::size_t index = histogram_index(histogram);
  if (metric_of_histogram(index).name != metric_.name) {
    throw std::logic_error(fmt::format("the metric {} sets the histogram {}, which {} declares", metric_.name,
                                       histogram, metric_of_histogram(index).name));
  }
  measurement_.histogram_at(index) = std::move(counts);
}

void MetricOutput::add_vertex_data(const std::string& name, std::vector<double> values) {
  if (values.size() != mesh_.vertices.size()) throw std::logic_error(name + " has not one value a vertex");
  mesh_.vertex_data[name] = std::move(values);
}

void MetricOutput::add_triangle_data(const std::string& name, std::vector<double> values) {
  if (values.size() != mesh_.triangles.size()) throw std::logic_error(name + " has not one value a triangle");
  mesh_.triangle_data[name] = std::move(values);
}

Measurement measure(TriangleMesh& mesh, const MeasuredAgainst& against, Monitor& monitor, MetricChoice choice) {
  check_mesh(mesh);
  Measurement measurement;
  MetricInput input(mesh, against, monitor);
  for (const Metric& metric : metrics()) {
    if (metric.when == When::on_request && choice == MetricChoice::usual) {
      for (const FigureDeclaration& figure : metric.figures) measurement.set_unknown(figure_index(figure.name));
      continue;
    }
    if (!has_what_it_needs(metric, against)) continue;
    monitor.check();
    const auto stage = monitor.stage(metric.stage.empty() ? metric.name : metric.stage);
    MetricOutput output(metric, measurement, mesh);
    metric.measure(input, output);
  }
  return measurement;
}

Measurement measure(TriangleMesh& mesh, const Isosurface& surface, const SizingField& sizing, Monitor& monitor) {
  return measure(mesh, MeasuredAgainst{&surface, &sizing}, monitor);
}

}  // namespace isobench
