// One reader and one writer per mesh format; read_mesh() and write_mesh() choose among them. VTK's own readers and
// writers store coordinates in single precision (PLY, OBJ) or read damaged files without an error; only VTP is written
// by VTK.
//
// Readers throw DataError, with the file's name, if the content is not of the format or ends early. read_mesh() checks
// indices and coordinates for all formats. Writers write whole files (whole_files.h): if that fails, they throw Error,
// and an older file stays.
#pragma once

#include <filesystem>
#include <string>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

TriangleMesh read_vtp(const std::filesystem::path& path);
TriangleMesh read_ply(const std::filesystem::path& path);
TriangleMesh read_off(const std::filesystem::path& path);
TriangleMesh read_obj(const std::filesystem::path& path);
TriangleMesh read_stl(const std::filesystem::path& path);

void write_vtp(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_off(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path);

/// The bytes of a file. Throws DataError if it is missing, not a file, or empty.
std::string read_bytes(const std::filesystem::path& path);
/// Throws DataError("path: message").
[[noreturn]] void bad_mesh(const std::filesystem::path& path, const std::string& message);

}  // namespace isobench
