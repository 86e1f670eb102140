// Components of the nodes of a mask.
#pragma once

#include <cstddef>

#include "isobench/datasets/volume.h"

namespace isobench {

/// The number of components of the nodes > 0, where the 26 nodes around a node are its neighbours. Linear time.
std::size_t count_components(const Volume& volume);

}  // namespace isobench
