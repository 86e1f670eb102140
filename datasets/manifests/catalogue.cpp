#include "isobench/datasets/manifests/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "isobench/datasets/manifests/data_files.h"
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/datasets/manifests/settle_surface.h"
#include "isobench/foundation/sha256.h"

namespace isobench {

namespace {

bool is_path(const std::string& name) { return name.ends_with(".toml"); }

/// The names of the catalogue and their manifests. A manifest in ISOBENCH_CATALOGUE hides one of the same name.
std::map<std::string, std::filesystem::path> manifest_paths() {
  std::vector<std::filesystem::path> folders;
  if (const char* own = std::getenv("ISOBENCH_CATALOGUE"); own != nullptr && *own != '\0') {
    std::error_code error;
    if (!std::filesystem::is_directory(own, error)) {
      throw UsageError(fmt::format("ISOBENCH_CATALOGUE names {}, which is not a folder; correct or unset it", own));
    }
    folders.emplace_back(own);
  }
  folders.emplace_back(ISOBENCH_CATALOGUE_DIR);
  std::map<std::string, std::filesystem::path> paths;
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".toml") paths.emplace(entry.path().stem().string(), entry.path());
    }
  }
  if (paths.empty()) {
    throw UsageError(
        fmt::format("{} has no manifests; set ISOBENCH_CATALOGUE to the folder datasets/catalogue of the source code",
                    folders.back().string()));
  }
  return paths;
}

Manifest find_manifest(const std::string& name, const Place& place) {
  if (is_path(name)) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(name, error)) {
      throw UsageError(place, fmt::format("no dataset manifest at '{}'; give the path of an existing one", name));
    }
    return read_manifest(name, name);
  }
  const auto paths = manifest_paths();
  const auto found = paths.find(name);
  if (found == paths.end()) {
    throw UsageError(place, fmt::format("unknown dataset '{}'{}", name, suggestion(name, dataset_names())));
  }
  return read_manifest(found->second, name);
}

Volume read_data(const Manifest& manifest, const DataFiles& data, Monitor& monitor) {
  const auto stage = monitor.stage("read");
  return manifest.raw ? read_raw(data.paths, *manifest.raw) : read_volume(data.paths.front());
}

// For example ", gap 1 mm".
std::string parameters_text(const Phantom& shape) {
  std::string text;
  for (const PhantomParameter& parameter : shape.parameters) {
    text += fmt::format(", {} {} mm", parameter.name, parameter.value);
  }
  return text;
}

Dataset load_phantom(const Manifest& manifest, Monitor& monitor) {
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
  settle_surface(dataset, manifest.choices, monitor);
  return dataset;
}

Dataset load_files(const Manifest& manifest, Monitor& monitor) {
  Dataset dataset;
  dataset.title = manifest.title;
  const DataFiles data = locate_data(manifest, monitor);
  monitor.note(fmt::format("{}: read from {}", manifest.name, data.source));
  dataset.source = data.source;
  dataset.checksum = manifest_checksum(manifest, data.sums);
  for (const PrepareStep& step : manifest.steps) dataset.preparation.push_back(describe(step));
  try {
    Volume volume = prepare(read_data(manifest, data, monitor), manifest.steps, monitor);
    {
      const auto stage = monitor.stage("spline");
      dataset.surface =
          std::make_unique<Isosurface>(std::move(volume), manifest.isovalue, manifest.inside, manifest.kernel);
    }
    settle_surface(dataset, manifest.choices, monitor);
  } catch (const DataError& error) {
    throw DataError(fmt::format("dataset '{}': {}", manifest.name, error.what()));
  }
  return dataset;
}

}  // namespace

std::vector<DatasetInfo> list_datasets() {
  std::vector<DatasetInfo> list;
  for (const auto& [name, path] : manifest_paths()) {
    const Manifest manifest = read_manifest(path, name);
    std::string source = manifest.source;
    if (manifest.phantom) {
      source = fmt::format("phantom, {} nodes along its longest axis{}", manifest.phantom->nodes,
                           parameters_text(phantom(manifest.phantom->name, manifest.phantom->parameters)));
    }
    list.push_back({name, manifest.title, manifest.licence, source, manifest.acknowledgement});
  }
  return list;
}

std::vector<std::string> dataset_names() {
  std::vector<std::string> names;
  for (const auto& entry : manifest_paths()) names.push_back(entry.first);
  return names;
}

std::string dataset_checksum(const std::string& name, const Place& place) {
  const Manifest manifest = find_manifest(name, place);
  std::vector<std::string> sums;
  for (const ManifestFile& file : manifest.files) {
    sums.push_back(file.sha256.empty() ? sha256_of_file(manifest.beside / manifest.folder / file.name) : file.sha256);
  }
  return manifest_checksum(manifest, sums);
}

Dataset load_dataset(const std::string& name, Monitor& monitor, const Place& place, double min_component) {
  Manifest manifest = find_manifest(name, place);
  manifest.choices.min_component = std::max(manifest.choices.min_component, min_component);
  Dataset dataset = manifest.phantom ? load_phantom(manifest, monitor) : load_files(manifest, monitor);
  dataset.name = manifest.name;
  return dataset;
}

std::vector<std::filesystem::path> fetch_dataset(const std::string& name, Monitor& monitor) {
  const Manifest manifest = find_manifest(name, {});
  if (manifest.phantom) return {};
  return locate_data(manifest, monitor).paths;
}

}  // namespace isobench
