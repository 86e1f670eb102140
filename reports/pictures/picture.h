// Pictures of meshes, and mesh files for the 3D view of the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace isobench {

/// What a picture of a run shows. These names are part of file names.
namespace shots {
inline constexpr const char* whole = "whole";
inline constexpr const char* closer = "closer";
inline constexpr const char* worst = "worst";
inline constexpr const char* medial_axis = "medial-axis";
inline constexpr const char* initial_sizing = "initial-sizing";
inline constexpr const char* limited_sizing = "limited-sizing";
inline constexpr const char* particles = "particles";
inline constexpr const char* particles_closer = "particles-closer";
}  // namespace shots

struct Picture {
  std::string file;     ///< in the results folder: "pictures/….png"
  std::string preview;  ///< the same picture as JPEG, for the page
  std::string dataset;
  std::string run;    ///< RunRequest::run
  std::string shot;   ///< one of `shots`
  bool grid = false;  ///< belongs to a grid of ε and δ
  std::string group;  ///< heading over the pictures that are compared; they have the same view
  std::string title;  ///< of this picture within the group: the method, or ε and δ
  std::string caption;
  /// Of a field that a metric kept with the mesh: what it is, in sentences. "" for any other picture.
  std::string explanation;
};

/// A file with a mesh, or with a simpler copy of it, for the page's script (reports/pictures/turnable.h).
struct TurnableFile {
  std::string file;  ///< in the results folder
  std::string dataset;
  std::string method;
  std::string run;
  bool worst_place = false;   ///< only the triangles around the worst one, without simplification
  std::size_t triangles = 0;  ///< of the whole mesh, not of the copy
};

/// Edge lengths of a mesh divided by the limited sizing field h, for a run that kept this field.
struct EdgesOverH {
  std::string dataset;
  std::string method;
  std::vector<std::uint32_t> counts;  ///< number of edges in bins of 0.01; the last bin has all values above 2
};

/// All that exists, and one sentence for each thing that is missing, with the remedy.
struct Pictures {
  std::vector<Picture> pictures;
  std::vector<TurnableFile> turnable;
  std::vector<EdgesOverH> edges_over_h;
  std::size_t across = 1;  ///< number of pictures in a row of the grid of ε and δ
  std::vector<std::string> missing;
};

}  // namespace isobench
