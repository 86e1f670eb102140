// For tests: what a method promises of every mesh, and what of it a mesh does not keep.
#pragma once

#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/measurement.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// Whether the method meshes everything that is not refused before it begins. Others may fail, with a sentence.
bool promises_mesh(const RunRequest& request);

/// One entry for each broken promise, with the figures; empty if the mesh is as its method promises.
std::vector<std::string> broken_promises(const RunRequest& request, const TriangleMesh& mesh,
                                         const Measurement& measurement);

/// The figures that promises are about, in one line.
std::string figures_text(const Measurement& measurement);

}  // namespace isobench
