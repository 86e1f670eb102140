// How long edges may be: h0 from feature size and curvature, and its gradient-limited version h
// (Meyer, Kirby, Whitaker 2007, section 3.2, equations 1–3).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

/// What is asked of the edge lengths: exactly one of (epsilon and delta), edge_length, vertices.
struct SizingRequest {
  std::optional<double> epsilon;      ///< > 0: h0 = max(floor, 2 ε min(λ, 1/|κ_max|))
  std::optional<double> delta;        ///< > 0: |∇h| ≤ δ
  double floor = 0.5;                 ///< voxels: h0 is not let fall below this
  std::optional<double> edge_length;  ///< mm, uniform
  std::optional<double> vertices;     ///< uniform, length solved for

  bool uniform() const { return !epsilon.has_value(); }
};

/// Throws UsageError if not exactly one kind of sizing is given, or a number is not finite and positive.
void check(const SizingRequest& request);

/// The request whose edge lengths are `factor` > 0 times this one's: h0 with its floor, at the same δ; the edge length;
/// or the length that a number of vertices stands for, so that the number is divided by factor².
SizingRequest scaled(const SizingRequest& request, double factor);

/// The sizing of one surface, defined within two nodes of it; lengths in mm. Farther away, where a point can only
/// belong to a mesh that missed the surface, it is the floor.
class SizingField {
 public:
  /// Uniform.
  explicit SizingField(double edge_length) : uniform_length_(edge_length) {}
  /// On a band; h0 and h hold one value a band node.
  SizingField(std::shared_ptr<const Band> band, std::vector<float> h0, std::vector<float> h, double floor);

  bool uniform() const { return band_ == nullptr; }
  /// Equation 1 with its floor, trilinear between nodes: *the* h0 of every table.
  double h0(const Eigen::Vector3d& x) const;
  /// h0 with its gradient limited to δ along the band, trilinear between nodes.
  double h(const Eigen::Vector3d& x) const;

  double floor_length() const { return floor_; }  ///< mm; 0 for a uniform field
  double smallest() const;                        ///< mm, of h
  double largest() const;                         ///< mm, of h
  const Band* band() const { return band_.get(); }
  const std::shared_ptr<const Band>& band_shared() const { return band_; }
  const std::vector<float>& h0_nodes() const { return h0_; }
  const std::vector<float>& h_nodes() const { return h_; }

 private:
  double uniform_length_ = 0.0;
  double floor_ = 0.0;
  std::shared_ptr<const Band> band_;
  std::vector<float> h0_;
  std::vector<float> h_;
};

enum class MedialAxis { shrinking_balls, foot_points };
/// Of foot points: whether the ends of the axis are left out, as published, or taken from the surface's curvature
/// (axis_ends.h).
enum class AxisEnds { left_out, curvature_centres };
enum class Limiter { fast_iterative, iteration };
/// Where h0 is computed. `projected`: within two nodes of the surface, λ and κ of the place where a node projects to.
/// `bounding`: as published, at the corners of the cells that the surface crosses, λ and κ of the node itself. Across
/// the surface λ then changes by a node's own distance, and the limiter, which brings the larger side down, leaves h
/// smaller by some tenths of a voxel.
enum class SizingNodes { projected, bounding };

/// How a field comes about. The defaults are *the* h0 and h of every table; a method may make its own field otherwise.
struct SizingStages {
  MedialAxis medial_axis = MedialAxis::shrinking_balls;
  Limiter limiter = Limiter::fast_iterative;
  SizingNodes nodes = SizingNodes::projected;
  AxisEnds axis_ends = AxisEnds::left_out;
  int axis_halvings = 0;  ///< of foot points: how often the lattice is halved near the surface; 0 as published
  bool operator==(const SizingStages&) const = default;
};

/// The vertex data in which a method that meshes by a field of its own leaves the h0 of that field (mm), so that its
/// edges can be measured against what it was aiming at, too.
inline constexpr const char* own_h0 = "own_h0";

/// Computes the field of a request, in stages "samples", "axis", "band", "limit" of the monitor's current stage.
/// Artefacts: "medial-axis", its points with their distance from the surface as "radius", and "sizing", the band's
/// nodes with "h0" and "h". With foot points also "axis-difference", the surface's samples with min(λ, 1/|κ|) by
/// "foot-points" and by "shrinking-balls", their "difference" (mm) and the "place" (0 thin, 1 missed, 2 other; see
/// axis_difference.h), and its figures as counters "axis/…": only where artefacts are kept, for it costs an axis more.
SizingField make_sizing_field(const Isosurface& surface, const SizingRequest& request, Monitor& monitor,
                              const SizingStages& stages = {});

/// The mean edge length of a mesh with `vertices` nearly equilateral triangles' corners on `area` mm²: √(2A/(√3 N)).
double edge_length_for(double area, double vertices);

}  // namespace isobench
