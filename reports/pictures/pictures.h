// The pictures of a results folder: which there are, and how they come to be there. They are drawn by a program of its
// own, isobench-pictures, which alone loads the libraries for that.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/pictures/picture.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

/// Runs whose meshes are seen by one camera: those of a dataset, or those of a grid of ε and δ. Of several seeds or
/// repeats the first finished run is drawn.
struct PictureGroup {
  std::string dataset;
  std::string title;
  bool grid = false;
  std::size_t across = 0;  ///< of a grid: how many stand in a row
  std::vector<const RunRecord*> runs;
  std::vector<std::string> names;      ///< of each run within the group
  std::size_t turnable_triangles = 0;  ///< the most that the page's copy of a mesh has
  std::string key;                     ///< of all that pictures depend on

  /// Path of a file of a run in the results folder: a shot's, or another's of these names.
  std::string file(const RunRecord& run, const std::string& name, const char* ending = "png") const;
  static constexpr const char* turn = "turn";              ///< .mesh
  static constexpr const char* turn_worst = "turn-worst";  ///< .mesh
  static constexpr const char* over_h = "edges-over-h";    ///< .txt: EdgesOverH::counts
};

/// Points into `results`. As many groups and meshes as somebody looks at; `left_out` gets a sentence on what is not.
std::vector<PictureGroup> picture_groups(const Results& results, std::vector<std::string>& left_out);

/// What is drawn of a run: of one that kept its artefacts more than of others.
std::vector<std::string> shots_of(const PictureGroup& group, const RunRecord& run, const std::filesystem::path& folder);
/// All files of a run; none is written unless the run is drawn.
std::vector<std::string> files_of(const PictureGroup& group, const RunRecord& run, const std::filesystem::path& folder);

/// Has drawn into <folder>/pictures what is not there yet, from the stored meshes, and removes what is of no mesh of
/// these any more. Cost: about half a second a mesh of 100,000 triangles and picture.
Pictures make_pictures(const Results& results, const std::filesystem::path& folder);

}  // namespace isobench
