// What the Bernstein coefficients prove of the surface F = c in a box. See certified_topology.h for why it is enough.
#pragma once

#include <cstdint>

#include "isobench/datasets/topology/tricubic.h"

namespace isobench {

enum class BoxKind : std::uint8_t {
  without_surface,  ///< F = c does not meet the closed box
  disc,             ///< F = c is one disc in the box, and crosses every face and edge of it at most once
  undecided,        ///< neither is proven
};

struct BoxState {
  BoxKind kind = BoxKind::undecided;
  std::uint8_t inside = 0;  ///< bit x + 2y + 4z: f > 0 at that corner
};

/// Values within `margin` of zero count as zero, and so do differences of neighbouring coefficients.
BoxState examine(const Tricubic& f, double margin);

/// Whether it is proven that no point of the box has both a value from `low` to `high` and a gradient of zero.
bool is_regular(const Tricubic& f, double low, double high, double margin);

}  // namespace isobench
