// What a mesh will cost, before the work starts.
#pragma once

#include <optional>
#include <string>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/method.h"

namespace isobench {

struct Estimate {
  double vertices = 0.0;
  std::optional<double> seconds;  ///< on two cores; not known for every method
  double bytes = 0.0;             ///< of memory, in addition to what the program has taken so far
};

/// The number of vertices is that of equilateral triangles with the sizing's edges on the surface, whose area is known
/// to some 10 % from the boxes of its proof. Precondition: the method follows the sizing. Cost: one value of the field
/// for each of these boxes.
Estimate estimate(const MeshingTask& task, const Method& method, const SizingField& field, Monitor& monitor);

/// For example "about 49,000 vertices, 4 s on two cores, 90 MB".
std::string to_string(const Estimate& estimate);

/// Throws UsageError, with what may be done, if the mesh would have more vertices than `most` or need more memory than
/// there is (available_memory.h).
void refuse_if_too_large(const Estimate& estimate, const MeshingTask& task, std::optional<double> most);

}  // namespace isobench
