// The pictures of a results folder: which ones there are, and how they are made. A separate program, isobench-pictures,
// draws them, so that no other program loads the libraries for drawing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

/// Runs whose meshes are drawn with the same views: all of a data set, or all of a grid of ε and δ. If there are
/// several seeds or repeats, the first finished run is drawn.
struct PictureGroup {
  std::string dataset;
  std::string title;
  bool grid = false;
  std::size_t across = 0;  ///< number of pictures in a row of a grid
  std::vector<const RunRecord*> runs;
  std::vector<std::string> names;      ///< title of each run within the group
  std::size_t turnable_triangles = 0;  ///< the page's copy of a mesh has at most this many
  std::string key;                     ///< changes with everything that the pictures depend on

  /// Path of a file in the results folder: the picture of a shot, or one of the files named below.
  std::string file(const RunRecord& run, const std::string& name, const char* ending = "png") const;
  static constexpr const char* turn = "turn";              ///< .mesh
  static constexpr const char* turn_worst = "turn-worst";  ///< .mesh
  static constexpr const char* over_h = "edges-over-h";    ///< .txt: EdgesOverH::counts
};

/// All groups that are drawn; they point into `results`. With many data sets (many_datasets) these are the one that the
/// page opens with and those with the worst triangle of a method. Their number and size are limited; `left_out` gets
/// one sentence for each data set whose meshes are not all drawn.
std::vector<PictureGroup> picture_groups(const Results& results, std::vector<std::string>& left_out);

/// The shots that are drawn of a run. A run that kept its artefacts has more of them.
std::vector<std::string> shots_of(const PictureGroup& group, const RunRecord& run, const std::filesystem::path& folder);
/// The files that drawing a run makes.
std::vector<std::string> files_of(const PictureGroup& group, const RunRecord& run, const std::filesystem::path& folder);

/// Draws the pictures that are missing in <folder>/pictures from the stored meshes, and removes files that belong to
/// none of these. Cost: about half a second for each picture of a mesh with 100,000 triangles.
Pictures make_pictures(const Results& results, const std::filesystem::path& folder);

}  // namespace isobench
