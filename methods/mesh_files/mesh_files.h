// Mesh files by the path's ending: VTP (through VTK; coordinates in double, data arrays kept), PLY, OFF, OBJ (in
// double, without data) and STL (binary, single precision).
#pragma once

#include <filesystem>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Throws UsageError for an unknown ending (naming the known ones), Error where the file cannot be written.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Writes what a monitor kept as points with their data, each into `folder` as its name with the ending .vtp, placed in
/// the world. Throws Error where a file cannot be written.
void write_artefacts(const std::map<std::string, Artefact>& artefacts, const Lattice& lattice,
                     const std::filesystem::path& folder);

/// Reads such a file back; its points stay in the world. Throws DataError for one that is missing or damaged.
Artefact read_artefact(const std::filesystem::path& path);

/// Reads a triangle mesh; STL's coincident corners are merged. Throws UsageError for an unknown ending, DataError for a
/// file that is missing, empty, truncated, foreign, has polygons other than triangles, indices out of range or
/// coordinates that are not finite.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace isobench
