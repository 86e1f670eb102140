#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/manifests/file_surface.h"
#include "isobench/datasets/manifests/settle_surface.h"
#include "isobench/datasets/preparation/components.h"
#include "isobench/datasets/preparation/needed_steps.h"
#include "isobench/datasets/topology/component_volumes.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
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

/// What the checksum covers besides the samples.
std::string arguments_text(const FileSurface& asked, double isovalue, const std::vector<PrepareStep>& steps) {
  std::string text = fmt::format("volume file {} {} {}\n", isovalue, to_string(asked.inside), to_string(asked.kernel));
  for (const PrepareStep& step : steps) text += describe(step) + "\n";
  return text;
}

/// A mask before it is smoothed.
struct Mask {
  std::size_t voxels = 0;
  double volume = 0.0;  ///< mm³
  std::size_t islands = 0;
};

Mask measure_mask(const Volume& volume) {
  Mask mask;
  volume.samples.visit([&](const auto& samples) {
    for (const auto sample : samples) mask.voxels += sample > 0 ? 1 : 0;
  });
  mask.volume = static_cast<double>(mask.voxels) * volume.lattice.spacing.prod();
  mask.islands = count_components(volume);
  return mask;
}

/// `smooth_voxels` is the standard deviation of the smoothing.
void note_smoothing(const Mask& before, const Dataset& dataset, double smooth_voxels, Monitor& monitor) {
  const CertifiedTopology& topology = *dataset.topology;
  const std::vector<double> volumes = component_volumes(*dataset.surface, topology);
  double volume = 0.0;
  std::size_t islands = 0;
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    if (topology.components[n].is_left_out) continue;
    volume += volumes[n];
    islands += volumes[n] > 0.0 ? 1 : 0;
  }
  constexpr double much = 0.05;  // of the labels' volume
  const double share = volume / before.volume - 1.0;
  const bool loses_more = (share < -much || islands < before.islands) && smooth_voxels > 0.0;
  monitor.note(
      fmt::format("the labels have {} voxels, {:.6g} mm³ in {} island{}; after smoothing, the surface encloses {:.6g} "
                  "mm³ ({:+.2f} %) in {} island{}{}",
                  before.voxels, before.volume, before.islands, before.islands == 1 ? "" : "s", volume, 100.0 * share,
                  islands, islands == 1 ? "" : "s",
                  loses_more ? fmt::format("; a --smooth below {:.3g} voxels keeps more", smooth_voxels) : ""));
}

/// Carries out the steps; those that change nothing are not named in the record.
Volume prepare_as_asked(Volume volume, const std::vector<PrepareStep>& steps, const FileSurface& asked,
                        std::optional<Mask>& mask, Dataset& dataset, Monitor& monitor) {
  for (const PrepareStep& step : steps) {
    const std::array<int, 3> size = volume.lattice.size;
    volume = prepare(std::move(volume), {step}, monitor);
    if (std::holds_alternative<SelectLabels>(step)) mask = measure_mask(volume);
    if (std::holds_alternative<CloseBorder>(step)) {
      if (volume.lattice.size == size) continue;
      if (asked.border == Border::refuse)
        throw DataError("the object reaches the volume's border; crop it, or have it closed there");
    }
    dataset.preparation.push_back(describe(step));
  }
  return volume;
}

}  // namespace

Dataset dataset_from_file(const std::filesystem::path& path, const FileSurface& asked, Monitor& monitor,
                          const std::filesystem::path& manifest) {
  steps_of(asked, {});  // throws before the file is read if it is no sensible question
  Dataset dataset;
  const std::filesystem::path named = path.has_filename() ? path : path.parent_path();  // of a folder: "scan/"
  dataset.name = named.stem().string();
  dataset.title = named.filename().string();
  dataset.source = path.string();
  VolumeFile file;
  {
    const auto stage = monitor.stage("read");
    file = read_volume(path, asked.part);
  }
  for (const std::string& note : file.notes) monitor.note(note);
  const double isovalue = asked.isovalue.value_or(0.5);
  std::vector<PrepareStep> steps = steps_of(asked, file.volume.lattice);
  if (!manifest.empty()) write_text(manifest, manifest_text(path, asked, file.volume.lattice));
  dataset.checksum = checksum_of(file.volume, arguments_text(asked, isovalue, steps));
  try {
    steps = with_needed_steps(std::move(steps), file.volume, isovalue, asked.inside == Inside::below);
    std::optional<Mask> mask;
    Volume volume = prepare_as_asked(std::move(file.volume), steps, asked, mask, dataset, monitor);
    {
      const auto stage = monitor.stage("spline");
      dataset.surface = std::make_unique<Isosurface>(std::move(volume), isovalue, asked.inside, asked.kernel);
    }
    settle_surface(dataset, asked.choices, monitor);
    if (mask) note_smoothing(*mask, dataset, asked.smooth_voxels.value_or(label_smoothing), monitor);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: {}", path.string(), error.what()));
  }
  return dataset;
}

}  // namespace isobench
