// Measuring a mesh of any kind.
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
    const Measurement m = measure(mesh, small_ball(), SizingField(1.0), 1, monitor);
    for (const double figure : {m.radius_ratio.min, m.radius_ratio.avg, m.angles.min, m.angles.max, m.distance.mean,
                                m.distance.max, m.edges.over_h0_max, m.valence.v6_percent}) {
      require(std::isfinite(figure) && figure >= 0.0, "figures are finite numbers >= 0");
    }
    require(m.radius_ratio.min <= 1.0 + 1e-9 && m.angles.max <= 180.0 + 1e-9, "shapes are within their ranges");
    require(m.triangles == mesh.triangles.size() && m.vertices == mesh.vertices.size(), "all of it was measured");
    return true;
  });
}

}  // namespace isobench
