// The interface of a meshing method.
//
// A method is a folder under methods/ (its name is the method's name) with a `method.cpp` that defines, for a folder
// `my-method`, `isobench::Method isobench::method_my_method()`. CMake finds the folder, compiles every .cpp in it and
// lists the function in a generated registry; no existing file is touched.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/parameters.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {

/// True if nothing is requested. Only a method with Method::ignores_sizing can mesh without a request.
inline bool is_empty(const SizingRequest& sizing) {
  return !sizing.epsilon && !sizing.delta && !sizing.edge_length && !sizing.vertices;
}

/// The task of a method: to mesh a surface with a requested sizing.
class MeshingTask {
 public:
  /// Keeps a reference to the surface.
  MeshingTask(const Isosurface& the_surface, const SizingRequest& request, Parameters values, std::uint64_t the_seed,
              std::shared_ptr<const CertifiedTopology> topology = nullptr)
      : surface(the_surface),
        sizing(request),
        parameters(std::move(values)),
        seed(the_seed),
        topology_(std::move(topology)) {}

  const Isosurface& surface;
  const SizingRequest sizing;
  const Parameters parameters;
  const std::uint64_t seed;

  /// The requested sizing field. The first call computes it, in stage "sizing" of that call's monitor: its seconds
  /// count for the method that asks. Later calls return the same field.
  std::shared_ptr<const SizingField> sizing_field(Monitor& monitor) const;
  /// Called once, when the sizing is known and before vertices are placed; may throw, to refuse what would be too much.
  std::function<void(const SizingField&)> when_sized;

  /// The proven topology of the surface. A dataset brings it along; without it, the first call proves it. Throws
  /// DataError if the isovalue is no regular value.
  const CertifiedTopology& topology(Monitor& monitor) const;

 private:
  mutable std::shared_ptr<const SizingField> field_;
  mutable std::shared_ptr<const CertifiedTopology> topology_;
};

struct Method {
  std::string name;
  std::string summary;        ///< one sentence, with the publication
  int revision = 1;           ///< raise it when results change: stored results of other revisions are not reused
  bool deterministic = true;  ///< the same seed gives the same bytes for any number of threads
  /// If determinism depends on the parameters: whether it holds with these. Otherwise null.
  bool (*deterministic_with)(const Parameters&) = nullptr;
  bool ignores_sizing = false;     ///< triangles are of the lattice's size, whatever sizing is asked for
  bool promises_manifold = false;  ///< a mesh that is no closed manifold is a failure, not a result
  // For estimates before the work, as measured on two cores; roughly in proportion to the number of vertices.
  double microseconds_per_vertex = 0.0;  ///< 0: not known
  double bytes_per_vertex = 1000.0;
  ParameterSchema parameters;
  /// Makes the mesh, in the lattice's frame. Throws Skipped, with the reason, if the method cannot do the task.
  TriangleMesh (*mesh)(const MeshingTask&, Monitor&) = nullptr;
};

/// Whether a method promises the same mesh for the same seed with these parameters.
bool is_deterministic(const Method& method, const Parameters& parameters);

/// All methods, in alphabetical order.
const std::vector<Method>& methods();
/// The method with this name. Throws UsageError, with the nearest valid name, if there is none.
const Method& method(const std::string& name, const Place& place = {});

}  // namespace isobench
