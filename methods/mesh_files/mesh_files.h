// Reads and writes mesh files; the path's ending, in capital or small letters, gives the format. VTP (coordinates in
// double, with data arrays), PLY, OFF and OBJ (coordinates in double, without data) and STL (written as binary; single
// precision) are read and written. VTK (legacy) and VTU are read.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Throws UsageError unless write_mesh() can write a file of this path: its ending must be one that is written, its
/// folder must exist, and it must not be a folder itself. Call it before the work that makes the mesh.
void check_mesh_path(const std::filesystem::path& path);

/// Throws UsageError for an unknown ending. Throws Error if the file cannot be written; an older file then stays. What
/// the format cannot hold is lost without an error: loss_in_file() of mesh_notes.h says what.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Writes the artefacts of a monitor (points with data), each to `folder`/<name>.vtp, in world coordinates. Throws
/// Error if a file cannot be written; an older file then stays.
void write_artefacts(const std::map<std::string, Artefact>& artefacts, const Lattice& lattice,
                     const std::filesystem::path& folder);

/// Reads such a file; its points stay in world coordinates. Throws DataError if it is missing or damaged.
Artefact read_artefact(const std::filesystem::path& path);

/// Reads a surface mesh. Polygons and strips are cut into triangles; points, lines and what else is no surface are left
/// out. Corners of STL files at the same position become one vertex; other formats keep their vertices. Coordinates are
/// taken as mm, triangles as they are turned. Throws UsageError for an unknown ending. Throws DataError for a file that
/// is missing, empty, truncated or of another format, or that has no triangles, cells with a volume, indices out of
/// range or coordinates that are not finite.
TriangleMesh read_mesh(const std::filesystem::path& path);
/// The same; what was cut, left out or decided becomes notes, with the file's name.
TriangleMesh read_mesh(const std::filesystem::path& path, Monitor& monitor);

/// The names of the data arrays of a VTP file that write_mesh() has written; only the beginning of the file is read.
/// Empty if there is no such file.
std::set<std::string> data_names(const std::filesystem::path& path);

}  // namespace isobench
