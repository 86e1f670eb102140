// Reads sets of points without triangles.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace isobench::external {

/// Reads points in the frame and the order of the file. The ending of its name tells the format:
///   .nrrd, .nhdr           an array of two axes; the fast axis has 3 or more numbers per point, coordinates first
///   .xyz, .txt             text, one point per line, coordinates first
///   .ply, .off, .obj, .vtp the vertices of a mesh, with or without triangles
/// Throws DataError with the name of the file if it is missing, damaged, empty or of another format, and for
/// coordinates that are not finite.
std::vector<Eigen::Vector3d> read_points(const std::filesystem::path& path);

}  // namespace isobench::external
