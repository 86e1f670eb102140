// One reader and one writer per mesh format; read_mesh() and write_mesh() choose among them.
//
// The readers are ours. Those of VTK 9.1 read damaged files without an error, take as much memory as a header states,
// and store coordinates of PLY and OBJ files in single precision. Those of CGAL return only whether a file could be
// read, not what is wrong in which line, nor what they left out. Only VTP is written by VTK.
//
// Readers throw DataError, with the file's name, if the content is not of the format or ends early. read_mesh() checks
// indices and coordinates for all formats. Writers write whole files (whole_files.h): if that fails, they throw Error,
// and an older file stays.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/mesh_files/polygon_mesh.h"

namespace isobench {

/// A VTK XML file of polygons or of an unstructured grid, whichever of both the file holds.
PolygonMesh read_vtp(const std::filesystem::path& path);
/// A legacy VTK file, the same.
PolygonMesh read_vtk(const std::filesystem::path& path);
PolygonMesh read_ply(const std::filesystem::path& path);
PolygonMesh read_off(const std::filesystem::path& path);
PolygonMesh read_obj(const std::filesystem::path& path);
PolygonMesh read_stl(const std::filesystem::path& path);

/// "SPACE=LPS": how 3D Slicer marks the axes of the coordinates in a file's comments.
inline std::string space_mark(const TriangleMesh& mesh) { return "SPACE=" + mesh.space; }

void write_vtp(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_off(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path);

/// The bytes of a file. Throws DataError if it is missing, not a file, or empty.
std::string read_bytes(const std::filesystem::path& path);
/// Throws DataError("path: message").
[[noreturn]] void bad_mesh(const std::filesystem::path& path, const std::string& message);
/// Throws DataError("path: is not <format>: <why>"), with the format that the file's first bytes show, if they do.
[[noreturn]] void not_of_format(const std::filesystem::path& path, std::string_view bytes, const std::string& format,
                                const std::string& why);

}  // namespace isobench
