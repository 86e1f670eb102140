// Limiting the gradient of the sizing field (Meyer, Kirby, Whitaker 2007, equations 2 and 3; Persson 2006).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

using LatticeNeighbours = std::array<std::int32_t, 6>;  // −x, +x, −y, +y, −z, +z; −1 outside the band
/// Band numbers of the six nodes around node n.
LatticeNeighbours lattice_neighbours(const Band& band, std::size_t n);

/// The largest field h ≤ h0 on the band whose upwind gradient norm is at most δ: the fixed point of the paper's
/// explicit iteration, found by passes over the nodes near which something has just changed (the fast iterative method
/// of Jeong, Whitaker 2008) until nothing does.
///
/// Equation 3 sums both sides of each axis, so a node's value is min(h0, U) with Σ max(0, (U − u)/s)² = δ² over *all*
/// lower neighbours u, up to six; the usual scheme with the smaller neighbour of each axis has another fixed point.
/// `h0` and the result hold one value a band node, mm. The same result for any number of threads. Cost: up to a dozen
/// visits a node where sizes vary widely, on all threads; 20 bytes a node while it runs.
std::vector<float> limit_gradient(const Band& band, const std::vector<float>& h0, double delta, Monitor& monitor);

/// The same field by the paper's own way: equation 2 iterated with Δt = a sixth of the smallest spacing, all nodes at
/// once, until no node's relative change in a step exceeds `stop` (1e-5 in the paper). It approaches the fixed point
/// from above and stops short of it: the distance left is some tens of times `stop`. Cost: hundreds of passes over the
/// band, multi-threaded (the result does not depend on the number of threads), 40 bytes a node. The number of passes
/// goes to the monitor as "limiter/passes".
std::vector<float> iterate_limit(const Band& band, const std::vector<float>& h0, double delta, double stop,
                                 Monitor& monitor);

/// Equation 3 at one node: the upwind gradient norm, nodes outside the band left out.
double upwind_gradient_norm(const Band& band, const std::vector<float>& h, std::size_t node);

}  // namespace isobench
