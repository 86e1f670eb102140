// For tests of methods: surfaces of phantoms and sizing requests.
#pragma once

#include <string>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {

/// The surface of a phantom that is sampled on nodes³ nodes.
inline Isosurface surface_of(const std::string& name, int nodes) {
  return Isosurface(sample_phantom(phantom(name), nodes), 0.0);
}

inline SizingRequest adaptive(double epsilon, double delta) {
  SizingRequest request;
  request.epsilon = epsilon;
  request.delta = delta;
  return request;
}

/// Edges of one length, mm.
inline SizingRequest uniform(double edge_length) {
  SizingRequest request;
  request.edge_length = edge_length;
  return request;
}

/// Edges of the one length that gives about this number of vertices.
inline SizingRequest with_vertices(double count) {
  SizingRequest request;
  request.vertices = count;
  return request;
}

}  // namespace isobench
