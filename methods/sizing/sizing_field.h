// The sizing field: h0, the largest edge length that feature size and curvature allow, and h, which is h0 with its
// gradient limited (Meyer, Kirby, Whitaker 2007, section 3.2, equations 1–3).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

/// The edge lengths that a task asks for: exactly one of (epsilon and delta), edge_length, vertices.
struct SizingRequest {
  std::optional<double> epsilon;      ///< > 0: h0 = max(floor, 2 ε min(λ, 1/|κ_max|))
  std::optional<double> delta;        ///< > 0: |∇h| ≤ δ
  double floor = 0.5;                 ///< voxels: lower bound on h0
  std::optional<double> edge_length;  ///< mm: the same length everywhere
  std::optional<double> vertices;     ///< number of vertices, with the same length everywhere

  bool uniform() const { return !epsilon.has_value(); }
};

/// Throws UsageError if not exactly one kind of sizing is given, or a number is not finite and positive.
void check(const SizingRequest& request);

/// The request with all edge lengths multiplied by `factor` > 0: ε and the floor at the same δ, or the edge length. A
/// number of vertices is divided by factor², which has the same effect.
SizingRequest scaled(const SizingRequest& request, double factor);

/// The sizing of one surface; lengths in mm. It is defined within two nodes of the surface. Farther away, where only
/// meshes that miss the surface have points, it is the floor.
class SizingField {
 public:
  /// A uniform field.
  explicit SizingField(double edge_length) : uniform_length_(edge_length) {}
  /// A field on a band; h0 and h have one value per band node.
  SizingField(std::shared_ptr<const Band> band, std::vector<float> h0, std::vector<float> h, double floor);

  bool uniform() const { return band_ == nullptr; }
  /// Equation 1 with its floor, trilinear between nodes. All tables use this h0.
  double h0(const Eigen::Vector3d& x) const;
  /// h0 with its gradient on the band limited to δ, trilinear between nodes.
  double h(const Eigen::Vector3d& x) const;

  double floor_length() const { return floor_; }  ///< mm; 0 for a uniform field
  double smallest() const;                        ///< smallest h, mm
  double largest() const;                         ///< largest h, mm
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
/// Whether an axis of foot points lacks its ends, as published, or has them from the surface's curvature (axis_ends.h).
enum class AxisEnds { left_out, curvature_centres };
enum class Limiter { fast_iterative, iteration };
/// The nodes on which h0 is computed. `projected`: all nodes within two nodes of the surface, with λ and κ at the point
/// to which the node projects. `bounding`, as published: the corners of the cells that the surface crosses, with λ and
/// κ at the node itself. Then λ varies across the surface; the limiter lowers the larger side, so h becomes smaller by
/// some tenths of a voxel.
enum class SizingNodes { projected, bounding };

/// How a field is computed. The defaults give the h0 and h by which all methods are measured; a method may follow a
/// field of its own.
struct SizingStages {
  MedialAxis medial_axis = MedialAxis::shrinking_balls;
  Limiter limiter = Limiter::fast_iterative;
  SizingNodes nodes = SizingNodes::projected;
  AxisEnds axis_ends = AxisEnds::left_out;
  int axis_halvings = 0;  ///< foot points only: number of halvings of the lattice near the surface; 0 as published
  bool operator==(const SizingStages&) const = default;
};

/// Name of the vertex data in which a method stores the h0 (mm) of a field of its own, so that its edges can be
/// measured against that field as well.
inline constexpr const char* own_h0 = "own_h0";

/// Computes the field of a request, in stages "samples", "axis", "band", "limit" of the monitor's current stage.
///
/// Artefacts: "medial-axis", the points of the axis with their distance from the surface as "radius"; and "sizing", the
/// nodes of the band with "h0" and "h". With foot points there is also "axis-difference": the samples of the surface
/// with min(λ, 1/|κ|) from "foot-points" and from "shrinking-balls", their "difference" (mm) and the "place" (0 thin,
/// 1 missed, 2 other; see axis_difference.h). Its figures are counters "axis/…". These exist only where artefacts are
/// kept, because they need a second axis.
SizingField make_sizing_field(const Isosurface& surface, const SizingRequest& request, Monitor& monitor,
                              const SizingStages& stages = {});

/// The edge length of N = `vertices` vertices in equilateral triangles on A = `area` mm²: √(2A/(√3 N)).
double edge_length_for(double area, double vertices);

}  // namespace isobench
