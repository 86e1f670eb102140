// Steps that a volume needs although nobody asks for them, because F can only be made of finite samples on a
// rectangular lattice.
#pragma once

#include <vector>

#include "isobench/datasets/preparation/prepare.h"

namespace isobench {

/// The steps, with FillOutside (if a sample is not finite) and Rectangular (if the lattice is not) before the first
/// step that needs them, or at the end. Threshold and SelectLabels need neither, and what is not finite is not
/// selected. `isovalue` and `object_below` are those of the surface that is made of the prepared volume.
std::vector<PrepareStep> with_needed_steps(std::vector<PrepareStep> steps, const Volume& volume, double isovalue,
                                           bool object_below);

}  // namespace isobench
