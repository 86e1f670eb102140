// The advancing front's own sizing: how long edges may be from curvature alone (Schreiner, Scheidegger, Silva 2006).
#pragma once

#include <cstdint>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::advancing_front {

struct GuidanceOptions {
  double rho = 0.19634954084936207;  ///< radians: an edge turns by ρ along the tightest circle; 2π/32
  double eta = 0.8;        ///< in (0, 1): steps are ηL at their tightest and grow from there with slope 1 − η
  double floor = 0.0;      ///< mm: no step is shorter
  std::uint64_t seed = 1;  ///< of the jitter
};

/// The guidance field step(x) = min_i ((1 − η)|x − p_i| + ηL_i), L_i = 2 sin(ρ/2)/|κ_max|, over samples p_i of the
/// surface: every cell of the lattice that it crosses is cut 4×4×4, and each part near the surface has one jittered
/// point projected onto it. The minimum is taken at the corners of the sample's cell and carried on along the band by
/// the same limiter as the shared field's, with slope 1 − η; it is trilinear in between. Steps are at most a quarter
/// of the volume's shortest side; |κ| is at most 2/voxel. The result's h is the step, its h0 the step before limiting.
/// Multi-threaded, the same for any number of threads. Throws Cancelled. Cost: about 64 values of f a crossed cell.
SizingField guidance_field(const Isosurface& surface, const GuidanceOptions& options, Monitor& monitor);

}  // namespace isobench::advancing_front
