// Limiting the gradient of the sizing field (Meyer, Kirby, Whitaker 2007, equations 2 and 3; Persson 2006).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

/// Band numbers of the six nodes around a node, at −x, +x, −y, +y, −z, +z; −1 for a node outside the band.
using LatticeNeighbours = std::array<std::int32_t, 6>;

LatticeNeighbours lattice_neighbours(const Band& band, std::size_t n);

/// The largest field h ≤ h0 on the band whose upwind gradient norm is at most δ. It is the fixed point of the paper's
/// explicit iteration. The fast iterative method (Jeong, Whitaker 2008) finds it: each pass visits only the nodes next
/// to one that has just changed, until no node changes.
///
/// Equation 3 sums over both sides of each axis. So a node's value is min(h0, U), where U solves
/// Σ max(0, (U − u)/s)² = δ² over *all* lower neighbours u, up to six, at distances s. The usual scheme takes only the
/// smaller neighbour of each axis and has another fixed point.
///
/// `h0` and the result have one value per band node, mm. The result does not depend on the number of threads. Cost: up
/// to a dozen visits a node where sizes vary widely, on all threads; 20 bytes a node while it runs.
std::vector<float> limit_gradient(const Band& band, const std::vector<float>& h0, double delta, Monitor& monitor);

/// The same field as published: iterates equation 2 on all nodes at once, with Δt = a sixth of the smallest node
/// spacing, until no node's relative change in a step exceeds `stop` (1e-5 in the paper). The iteration approaches the
/// fixed point from above and stops short of it by some tens of times `stop`.
///
/// The result does not depend on the number of threads. Cost: hundreds of passes over the band on all threads; 40 bytes
/// a node. Counter "limiter/passes".
std::vector<float> iterate_limit(const Band& band, const std::vector<float>& h0, double delta, double stop,
                                 Monitor& monitor);

/// Equation 3 at one node: the upwind gradient norm, without neighbours outside the band.
double upwind_gradient_norm(const Band& band, const std::vector<float>& h, std::size_t node);

}  // namespace isobench
