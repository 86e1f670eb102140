// The advancing front's own sizing, from curvature alone (Schreiner, Scheidegger, Silva 2006).
#pragma once

#include <cstdint>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::advancing_front {

struct GuidanceOptions {
  double rho = 0.19634954084936207;  ///< radians, angle of an edge at the centre of the tightest circle; 2π/32
  double eta = 0.8;                  ///< in (0, 1): steps are ηL at a sample and grow from there with slope 1 − η
  double floor = 0.0;                ///< mm, lower bound on steps
  std::uint64_t seed = 1;            ///< of the jitter
};

/// The guidance field step(x) = min_i ((1 − η)|x − p_i| + ηL_i), with L_i = 2 sin(ρ/2)/|κ_max|, over samples p_i of the
/// surface. Every lattice cell that the surface crosses is divided into 4×4×4 parts; a jittered point in each part near
/// the surface is projected to it. The minimum is evaluated at the corners of the sample's cell; the limiter of the
/// shared field extends it along the band with slope 1 − η. Between nodes the field is trilinear. Steps are at most a
/// quarter of the volume's shortest side, and |κ| is taken as at most 2/voxel. The result's h is the step, its h0 the
/// step before limiting. Multi-threaded; the result is the same for any number of threads. Throws Cancelled. Cost:
/// about 64 values of f per crossed cell.
SizingField guidance_field(const Isosurface& surface, const GuidanceOptions& options, Monitor& monitor);

}  // namespace isobench::advancing_front
