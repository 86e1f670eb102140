#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/datasets/manifests/settle_surface.h"
#include "isobench/datasets/preparation/needed_steps.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

template <class Hashed, class T>
void add_as(const std::vector<T>& values, Sha256& hash) {
  std::vector<Hashed> chunk;
  for (std::size_t first = 0; first < values.size(); first += chunk.size()) {
    chunk.resize(std::min<std::size_t>(values.size() - first, 65536));
    for (std::size_t n = 0; n < chunk.size(); ++n) chunk[n] = static_cast<Hashed>(values[first + n]);
    hash.add(chunk.data(), chunk.size() * sizeof(Hashed));
  }
}

/// Hashes the samples as floats, whatever their type in the file, where floats hold them all.
void add_samples(const Volume& volume, Sha256& hash) {
  volume.samples.visit([&](const auto& values) {
    if (needs_double(volume))
      add_as<SampleOf<decltype(values)>>(values, hash);
    else
      add_as<float>(values, hash);
  });
}

std::string checksum_of(const Volume& volume, const std::string& arguments) {
  Sha256 hash;
  hash.add(arguments);
  const Lattice& lattice = volume.lattice;
  hash.add(lattice.size.data(), sizeof(lattice.size));
  hash.add(lattice.spacing.data(), 3 * sizeof(double));
  hash.add(lattice.origin.data(), 3 * sizeof(double));
  hash.add(lattice.direction.data(), 9 * sizeof(double));
  add_samples(volume, hash);
  return hash.hex();
}

}  // namespace

Dataset dataset_from_file(const std::filesystem::path& path, const FileSurface& asked, Monitor& monitor) {
  const auto& [isovalue, inside, smooth_voxels, kernel, border, choices, part] = asked;
  if (!std::isfinite(isovalue)) throw UsageError("the isovalue is not a finite number; give one that is");
  if (!(smooth_voxels >= 0.0 && smooth_voxels < 1000.0)) {
    throw UsageError(
        fmt::format("smoothing by {} voxels is not possible; give a number >= 0 and < 1000", smooth_voxels));
  }
  Dataset dataset;
  dataset.name = path.stem().string();
  dataset.title = path.filename().string();
  dataset.source = path.string();
  Volume volume;
  {
    const auto stage = monitor.stage("read");
    VolumeFile file = read_volume(path, part);
    for (const std::string& note : file.notes) monitor.note(note);
    volume = std::move(file.volume);
  }
  dataset.checksum = checksum_of(
      volume, fmt::format("volume file {} {} {} {}\n", isovalue, to_string(inside), smooth_voxels, to_string(kernel)));
  try {
    const bool object_below = inside == Inside::below;
    std::vector<PrepareStep> steps;
    if (smooth_voxels > 0.0) steps.emplace_back(Gaussian{Eigen::Vector3d::Constant(smooth_voxels)});
    steps = with_needed_steps(std::move(steps), volume, isovalue, object_below);
    volume = prepare(std::move(volume), steps, monitor);
    const std::array<int, 3> size = volume.lattice.size;
    volume = prepare(std::move(volume), {CloseBorder{isovalue, object_below}}, monitor);
    if (volume.lattice.size != size) {
      if (border == Border::refuse)
        throw DataError("the object reaches the volume's border; crop it, or have it closed there");
      steps.emplace_back(CloseBorder{isovalue, object_below});
    }
    for (const PrepareStep& step : steps) dataset.preparation.push_back(describe(step));
    {
      const auto stage = monitor.stage("spline");
      dataset.surface = std::make_unique<Isosurface>(std::move(volume), isovalue, inside, kernel);
    }
    settle_surface(dataset, choices, monitor);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: {}", path.string(), error.what()));
  }
  return dataset;
}

}  // namespace isobench
