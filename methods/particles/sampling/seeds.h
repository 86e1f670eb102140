// Seeds: points on the surface at the density that the sizing asks for, by weighted sample elimination (Yuksel 2015).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/sampling/size_bounds.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::particles {

/// How far apart particles shall be at a point: h/g.
struct Spacing {
  const SizingField& field;
  double contraction = 1.0;           ///< g
  const SizeBounds* finer = nullptr;  ///< where h is smaller than the field can say
  double operator()(const Eigen::Vector3d& x) const {
    const double h = field.h(x);
    return (finer == nullptr ? h : std::min(h, finer->bound(x))) / contraction;
  }
};

/// Σ area · 2/(√3 h²): how many particles a hexagonal packing of that spacing has on the mesh.
double ideal_count(const TriangleMesh& mesh, const Spacing& spacing);

/// About `count` points on F = c: `per_particle` random candidates for each are drawn on the mesh with density 1/h²,
/// projected, and those most crowded are taken away one by one. In Morton order, no two at the same place.
/// The same seed gives the same points for any number of threads.
std::vector<Eigen::Vector3d> eliminate_to_seeds(const Isosurface& surface, const TriangleMesh& mesh,
                                                const Spacing& spacing, std::size_t count, double per_particle,
                                                std::uint64_t seed, Monitor& monitor);

/// Every fourth vertex of the mesh, projected to F = c: the seeds of the published method. Of coincident ones the
/// first.
std::vector<Eigen::Vector3d> lattice_seeds(const Isosurface& surface, const TriangleMesh& mesh);

}  // namespace isobench::particles
