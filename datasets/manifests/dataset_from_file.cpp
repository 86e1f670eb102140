#include <fmt/format.h>

#include <cmath>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

constexpr int border_layers = 2;  // as many as the cubic spline reaches beyond a node

/// True if a node of the outermost layers is inside the object.
bool leaves_volume(const Volume& volume, double isovalue, Inside inside) {
  const auto& size = volume.lattice.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const std::array<int, 3> node{i, j, k};
        bool border = false;
        for (std::size_t a = 0; a < 3; ++a)
          border = border || node[a] < border_layers || node[a] >= size[a] - border_layers;
        if (!border) {
          i = std::max(i, size[0] - border_layers - 1);  // on to the far border of the row
          continue;
        }
        const float sample = volume.at(i, j, k);
        if (inside == Inside::above ? sample > isovalue : sample < isovalue) return true;
      }
    }
  }
  return false;
}

/// Clamps the border just outside the isovalue. A tenth of the object's own range keeps the closing surface steep
/// enough to be projected on, and near enough not to make a deep crease.
CloseBorder closing_step(const Volume& volume, double isovalue, Inside inside) {
  const Range range = sample_range(volume);
  CloseBorder step;
  step.use_minimum = false;
  step.layers = border_layers;
  step.object_below = inside == Inside::below;
  step.value = step.object_below ? isovalue + 0.1 * (isovalue - range.min) : isovalue - 0.1 * (range.max - isovalue);
  return step;
}

std::string checksum_of(const Volume& volume, const std::string& arguments) {
  Sha256 hash;
  hash.add(arguments);
  const Lattice& lattice = volume.lattice;
  hash.add(lattice.size.data(), sizeof(lattice.size));
  hash.add(lattice.spacing.data(), 3 * sizeof(double));
  hash.add(lattice.origin.data(), 3 * sizeof(double));
  hash.add(lattice.direction.data(), 9 * sizeof(double));
  hash.add(volume.samples.data(), volume.samples.size() * sizeof(float));
  return hash.hex();
}

}  // namespace

Dataset dataset_from_file(const std::filesystem::path& path, double isovalue, Inside inside, double smooth_voxels,
                          Kernel kernel, Monitor& monitor) {
  if (!std::isfinite(isovalue)) throw UsageError("the isovalue must be a finite number");
  if (!(smooth_voxels >= 0.0 && smooth_voxels < 1000.0)) {
    throw UsageError(
        fmt::format("smoothing by {} voxels is not possible; give a number from 0 to 1000", smooth_voxels));
  }
  Dataset dataset;
  dataset.name = path.stem().string();
  dataset.title = path.filename().string();
  dataset.source = path.string();
  Volume volume;
  {
    const auto stage = monitor.stage("read");
    volume = read_volume(path);
  }
  dataset.checksum = checksum_of(
      volume, fmt::format("volume file {} {} {} {}\n", isovalue, to_string(inside), smooth_voxels, to_string(kernel)));
  try {
    std::vector<PrepareStep> steps;
    if (smooth_voxels > 0.0) steps.emplace_back(Gaussian{Eigen::Vector3d::Constant(smooth_voxels)});
    volume = prepare(std::move(volume), steps, monitor);
    if (leaves_volume(volume, isovalue, inside)) {
      steps.emplace_back(closing_step(volume, isovalue, inside));
      volume = prepare(std::move(volume), {steps.back()}, monitor);
      monitor.note(fmt::format("{}: the object leaves the volume and was closed at its border", dataset.title));
    }
    for (const PrepareStep& step : steps) dataset.preparation.push_back(describe(step));
    const auto stage = monitor.stage("spline");
    dataset.surface = std::make_unique<Isosurface>(std::move(volume), isovalue, inside, kernel);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: {}", path.string(), error.what()));
  }
  return dataset;
}

}  // namespace isobench
