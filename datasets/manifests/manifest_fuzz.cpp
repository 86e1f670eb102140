// Fuzz target for manifests: parses one, and applies its preparation steps to a small volume.
#include "isobench/datasets/manifests/manifest.h"
#include "isobench/datasets/preparation/prepare.h"
#include "isobench/foundation/testing/fuzz_target.h"

namespace isobench {

namespace {

FloatVolume small_volume() {
  FloatVolume volume;
  volume.lattice.size = {6, 5, 4};
  volume.lattice.spacing = {0.5, 1.0, 1.5};
  for (std::size_t n = 0; n < volume.lattice.nodes(); ++n) {
    volume.samples.push_back(static_cast<float>(n % 7) - 2.0F);
  }
  return volume;
}

/// True for steps that would make the small volume large and the run slow.
bool grows(const PrepareStep& step) {
  const auto* pad = std::get_if<Pad>(&step);
  const auto* resample = std::get_if<Resample>(&step);
  const auto* gaussian = std::get_if<Gaussian>(&step);
  return (pad != nullptr && pad->voxels > 20) || (resample != nullptr && resample->spacing.minCoeff() < 0.1) ||
         (gaussian != nullptr && gaussian->sigma.maxCoeff() > 50.0);
}

void check_prepared(const Volume& volume) {
  require(volume.samples.size() == volume.lattice.nodes() && !volume.samples.empty(), "one sample a node");
  require(volume.lattice.spacing.minCoeff() > 0.0, "spacings are positive");
}

}  // namespace

bool fuzz_manifest(std::string_view bytes) {
  return accepts([&] {
    const std::filesystem::path path = fuzz_file("manifest.toml", bytes);
    const std::optional<Family> family = read_family(path);
    const Manifest manifest =
        read_manifest(path, path.string(), family ? std::optional(family->members) : std::nullopt);
    const std::vector<std::string> sums(manifest.files.size(), std::string(64, '0'));
    require(manifest_checksum(manifest, sums).size() == 64, "a manifest has a checksum");
    Monitor monitor;
    Volume volume = small_volume();
    for (const PrepareStep& step : manifest.steps) {
      require(!describe(step).empty(), "a step can be described");
      if (grows(step) || volume.samples.size() > 100000) continue;
      volume = prepare(std::move(volume), {step}, monitor);
      check_prepared(volume);
    }
    return true;
  });
}

}  // namespace isobench
