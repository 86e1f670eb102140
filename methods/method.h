// The one interface that every meshing method has.
//
// A method is a folder under methods/ (its name is the method's name) with a `method.cpp` that defines, for a folder
// `my-method`, `isobench::Method isobench::method_my_method()`. CMake finds the folder, compiles every .cpp in it and
// lists the function in a generated registry; no existing file is touched.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/parameters.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {

/// Whether nothing is asked for. Only a method with Method::ignores_sizing can mesh so.
inline bool is_empty(const SizingRequest& sizing) {
  return !sizing.epsilon && !sizing.delta && !sizing.edge_length && !sizing.vertices;
}

/// What every method is asked: mesh this surface, at this sizing.
class MeshingTask {
 public:
  /// Keeps a reference to the surface.
  MeshingTask(const Isosurface& the_surface, const SizingRequest& request, Parameters values, std::uint64_t the_seed)
      : surface(the_surface), sizing(request), parameters(std::move(values)), seed(the_seed) {}

  const Isosurface& surface;
  const SizingRequest sizing;
  const Parameters parameters;
  const std::uint64_t seed;

  /// The sizing field of the request, computed at the first call (stage "sizing" of that call's monitor: that is how
  /// its seconds are booked to the method that asked) and kept.
  std::shared_ptr<const SizingField> sizing_field(Monitor& monitor) const;

 private:
  mutable std::shared_ptr<const SizingField> field_;
};

struct Method {
  std::string name;
  std::string summary;  ///< one sentence, with its source
  int revision = 1;  ///< raise it when the method's results change: stored results of another revision are not reused
  bool deterministic = true;  ///< same seed, same bytes, for any number of threads
  /// Where that hangs on the parameters, whether it holds with these; else null.
  bool (*deterministic_with)(const Parameters&) = nullptr;
  bool ignores_sizing = false;  ///< triangles are of the lattice's size, whatever sizing is asked for
  ParameterSchema parameters;
  /// The mesh in the lattice frame of the surface. Throws Skipped with the reason where the method cannot do the task.
  TriangleMesh (*mesh)(const MeshingTask&, Monitor&) = nullptr;
};

/// Whether a method promises the same mesh for the same seed, with these parameters of its schema.
bool is_deterministic(const Method& method, const Parameters& parameters);

/// All methods, in order of name.
const std::vector<Method>& methods();
/// Throws UsageError with the nearest valid name.
const Method& method(const std::string& name, const Place& place = {});

}  // namespace isobench
