// What has changed in a mesh, and where triangles that have changed intersect others.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/mesh_edits/editable_mesh.h"

namespace isobench::particles {

/// The vertices of a mesh that are new, or not where they were.
std::vector<EditableMesh::Index> moved_vertices(const EditableMesh& before, const EditableMesh& after);

/// Marks the triangles of after.triangle_mesh() that are new or have a corner that moved.
std::vector<std::uint8_t> changed_triangles(const EditableMesh& before, const EditableMesh& after);

/// The points near an intersecting triangle of a mesh: within 2^`doublings` of its longest edges of its bounding box.
/// In ascending order, for all intersecting triangles.
std::set<std::uint32_t> points_near(const std::vector<Eigen::Vector3d>& points, const TriangleMesh& mesh,
                                    const std::vector<std::array<std::uint32_t, 2>>& intersections, int doublings);

}  // namespace isobench::particles
