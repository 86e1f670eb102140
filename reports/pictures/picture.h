// What a results folder has to look at beside plots: pictures of meshes, and meshes that the page turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace isobench {

/// What is drawn of a run; the names are part of those of files.
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
  std::string preview;  ///< the same as JPEG, for the page
  std::string dataset;
  std::string shot;   ///< one of the above
  bool grid = false;  ///< one of a grid of ε and δ
  std::string group;  ///< pictures that are to be looked at side by side: one camera
  std::string title;  ///< of this one within its group: the method
  std::string caption;
};

/// A mesh, or a simpler copy of it, as the page's script reads it (reports/pictures/turnable.h).
struct TurnableFile {
  std::string file;     ///< in the results folder
  std::string dataset;  ///< and
  std::string method;   ///< what it shows
  std::string run;
  bool worst_place = false;   ///< the triangles around the worst one, each as it is; else the whole mesh
  std::size_t triangles = 0;  ///< of the mesh itself
};

/// Edges of a mesh over the limited sizing field h that it was asked for, where a run kept that field.
struct EdgesOverH {
  std::string dataset;
  std::string method;
  std::vector<std::uint32_t> counts;  ///< in bins of 0.01 from 0 on; what is longer than 2 in the last
};

/// Those that are there, and sentences on what is missing and how to get it.
struct Pictures {
  std::vector<Picture> pictures;
  std::vector<TurnableFile> turnable;
  std::vector<EdgesOverH> edges_over_h;
  std::size_t across = 1;  ///< pictures in a row of a grid
  std::vector<std::string> missing;
};

}  // namespace isobench
