// The areas that the sizing asks of triangles.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// At a point with spacing h, a triangle should have the area s (√3/4) h². The bounds count in h: places where they
/// made h small have more particles, and only easing removes some of them. The factor s is the same everywhere, so that
/// the areas asked of a mesh sum to its area.
class AskedAreas {
 public:
  /// Keeps a reference to `sized`. Cost: one evaluation of the sizing at each corner of each triangle.
  AskedAreas(const SizedSurface& sized, const TriangleMesh& mesh);

  /// A bound with an index into sized.bounds(), and the least h to which it counts, mm.
  struct RaisedBound {
    std::uint32_t bound = 0;
    double least_h = 0.0;
  };
  /// The areas that would be asked if only these of the bounds counted, with the same s.
  AskedAreas with_bounds(std::vector<RaisedBound> kept) const;

  /// mm²
  double at(const Eigen::Vector3d& x) const {
    const double h = spacing(x);
    return factor_ * h * h;
  }
  /// At every vertex of the mesh.
  std::vector<double> at_vertices(const EditableMesh& mesh) const;

 private:
  double spacing(const Eigen::Vector3d& x) const;

  const SizedSurface* sized_;
  double factor_ = 1.0;
  std::optional<std::vector<RaisedBound>> kept_;  // none: all bounds count
};

/// For each vertex, a third of the area of its triangles over twice the area asked of a triangle, because a mesh has
/// two triangles a vertex. 1 for a removed vertex.
std::vector<double> area_shares(const EditableMesh& mesh, const AskedAreas& areas);

}  // namespace isobench::particles
