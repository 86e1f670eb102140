// The largest eigenvalues of the Laplacian on a small mesh: what its worst triangles do to explicit time steps and to
// the conditioning of linear systems.
#pragma once

#include <vector>

#include "isobench/methods/particles/mesh_edits/editable_mesh.h"

namespace isobench::particles {

/// With K and M the stiffness and the lumped mass of linear finite elements, D the diagonal of K, and values of zero at
/// the vertices that are fixed. On a lattice of equilateral triangles of the areas asked for, 6 and 1.5.
struct LocalSpectrum {
  double step_factor = 0.0;  ///< of M⁻¹K h², where (√3/4) h² is the area asked of triangles at a vertex
  double scaled = 0.0;       ///< of D⁻¹K
};

/// `areas` are those asked of triangles at the vertices, mm². By power iteration, within 1 %: eigenvalues of single bad
/// places stand apart from the others. Infinite where a triangle has no area. Cost: about 10 µs a vertex.
LocalSpectrum local_spectrum(const EditableMesh& mesh, const std::vector<double>& areas);

}  // namespace isobench::particles
