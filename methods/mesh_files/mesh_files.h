// Reads and writes mesh files; the path's ending gives the format: VTP (coordinates in double, with data arrays), PLY,
// OFF and OBJ (coordinates in double, without data), STL (written as binary; single precision).
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Throws UsageError for an unknown ending. Throws Error if the file cannot be written; an older file then stays.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Writes the artefacts of a monitor (points with data), each to `folder`/<name>.vtp, in world coordinates. Throws
/// Error if a file cannot be written; an older file then stays.
void write_artefacts(const std::map<std::string, Artefact>& artefacts, const Lattice& lattice,
                     const std::filesystem::path& folder);

/// Reads such a file; its points stay in world coordinates. Throws DataError if it is missing or damaged.
Artefact read_artefact(const std::filesystem::path& path);

/// Reads a triangle mesh; corners of STL files at the same position become one vertex. Throws UsageError for an unknown
/// ending. Throws DataError for a file that is missing, empty, truncated or of another format, or that has polygons
/// other than triangles, indices out of range or coordinates that are not finite.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// The names of the data arrays of a VTP file that write_mesh() has written; only the beginning of the file is read.
/// Empty if there is no such file.
std::set<std::string> data_names(const std::filesystem::path& path);

}  // namespace isobench
