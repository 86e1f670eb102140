// Scenes of fields that metrics keep with meshes (FieldDeclaration).
#pragma once

#include "isobench/metrics/metric.h"
#include "isobench/reports/pictures/render.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// The value of a field that one in a hundred of the mesh's values is above: single ones may be far beyond all others.
/// 0 if the mesh does not have the field.
double high_value(const FieldDeclaration& field, const TriangleMesh& mesh);

/// The mesh coloured by the field, grey if it does not have it, with the place that the run's figures mark.
/// `brightest`: the value of the brightest colour, unless the declaration says it. Keeps a pointer to the mesh.
Scene field_scene(const FieldDeclaration& field, const TriangleMesh& mesh, const RunRecord& run, double brightest);

}  // namespace isobench
