// The makers of phantoms that have a file of their own; phantoms.cpp lists them.
#pragma once

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {

/// Two spheres of one radius along the x axis, `gap` apart (mm). Known: all but the name and the title are filled in.
Phantom sphere_pair(double radius, double gap);

/// Two round plates across the z axis with rounded rims, `thickness` thick and `gap` apart (mm).
Phantom thin_sheets(double thickness, double gap);

/// Spheres of radius 10 mm, `gap` apart (mm).
Phantom near_spheres(double gap);

/// The union of vessel_tree().
Phantom vessel_tree_phantom();

}  // namespace isobench
