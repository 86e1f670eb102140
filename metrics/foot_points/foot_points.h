// The points of the surface F = c that points near it stand for, with F's derivatives there.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct FootPoint {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< mm, in the surface's lattice frame
  Jet jet;                                      ///< of f at x
  bool exists = false;                          ///< false where the gradient vanishes
  bool projected = false;                       ///< whether x is on the surface

  Eigen::Vector3d normal() const { return outward_normal(jet.gradient); }
  /// (κ1 + κ2)/2 of the surface through x, 1/mm, positive where the object is convex.
  double mean_curvature() const;
};

/// Newton's steps along the gradient go to the surface. If they do not reach it, the level set through the point itself
/// stands for it. One projection and one jet a point, all threads.
std::vector<FootPoint> foot_points(const Isosurface& surface, const std::vector<Eigen::Vector3d>& points);

/// False if the surface is out of reach of all points: what is measured at their feet then says nothing of it.
bool any_projected(const std::vector<FootPoint>& feet);

/// Of each triangle of a mesh.
std::vector<Eigen::Vector3d> centroids(const TriangleMesh& mesh);

}  // namespace isobench
