// For tests: runs of `isobench mesh` on small volumes of every kind, with everything that a user may ask for drawn at
// random. A run is determined by its seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "isobench/datasets/manifests/file_surface.h"
#include "isobench/datasets/volume.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct RandomRun {
  std::uint64_t seed = 0;
  std::string kind;    ///< of volume: "mask", "shell" and so on
  Volume volume;       ///< 8 to 17 nodes along each axis
  std::string ending;  ///< of the file that it is written to
  FileSurface asked;
  RunRequest request;  ///< method, sizing, minimum component
};

RandomRun random_run(std::uint64_t seed);

/// One line that names the seed and what was drawn.
std::string describe(const RandomRun& run);

/// What came of a run.
struct RandomRunResult {
  std::string refusal;             ///< the sentence of a refusal; "" if there is a mesh
  std::vector<std::string> wrong;  ///< everything that must not be
  std::string figures;             ///< of the mesh
  double vertices = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads
};

/// Writes the volume to a file in `folder`, reads, meshes and measures it. A refusal with a sentence is a good end; any
/// other exception is wrong. A mesh of more than `most_vertices` is refused, so that no run takes minutes.
RandomRunResult carry_out(const RandomRun& run, double most_vertices, const std::filesystem::path& folder);

}  // namespace isobench
