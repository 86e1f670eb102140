// One reader and one writer a mesh format; read_mesh() and write_mesh() choose among them. All but VTP are our own
// because VTK's keep coordinates in single precision (PLY, OBJ) or read damaged files without complaint.
//
// Readers throw DataError, naming the file, where the text or bytes are not of the format or end early; whether indices
// and coordinates make sense is checked by read_mesh() for all of them. Writers throw Error.
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

/// The bytes of a file; DataError if it is missing, no file, or empty.
std::string read_bytes(const std::filesystem::path& path);
/// Error if the file cannot be written to the end.
void write_bytes(const std::string& bytes, const std::filesystem::path& path);
/// DataError: "path: message".
[[noreturn]] void bad_mesh(const std::filesystem::path& path, const std::string& message);

}  // namespace isobench
