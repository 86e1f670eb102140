// The areas that the sizing asks of triangles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/finish/editable_mesh.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// At a point with spacing h, a triangle should have the area s (√3/4) h². The cure's bounds count in h: places where
/// they made h small have more particles, which the finish does not remove. The factor s is the same everywhere, so
/// that the areas asked of a mesh sum to its area.
class AskedAreas {
 public:
  /// Keeps a reference to `sized`. Cost: one evaluation of the sizing at each corner of each triangle.
  AskedAreas(const SizedSurface& sized, const TriangleMesh& mesh);

  /// mm²
  double at(const Eigen::Vector3d& x) const {
    const double h = sized_.spacing(x);
    return factor_ * h * h;
  }
  /// At every vertex of the mesh.
  std::vector<double> at_vertices(const EditableMesh& mesh) const;

 private:
  const SizedSurface& sized_;
  double factor_ = 1.0;
};

}  // namespace isobench::particles
