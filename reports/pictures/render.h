// Meshes drawn by VTK without a display.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// A parallel projection, mm.
struct View {
  Eigen::Vector3d focus;      ///< the middle of the picture
  Eigen::Vector3d towards;    ///< from there to the eye; any length
  double half_height = 1.0;   ///< of what the picture shows
  double eye_distance = 1.0;  ///< what is nearer to the eye's side than this is not seen
};

/// What is drawn: triangles in the colours of their values or of their corners', grey where they have none, with edges
/// where asked for, one triangle outlined; and points, dark where they have no values.
struct Scene {
  const TriangleMesh* mesh = nullptr;  ///< none: points alone
  std::vector<double> values;          ///< one a triangle
  std::string legend;                  ///< of the colours, for their bar; "": no bar
  bool edges = true;
  std::optional<std::size_t> outlined;
  std::vector<double> vertex_values;  ///< one a vertex, in the place of the triangles' own
  std::vector<Eigen::Vector3d> points;
  std::vector<double> point_values;
  double point_size = 4.0;  ///< pixels
  double low = 0.0;         ///< what the darkest colour means, and
  double high = 1.0;        ///< the brightest
};

/// One picture as two files: PNG without a loss, and JPEG, which takes a fifth of the room.
struct Drawing {
  std::string png;
  std::string jpeg;
};

/// Raised when the same scene and view come out as another picture.
inline constexpr int render_revision = 2;

/// Draws into memory, with the processor alone: no display, no graphics card. One at a time in a process.
class Renderer {
 public:
  /// Throws Error, with the remedy, where Mesa's EGL is not installed.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// A view with nothing in it is white with the bar.
  Drawing draw(const Scene& scene, const View& view);

 private:
  class Context;
  std::unique_ptr<Context> context_;
  int width_;
  int height_;
};

}  // namespace isobench
