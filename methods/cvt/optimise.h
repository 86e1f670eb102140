// Moving points on a surface to a centroidal Voronoi tessellation: each point at the centroid of its cell (Du, Faber,
// Gunzburger 1999), which is where the energy Σ ∫ρ|x − p|² is least or stationary.
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/cvt/delaunay_mesh.h"
#include "isobench/methods/particles/sampling/relaxation.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::cvt {

struct Iterations {
  int lloyd = 0;         ///< every point to the centroid of its cell (Lloyd 1982)
  int quasi_newton = 0;  ///< L-BFGS, at most (Liu, Wang, Lévy et al. 2009)
};

struct Optimised {
  int lloyd = 0;
  int quasi_newton = 0;
  std::size_t flips = 0;
  std::size_t shortened = 0;  ///< steps of quasi-Newton that would have raised the energy
  double energy = 0.0;        ///< over that of regular hexagons
};

/// Moves the sites over F = c and keeps the mesh Delaunay. Quasi-Newton's gradient is 2m(p − c) in the tangent plane;
/// it starts from the inverse of 2m and remembers seven steps. Both end early where the energy has stopped falling.
/// Traces "energy", over that of regular hexagons, before each iteration and at the end. Deterministic for any number
/// of threads. Cost: about 2 µs a point and iteration.
Optimised optimise(const Isosurface& surface, const particles::Spacing& spacing, particles::Particles& sites,
                   DelaunayMesh& mesh, const Iterations& iterations, Monitor& monitor);

}  // namespace isobench::cvt
