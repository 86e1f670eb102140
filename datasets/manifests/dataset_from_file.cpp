#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/datasets/manifests/settle_surface.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

constexpr int border_layers = 2;  // the cubic spline reaches two nodes beyond a point

template <class T>
bool border_is_inside(const std::vector<T>& samples, const Lattice& lattice, double isovalue, Inside inside) {
  const auto& size = lattice.size;
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
        const auto sample = static_cast<float>(samples[lattice.index(i, j, k)]);
        if (inside == Inside::above ? sample > isovalue : sample < isovalue) return true;
      }
    }
  }
  return false;
}

/// True if a node of the outermost layers is inside the object.
bool leaves_volume(const Volume& volume, double isovalue, Inside inside) {
  return volume.samples.visit(
      [&](const auto& samples) { return border_is_inside(samples, volume.lattice, isovalue, inside); });
}

/// Clamps the border to a value just outside the object. A tenth of the object's range of values makes the closing
/// surface steep enough for projection, and keeps the crease where it meets the object's surface shallow.
CloseBorder closing_step(const Volume& volume, double isovalue, Inside inside) {
  const Range range = sample_range(volume);
  CloseBorder step;
  step.use_minimum = false;
  step.layers = border_layers;
  step.object_below = inside == Inside::below;
  step.value = step.object_below ? isovalue + 0.1 * (isovalue - range.min) : isovalue - 0.1 * (range.max - isovalue);
  return step;
}

/// Hashes the samples as floats, from which F is made, whatever their type in the file.
void add_samples(const Samples& samples, Sha256& hash) {
  samples.visit([&](const auto& values) {
    std::vector<float> chunk;
    for (std::size_t first = 0; first < values.size(); first += chunk.size()) {
      chunk.resize(std::min<std::size_t>(values.size() - first, 65536));
      for (std::size_t n = 0; n < chunk.size(); ++n) chunk[n] = static_cast<float>(values[first + n]);
      hash.add(chunk.data(), chunk.size() * sizeof(float));
    }
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
  add_samples(volume.samples, hash);
  return hash.hex();
}

}  // namespace

Dataset dataset_from_file(const std::filesystem::path& path, const FileSurface& asked, Monitor& monitor) {
  const auto& [isovalue, inside, smooth_voxels, kernel, choices] = asked;
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
