// A bare set of points from a file.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace isobench::external {

/// Reads points, in the file's own frame and order: from NRRD (.nrrd, .nhdr: 3 or more numbers a point, the first three
/// its place, along the fast axis of two), text (.xyz, .txt: a line a point, its first three numbers the place), or the
/// vertices of a mesh file, with or without triangles (.ply, .off, .obj, .vtp). Throws DataError, naming the file, for
/// one that is missing, damaged, empty or not of these, and for coordinates that are not finite.
std::vector<Eigen::Vector3d> read_points(const std::filesystem::path& path);

}  // namespace isobench::external
