#include "metrics/reference_topology.h"

#include <fmt/format.h>

#include "datasets/error.h"
#include "metrics/kuhn_topology.h"
#include "metrics/sign_lattice.h"

namespace isobench {

ReferenceTopology reference_topology(const Isosurface& surface, int k, Monitor& monitor) {
  if (k < 1) throw UsageError(fmt::format("reference_k is {}; it must be a whole number of at least 1", k));
  const SignLattice signs = refined_signs(surface, k, monitor);
  ReferenceTopology topology;
  topology.k = k;
  topology.euler = kuhn_euler(signs, monitor);
  topology.components = kuhn_components(signs, monitor);
  return topology;
}

}  // namespace isobench
