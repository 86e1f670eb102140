// What goes to an external program and what comes back: files, formats and frames.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "isobench/methods/external/command_line.h"
#include "isobench/methods/method.h"

namespace isobench::external {

/// Names of the files that a program can be given and of the one that it gives, in the folder that it works in.
inline constexpr const char* file_parameters[] = {"volume", "mesh", "sizing", "output"};

/// Every name that a placeholder may have.
std::vector<std::string> known_placeholders();

/// Writes the files that are named among `wanted` into `folder` and gives a value for each placeholder of `wanted`; the
/// sizing field and the marching-cubes mesh are made where one of these asks for it, and not otherwise. Stage "hand
/// over".
std::map<std::string, Value> hand_over(const MeshingTask& task, const std::vector<std::string>& wanted,
                                       const std::filesystem::path& folder, Monitor& monitor);

/// The mesh that a program left in `path`, in the lattice frame and facing outwards; points are closed to one. Stages
/// "read" and, for points, "close". Throws DataError for a file that is no such mesh or set of points.
TriangleMesh take_back(const MeshingTask& task, const std::filesystem::path& path, Monitor& monitor);

/// How many threads this process may use.
int threads_in_use();
/// Whether the output holds bare points.
bool returns_points(const Parameters& parameters);

}  // namespace isobench::external
