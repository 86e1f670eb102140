#include "isobench/datasets/manifests/catalogue.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/manifests/data_files.h"
#include "isobench/datasets/manifests/dataset_names.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/datasets/manifests/settle_surface.h"
#include "isobench/datasets/preparation/needed_steps.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

Manifest manifest_of(const std::string& name, const Place& place) {
  const ManifestPlace found = find_manifest(name, place);
  return read_manifest(found.path, found.manifest, found.member);
}

Volume read_data(const Manifest& manifest, const DataFiles& data, Monitor& monitor) {
  const auto stage = monitor.stage("read");
  if (manifest.raw) return read_raw(data.paths, *manifest.raw);
  VolumeFile file = read_volume(data.paths.front(), manifest.part);
  for (const std::string& note : file.notes) monitor.note(note);
  return std::move(file.volume);
}

// For example ", gap 1 mm".
std::string parameters_text(const Phantom& shape) {
  std::string text;
  for (const PhantomParameter& parameter : shape.parameters) {
    text += fmt::format(", {} {} mm", parameter.name, parameter.value);
  }
  return text;
}

Dataset load_phantom(const Manifest& manifest, const SurfaceChoices& choices, Monitor& monitor) {
  Dataset dataset;
  dataset.title = manifest.title;
  dataset.checksum = manifest_checksum(manifest, {});
  dataset.source = "phantom";
  const Phantom shape = phantom(manifest.phantom->name, manifest.phantom->parameters);
  dataset.preparation = {fmt::format("sample {} with {} nodes along its longest axis{}", shape.name,
                                     manifest.phantom->nodes, parameters_text(shape))};
  {
    const auto stage = monitor.stage("read");
    dataset.surface = std::make_unique<Isosurface>(sample_phantom(shape, manifest.phantom->nodes), 0.0, Inside::above,
                                                   manifest.kernel);
  }
  settle_surface(dataset, choices, monitor);
  return dataset;
}

Dataset load_generated(const Manifest& manifest, const SurfaceChoices& choices, Monitor& monitor) {
  Dataset dataset;
  dataset.title = manifest.title;
  dataset.checksum = manifest_checksum(manifest, {});
  dataset.source = "generated";
  dataset.preparation = {"generate " + describe(*manifest.generated)};
  {
    const auto stage = monitor.stage("read");
    GeneratedVolume generated = generate(*manifest.generated, manifest.inside, monitor);
    dataset.surface =
        std::make_unique<Isosurface>(std::move(generated.volume), generated.isovalue, manifest.inside, manifest.kernel);
  }
  settle_surface(dataset, choices, monitor);
  return dataset;
}

Dataset load_files(const Manifest& manifest, const SurfaceChoices& choices, Monitor& monitor) {
  Dataset dataset;
  dataset.title = manifest.title;
  const DataFiles data = locate_data(manifest, monitor);
  monitor.note(fmt::format("{}: read from {}", manifest.name, data.source));
  dataset.source = data.source;
  dataset.checksum = manifest_checksum(manifest, data.sums);
  try {
    Volume volume = read_data(manifest, data, monitor);
    const std::vector<PrepareStep> steps =
        with_needed_steps(manifest.steps, volume, manifest.isovalue, manifest.inside == Inside::below);
    for (const PrepareStep& step : steps) dataset.preparation.push_back(describe(step));
    volume = prepare(std::move(volume), steps, monitor);
    {
      const auto stage = monitor.stage("spline");
      dataset.surface =
          std::make_unique<Isosurface>(std::move(volume), manifest.isovalue, manifest.inside, manifest.kernel);
    }
    settle_surface(dataset, choices, monitor);
  } catch (const DataError& error) {
    throw DataError(fmt::format("dataset '{}': {}", manifest.name, error.what()));
  }
  return dataset;
}

}  // namespace

std::vector<DatasetInfo> list_datasets() {
  std::vector<DatasetInfo> list;
  for (const auto& [name, path] : manifest_paths()) {
    const std::optional<Family> family = read_family(path);
    const Manifest manifest = read_manifest(path, name, family ? std::optional(1) : std::nullopt);
    std::string source = manifest.source;
    if (manifest.phantom) {
      source = fmt::format("phantom, {} nodes along its longest axis{}", manifest.phantom->nodes,
                           parameters_text(phantom(manifest.phantom->name, manifest.phantom->parameters)));
    }
    if (manifest.generated) source = fmt::format("generated, {}", to_string(manifest.generated->generator));
    list.push_back({name, family ? family->title : manifest.title, manifest.licence, source, manifest.acknowledgement,
                    family ? members_text(*family, name) : "", manifest.name});
  }
  return list;
}

std::string dataset_checksum(const std::string& name, const Place& place) {
  const Manifest manifest = manifest_of(name, place);
  std::vector<std::string> sums;
  for (const ManifestFile& file : manifest.files) {
    sums.push_back(file.sha256.empty() ? sha256_of_file(manifest.beside / manifest.folder / file.name) : file.sha256);
  }
  return manifest_checksum(manifest, sums);
}

Dataset load_dataset(const std::string& name, Monitor& monitor, const Place& place, double min_component) {
  const Manifest manifest = manifest_of(name, place);
  // The checksum is that of the manifest as it stands, which the plan knows; a plan records its own choices.
  SurfaceChoices choices = manifest.choices;
  choices.min_component = std::max(choices.min_component, min_component);
  Dataset dataset = manifest.phantom     ? load_phantom(manifest, choices, monitor)
                    : manifest.generated ? load_generated(manifest, choices, monitor)
                                         : load_files(manifest, choices, monitor);
  dataset.name = manifest.name;
  return dataset;
}

std::string dataset_family(const std::string& name) { return manifest_of(name, {}).family; }

std::vector<std::filesystem::path> fetch_dataset(const std::string& name, Monitor& monitor) {
  const Manifest manifest = manifest_of(name, {});
  if (manifest.phantom || manifest.generated) return {};
  return locate_data(manifest, monitor).paths;
}

}  // namespace isobench
