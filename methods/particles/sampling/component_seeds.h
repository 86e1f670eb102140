// Seeds on small components of F = c: islands and cavities that are smaller than the lattice or the sizing shows. Their
// number is proven (datasets/topology/certified_topology.h), so none of them may be missing in the mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// The component of F = c that each point is on or next to. Threads: all.
std::vector<std::uint32_t> components_at(const CertifiedTopology& topology, const std::vector<Eigen::Vector3d>& points);

/// Points on F = c, spread over each of the components whose entry in `chosen` is not 0; the lists are in the order of
/// the components. Time: linear in the number of boxes of the proof.
std::vector<std::vector<Eigen::Vector3d>> points_on_components(const Isosurface& surface,
                                                               const CertifiedTopology& topology,
                                                               const std::vector<char>& chosen);

/// On each component with fewer than 12 seeds, which is too few for a mesh of it, unless it is left out: adds a bound
/// on h, so that the spacing is two thirds of the component's half width, and seeds at this spacing, though at most
/// some thousands. Returns the number of such components. The result does not depend on the number of threads.
std::size_t add_component_seeds(const CertifiedTopology& topology, SizedSurface& sized,
                                std::vector<Eigen::Vector3d>& seeds);

}  // namespace isobench::particles
