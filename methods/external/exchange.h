// What an external program gets and what it returns: files, formats and frames.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "isobench/methods/external/command_line.h"
#include "isobench/methods/method.h"

namespace isobench::external {

/// The parameters that name files in the program's working folder: three that it can get, and the one that it writes.
inline constexpr const char* file_parameters[] = {"volume", "mesh", "sizing", "output"};

/// The names of all placeholders.
std::vector<std::string> known_placeholders();

/// A value for each placeholder in `wanted`. Writes the files among them to `folder`. Computes the sizing field and the
/// marching-cubes mesh only if a placeholder needs them. Stage "hand over".
std::map<std::string, Value> hand_over(const MeshingTask& task, const std::vector<std::string>& wanted,
                                       const std::filesystem::path& folder, Monitor& monitor);

/// Reads the mesh or the points that the program wrote to `path`. Returns a mesh in the lattice frame that faces
/// outwards; points are triangulated. Stages "read" and, for points, "close". Throws DataError if the file holds
/// neither.
TriangleMesh take_back(const MeshingTask& task, const std::filesystem::path& path, Monitor& monitor);

/// How many threads this process may use.
int threads_in_use();
/// Whether the output holds bare points.
bool returns_points(const Parameters& parameters);

}  // namespace isobench::external
