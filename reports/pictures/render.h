// Draws meshes with VTK, without a display.
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
  Eigen::Vector3d focus;      ///< the point in the middle of the picture
  Eigen::Vector3d towards;    ///< direction from the focus to the eye; any length
  double half_height = 1.0;   ///< half of the height that the picture shows
  double eye_distance = 1.0;  ///< from the focus to the eye; parts behind the eye are not drawn
};

/// What is drawn: a mesh and points, or one of them. Triangles are coloured by their own values or by the values of
/// their vertices, else grey. Points are coloured by their values, else dark blue.
struct Scene {
  const TriangleMesh* mesh = nullptr;   ///< nullptr: points only
  std::vector<double> values;           ///< one for each triangle, or empty
  std::string legend;                   ///< title of the colour bar; "": no bar
  bool edges = true;                    ///< draws the edges of the triangles
  std::optional<std::size_t> outlined;  ///< a triangle with a red outline
  std::vector<double> vertex_values;    ///< one for each vertex, or empty; used instead of `values`
  std::vector<Eigen::Vector3d> points;
  std::vector<double> point_values;
  std::optional<Eigen::Vector3d> marked;  ///< a place with a red point that nothing hides
  double point_size = 4.0;                ///< pixels
  double low = 0.0;                       ///< value of the darkest colour
  double high = 1.0;                      ///< value of the brightest colour
  bool logarithmic = false;               ///< colours grow with the logarithm; all values must then be positive
  const char* label_format = "%.2f";      ///< of the numbers beside the colour bar, as printf() knows it
};

/// One picture as the contents of two files: PNG without loss, and JPEG, which is a fifth as large.
struct Drawing {
  std::string png;
  std::string jpeg;
};

/// Raise it when the same scene and view give another picture, so that stored pictures are drawn again.
inline constexpr int render_revision = 2;

/// Draws into memory, without display or graphics card. A process must not have two of them at the same time.
class Renderer {
 public:
  /// Throws Error, with the remedy, if Mesa's EGL is not installed.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// A scene without mesh and points gives a white picture, with the colour bar if there is a legend.
  Drawing draw(const Scene& scene, const View& view);

 private:
  class Context;
  std::unique_ptr<Context> context_;
  int width_;
  int height_;
};

}  // namespace isobench
