#include "isobench/methods/sizing/coarse_request.h"

#include <fmt/format.h>

#include <Eigen/Core>

namespace isobench {

std::string coarse_request(const SizingRequest& request, const TriangleMesh& mesh) {
  constexpr double far_more = 2.0;
  const auto vertices = static_cast<double>(mesh.vertices.size());
  if (mesh.vertices.empty()) return "";
  if (request.edge_length) {
    Eigen::Vector3d low = mesh.vertices.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& x : mesh.vertices) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    const double longest = (high - low).maxCoeff();
    if (*request.edge_length > longest) {
      return fmt::format(
          "the object is {:.4g} mm long, less than one edge of {:.4g} mm: the mesh has as few vertices as show its "
          "topology, {}; ask for shorter edges",
          longest, *request.edge_length, mesh.vertices.size());
    }
  }
  if (request.vertices && vertices > far_more * *request.vertices) {
    return fmt::format("{:.0f} vertices were asked for, but the topology of the surface needs more: the mesh has {}",
                       *request.vertices, mesh.vertices.size());
  }
  return "";
}

}  // namespace isobench
