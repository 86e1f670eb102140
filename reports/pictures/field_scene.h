// Scenes of fields that metrics keep with meshes (FieldDeclaration).
#pragma once

#include "isobench/metrics/metric.h"
#include "isobench/reports/pictures/render.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// The largest value that the mesh has of a field; 0 if it does not have the field.
double largest_value(const FieldDeclaration& field, const TriangleMesh& mesh);

/// The mesh coloured by the field, grey if it does not have it, with the place that the run's figures mark. `largest`:
/// of all meshes that are shown side by side. Keeps a pointer to the mesh.
Scene field_scene(const FieldDeclaration& field, const TriangleMesh& mesh, const RunRecord& run, double largest);

}  // namespace isobench
