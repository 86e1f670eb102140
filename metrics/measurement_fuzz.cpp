// Fuzz target: measures any triangle soup.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "isobench/foundation/testing/fuzz_target.h"
#include "isobench/metrics/measurement.h"

namespace isobench {

namespace {

const Isosurface& small_ball() {
  static const Isosurface ball = [] {
    FloatVolume volume;
    volume.lattice.size = {9, 9, 9};
    for (int k = 0; k < 9; ++k) {
      for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 9; ++i) {
          volume.samples.push_back(static_cast<float>(3.0 - std::hypot(i - 4.0, j - 4.0, k - 4.0)));
        }
      }
    }
    return Isosurface(std::move(volume), 0.0);
  }();
  return ball;
}

/// The number of vertices in a byte, their coordinates in doubles, then a byte for each corner.
TriangleMesh mesh_of(std::string_view bytes) {
  TriangleMesh mesh;
  if (bytes.empty()) return mesh;
  const std::size_t count = static_cast<unsigned char>(bytes[0]) % 64;
  bytes.remove_prefix(1);
  for (std::size_t v = 0; v < count && bytes.size() >= 3 * sizeof(double); ++v) {
    std::memcpy(mesh.vertices.emplace_back().data(), bytes.data(), 3 * sizeof(double));
    bytes.remove_prefix(3 * sizeof(double));
  }
  for (; bytes.size() >= 3 && mesh.triangles.size() < 200; bytes.remove_prefix(3)) {
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) triangle[c] = static_cast<unsigned char>(bytes[c]);
  }
  return mesh;
}

}  // namespace

bool fuzz_measure(std::string_view bytes) {
  return accepts([&] {
    TriangleMesh mesh = mesh_of(bytes);
    Monitor monitor;
    const Measurement m = measure(mesh, small_ball(), SizingField(1.0), monitor);
    // Whatever was measured is a finite number, by the definition of Measurement.
    for (const char* name :
         {"radius_ratio_min", "radius_ratio_avg", "angle_min", "angle_max", "distance_unprojected", "area"})
      require(m.figure(name).has_value() && m.number(name) >= 0.0, "shapes are numbers >= 0");
    for (const char* name : {"distance_mean", "distance_max", "edge_over_h0_max", "valence_6_percent"})
      require(m.figure(name).value_or(0.0) >= 0.0, "figures are >= 0");
    require(m.number("radius_ratio_min") <= 1.0 + 1e-9 && m.number("angle_max") <= 180.0 + 1e-9,
            "shapes are within their ranges");
    require(m.number("triangles") == static_cast<double>(mesh.triangles.size()) &&
                m.number("vertices") == static_cast<double>(mesh.vertices.size()),
            "all of it was measured");
    return true;
  });
}

}  // namespace isobench
