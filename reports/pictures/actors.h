// What a picture shows, as VTK draws it.
#pragma once

#include <vtkRenderer.h>

#include "isobench/reports/pictures/render.h"

namespace isobench {

/// Adds the mesh, the points and the marks of a scene to the picture, and its colour bar to the strip beside it. The
/// scene must outlive both.
void add_actors(const Scene& scene, const View& view, vtkRenderer& picture, vtkRenderer& strip);

}  // namespace isobench
