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

/// What counts as zero.
struct Margins {
  double value = 0.0;  ///< values of f up to this: what is proven holds for f = v of every v from −value to value
  double difference = 0.0;  ///< differences of neighbouring coefficients up to this
};

BoxState examine(const Tricubic& f, const Margins& margins);

/// Whether it is proven that no point of the box has both a value from `low` to `high` and a gradient of zero.
bool is_regular(const Tricubic& f, double low, double high, double margin);

}  // namespace isobench
