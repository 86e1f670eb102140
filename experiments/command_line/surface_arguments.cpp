#include "isobench/experiments/command_line/surface_arguments.h"

#include "isobench/foundation/error.h"

namespace isobench {

void check(const SurfaceArguments& surface) {
  const bool dataset = !surface.dataset.empty();
  const bool volume = !surface.volume.empty();
  if (dataset == volume) throw UsageError("give either --dataset or --volume, and not both");
  if (volume && !surface.isovalue) throw UsageError("--volume needs --isovalue, the value of its surface");
  if (dataset && surface.isovalue) throw UsageError("--isovalue goes with --volume; a dataset has its own");
  if (dataset && surface.choices.exact_isovalue)
    throw UsageError("--exact-isovalue goes with --volume; a dataset's manifest states exact-isovalue = true");
}

Dataset load(const SurfaceArguments& surface, Monitor& monitor) {
  const Monitor::Stage stage = monitor.stage("prepare");
  if (!surface.dataset.empty()) return load_dataset(surface.dataset, monitor, {}, surface.choices.min_component);
  const Inside inside = surface.inside == "above" ? Inside::above : Inside::below;
  return dataset_from_file(surface.volume,
                           {.isovalue = *surface.isovalue,
                            .inside = inside,
                            .smooth_voxels = surface.smooth,
                            .border = surface.border == "close" ? Border::close : Border::refuse,
                            .choices = surface.choices},
                           monitor);
}

}  // namespace isobench
