#include "isobench/methods/sizing/sizing_field.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isobench/foundation/error.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/sizing/limit.h"
#include "isobench/methods/sizing/medial_axis/axis_difference.h"
#include "isobench/methods/sizing/medial_axis/axis_ends.h"
#include "isobench/methods/sizing/medial_axis/foot_points.h"
#include "isobench/methods/sizing/medial_axis/point_tree.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

namespace {

void require_positive(const std::optional<double>& value, const std::string& name) {
  if (value && !(std::isfinite(*value) && *value > 0.0)) {
    throw UsageError(fmt::format("{} is {}; it must be a finite number above 0", name, *value));
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// min(λ, 1/|κ_max|) for a band node.
class RadiusAt {
 public:
  RadiusAt(const Isosurface& surface, const SurfaceSamples& samples, const FeatureSize& feature_size, SizingNodes nodes)
      : surface_(surface),
        nodes_(nodes),
        samples_(samples),
        sample_tree_(samples.points),
        feature_size_(feature_size),
        least_slope_(0.01 * median(samples.slope)),
        largest_curvature_(2.0 / surface.voxel()) {}

  double operator()(const Eigen::Vector3d& node) const {
    const Eigen::Vector3d x = nodes_ == SizingNodes::bounding ? node : foot_of(node);
    const double lambda = feature_size_(x);
    const Jet jet = surface_.jet(x);
    // Where the gradient almost vanishes, its direction is arbitrary, and so is the curvature.
    if (jet.gradient.norm() < least_slope_) return lambda;
    return std::min(lambda, 1.0 / std::min(curvatures(jet).max_abs(), largest_curvature_));
  }

 private:
  Eigen::Vector3d foot_of(const Eigen::Vector3d& node) const {
    const auto foot = surface_.project(node);
    // Newton's method may fail on a ridge far from the surface. The nearest sample approximates the foot there.
    return foot ? *foot : samples_.points[sample_tree_.nearest(node).first];
  }

  const Isosurface& surface_;
  SizingNodes nodes_;
  const SurfaceSamples& samples_;
  PointTree sample_tree_;
  const FeatureSize& feature_size_;
  double least_slope_;
  double largest_curvature_;
};

std::vector<float> initial_field(const Isosurface& surface, const Band& band, const RadiusAt& radius,
                                 const SizingRequest& request, Monitor& monitor) {
  const double floor = request.floor * surface.voxel();
  std::vector<float> h0(band.size());
  constexpr std::size_t slice = 1 << 17;
  for (std::size_t first = 0; first < h0.size(); first += slice) {
    monitor.progress(static_cast<double>(first) / static_cast<double>(h0.size()));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first, std::min(h0.size(), first + slice), 256),
                      [&](const auto& range) {
                        for (std::size_t n = range.begin(); n < range.end(); ++n) {
                          const double length = 2.0 * *request.epsilon * radius(band.position(n));
                          h0[n] = static_cast<float>(std::max(floor, length));
                        }
                      });
  }
  return h0;
}

/// Records how sizes from foot points differ from sizes from shrinking balls, as counters and as an artefact.
void show_difference(const SurfaceSamples& samples, const MedialBalls& feet, double voxel, double cap,
                     Monitor& monitor) {
  const auto stage = monitor.stage("difference");
  AxisDifference difference = axis_difference(samples, feet, shrinking_balls(samples, voxel, cap, monitor), voxel, cap);
  monitor.set("axis/difference median %", 100.0 * difference.median);
  monitor.set("axis/difference p95 voxels", difference.p95);
  monitor.set("axis/differing by a voxel %", difference.differing);
  const std::array<const char*, 3> places = {"thin", "missed", "other"};
  for (std::size_t p = 0; p < places.size(); ++p) {
    monitor.set(std::string("axis/share %, ") + places[p], difference.share[p]);
    monitor.set(std::string("axis/share of the differing %, ") + places[p], difference.share_of_differing[p]);
  }
  Artefact shown;
  shown.points = samples.points;
  for (std::size_t n = 0; n < samples.points.size(); ++n) {
    shown.data["difference"].push_back(difference.by_feet[n] - difference.by_balls[n]);
    shown.data["place"].push_back(static_cast<double>(difference.place[n]));
  }
  shown.data["foot-points"] = std::move(difference.by_feet);
  shown.data["shrinking-balls"] = std::move(difference.by_balls);
  monitor.artefact("axis-difference", std::move(shown));
}

MedialBalls axis_of_feet(const Isosurface& surface, const SurfaceSamples& samples, const SizingStages& stages,
                         double cap, Monitor& monitor) {
  MedialBalls axis = foot_point_axis(surface, samples, monitor, stages.axis_halvings);
  monitor.set("axis/points", static_cast<double>(axis.centres.size()));
  if (stages.axis_ends == AxisEnds::left_out) return axis;
  const MedialBalls ends = axis_ends(samples, cap, monitor);
  monitor.set("axis/ends", static_cast<double>(ends.centres.size()));
  axis.centres.insert(axis.centres.end(), ends.centres.begin(), ends.centres.end());
  axis.radii.insert(axis.radii.end(), ends.radii.begin(), ends.radii.end());
  return axis;
}

FeatureSize feature_size_of(const Isosurface& surface, const SurfaceSamples& samples, const SizingStages& stages,
                            Monitor& monitor) {
  // No ball inside the object is larger than half the volume's shortest side.
  const double cap = 0.5 * surface.extent().minCoeff();
  const bool feet = stages.medial_axis == MedialAxis::foot_points;
  const MedialBalls axis = feet ? axis_of_feet(surface, samples, stages, cap, monitor)
                                : shrinking_balls(samples, surface.voxel(), cap, monitor);
  if (monitor.keeps_artefacts()) monitor.artefact("medial-axis", {axis.centres, {{"radius", axis.radii}}});
  if (!feet) return {axis, surface.voxel()};  // the balls are bounded by the cap already
  if (monitor.keeps_artefacts()) show_difference(samples, axis, surface.voxel(), cap, monitor);
  return {axis, surface.voxel(), cap};
}

void show(const Band& band, const std::vector<float>& h0, const std::vector<float>& h, Monitor& monitor) {
  if (!monitor.keeps_artefacts()) return;
  Artefact nodes;
  for (std::size_t n = 0; n < band.size(); ++n) nodes.points.push_back(band.position(n));
  nodes.data["h0"].assign(h0.begin(), h0.end());
  nodes.data["h"].assign(h.begin(), h.end());
  monitor.artefact("sizing", std::move(nodes));
}

double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    area += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return area;
}

}  // namespace

