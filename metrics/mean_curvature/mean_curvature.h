// The curvature that a mesh shows: the Laplacian of its coordinates, −Δx = 2H n (Pinkall and Polthier 1993).
#pragma once

#include <optional>
#include <vector>

#include "isobench/metrics/finite_elements/finite_elements.h"
#include "isobench/metrics/foot_points/foot_points.h"

namespace isobench {

/// The largest |K x/(2 M_L) − H n| over the root mean square of H, weighted by M_L, over the unknowns that are not on a
/// border and have a foot point. `feet` are those of the mesh's vertices. std::nullopt where there is none or H is 0.
/// On a sphere, meshes without obtuse triangles differ from H n only by their unequal areas.
std::optional<double> curvature_error(const FiniteElements& elements, const TriangleMesh& mesh,
                                      const std::vector<FootPoint>& feet);

}  // namespace isobench
