// For tests of methods: surfaces of phantoms and sizing requests.
#pragma once

#include <string>
#include <utility>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {

/// The surface of a phantom that is sampled on nodes³ nodes.
inline Isosurface surface_of(const std::string& name, int nodes) {
  return Isosurface(sample_phantom(phantom(name), nodes), 0.0);
}

/// A speck of less than a voxel, in 12³ nodes 1 mm apart: F of two voxels that are 1 above the others is 0.370 at them
/// and 0.426 half-way between.
inline Isosurface speck_between_nodes() {
  FloatVolume volume;
  volume.lattice.size = {12, 12, 12};
  volume.samples.assign(12 * 12 * 12, 0.0F);
  volume.at(5, 5, 5) = volume.at(6, 5, 5) = 1.0F;
  return {std::move(volume), 0.4};
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