SizingRequest scaled(const SizingRequest& request, double factor) {
  SizingRequest result = request;
  result.floor *= factor;
  if (result.epsilon) *result.epsilon *= factor;
  if (result.edge_length) *result.edge_length *= factor;
  if (result.vertices) *result.vertices /= factor * factor;
  return result;
}

void check(const SizingRequest& request) {
  const bool adaptive = request.epsilon.has_value() || request.delta.has_value();
  const int kinds = (adaptive ? 1 : 0) + (request.edge_length ? 1 : 0) + (request.vertices ? 1 : 0);
  if (kinds != 1) {
    throw UsageError(
        fmt::format("the sizing asks for {}; give exactly one of: epsilon and delta, edge_length, vertices",
                    kinds == 0 ? "nothing" : "more than one thing"));
  }
  if (adaptive && !(request.epsilon && request.delta)) {
    throw UsageError(fmt::format("{} is given without {}; an adaptive sizing needs both",
                                 request.epsilon ? "epsilon" : "delta", request.epsilon ? "delta" : "epsilon"));
  }
  require_positive(request.epsilon, "epsilon");
  require_positive(request.delta, "delta");
  require_positive(request.floor, "floor");
  require_positive(request.edge_length, "edge_length");
  require_positive(request.vertices, "vertices");
  // triangles have 32-bit vertex indices
  if (request.vertices.value_or(0.0) > 4e9) throw UsageError("vertices must be at most 4e9");
}

SizingField::SizingField(std::shared_ptr<const Band> band, std::vector<float> h0, std::vector<float> h, double floor)
    : floor_(floor), band_(std::move(band)), h0_(std::move(h0)), h_(std::move(h)) {}

double SizingField::h0(const Eigen::Vector3d& x) const {
  return uniform() ? uniform_length_ : band_->interpolate(h0_, x).value_or(floor_);
}

double SizingField::h(const Eigen::Vector3d& x) const {
  return uniform() ? uniform_length_ : band_->interpolate(h_, x).value_or(floor_);
}

double SizingField::smallest() const {
  if (uniform()) return uniform_length_;
  return h_.empty() ? floor_ : static_cast<double>(*std::min_element(h_.begin(), h_.end()));
}

double SizingField::largest() const {
  if (uniform()) return uniform_length_;
  return h_.empty() ? floor_ : static_cast<double>(*std::max_element(h_.begin(), h_.end()));
}

double edge_length_for(double area, double vertices) { return std::sqrt(2.0 * area / (std::sqrt(3.0) * vertices)); }

SizingField make_sizing_field(const Isosurface& surface, const SizingRequest& request, Monitor& monitor,
                              const SizingStages& stages) {
  check(request);
  if (request.edge_length) return SizingField(*request.edge_length);
  const TriangleMesh lattice_mesh = [&] {
    const auto stage = monitor.stage("samples");
    return marching_cubes(surface, monitor);
  }();
  if (request.vertices && lattice_mesh.vertices.empty())
    throw UsageError("the surface lies between the nodes, so its area is not known; ask for edge_length, not vertices");
  if (request.vertices) return SizingField(edge_length_for(area_of(lattice_mesh), *request.vertices));

  const double floor = request.floor * surface.voxel();
  const auto band = std::make_shared<const Band>(surface, stages.nodes == SizingNodes::bounding ? 0 : 2);
  if (lattice_mesh.vertices.empty()) {  // every feature is smaller than a voxel
    const std::vector<float> h(band->size(), static_cast<float>(floor));
    return {band, h, h, floor};
  }
  const SurfaceSamples samples = [&] {
    const auto stage = monitor.stage("samples");
    return surface_samples(surface, lattice_mesh.vertices);
  }();
  const FeatureSize feature_size = [&] {
    const auto stage = monitor.stage("axis");
    return feature_size_of(surface, samples, stages, monitor);
  }();
  std::vector<float> h0 = [&] {
    const auto stage = monitor.stage("band");
    return initial_field(surface, *band, RadiusAt(surface, samples, feature_size, stages.nodes), request, monitor);
  }();
  const auto stage = monitor.stage("limit");
  constexpr double published_stop = 1e-5;
  std::vector<float> h = stages.limiter == Limiter::iteration
                             ? iterate_limit(*band, h0, *request.delta, published_stop, monitor)
                             : limit_gradient(*band, h0, *request.delta, monitor);
  show(*band, h0, h, monitor);
  return {band, std::move(h0), std::move(h), floor};
}

}  // namespace isobench
