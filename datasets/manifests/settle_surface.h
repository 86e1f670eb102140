// What is decided about a surface before anything is meshed: whether there is one, and at which isovalue.
#pragma once

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Proves the topology of the dataset's surface and stores it there. If the isovalue is no regular value of F, moves it
/// (find_regular_value), with a note; with `exact_isovalue` it is refused instead. Components that enclose less than
/// `min_component` are marked as left out, with a note. Throws DataError, with what may be done, if F = c is empty,
/// no surface or one that leaves the volume, or if all components would be left out; Cancelled. Stage "topology" of the
/// monitor.
///
/// Artefact "topology": the middles of the boxes of the proof that are smaller than a cell of the lattice, with "size"
/// (mm, the longest side), "depth" (how often the cell was cut) and "component". Small features lie there.
void settle_surface(Dataset& dataset, const SurfaceChoices& choices, Monitor& monitor);

}  // namespace isobench
