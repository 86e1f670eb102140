// Phantoms whose parts come close to each other. phantoms.cpp has the others and the list of all.
#pragma once

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {

/// Two spheres of one radius along the x axis, `gap` apart (mm); the caller sets name and title.
Phantom sphere_pair(double radius, double gap);

/// Two round plates with rounded rims, perpendicular to the z axis, `thickness` thick and `gap` apart (mm).
Phantom thin_sheets(double thickness, double gap);

/// Two spheres of radius 10 mm, `gap` apart (mm).
Phantom near_spheres(double gap);

/// The union of vessel_tree().
Phantom vessel_tree_phantom();

}  // namespace isobench
