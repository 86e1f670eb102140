#include "isobench/experiments/command_line/surface_arguments.h"

#include <fmt/format.h>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// What goes with a volume only, because a manifest has it, too.
void check_dataset(const SurfaceArguments& surface) {
  const auto refuse = [](bool given, const char* option, const char* why) {
    if (given) throw UsageError(fmt::format("{} goes with --volume; {}", option, why));
  };
  const char* states = "a dataset's manifest states it";
  refuse(surface.isovalue.has_value(), "--isovalue", "a dataset has its own");
  refuse(!surface.labels.empty(), "--labels", states);
  refuse(!surface.resample.empty(), "--resample", states);
  refuse(surface.smooth.has_value(), "--smooth", states);
  refuse(surface.kernel != to_string(Kernel::bspline), "--kernel", states);
  refuse(surface.part.step.has_value(), "--step", states);
  refuse(surface.part.component.has_value(), "--component", states);
  refuse(!surface.part.array.empty(), "--array", states);
  refuse(!surface.part.segment.empty(), "--segment", states);
  refuse(!surface.part.series.empty(), "--series", states);
  refuse(!surface.save_manifest.empty(), "--save-manifest", "a dataset has one");
  refuse(surface.choices.exact_isovalue, "--exact-isovalue", "a dataset's manifest states exact-isovalue = true");
}

void check_manifest(const SurfaceArguments& surface) {
  const fs::path& path = surface.save_manifest;
  if (path.extension() != ".toml")
    throw UsageError(fmt::format("--save-manifest {}: a manifest's name ends in .toml", path.string()));
  std::error_code error;
  if (fs::is_directory(surface.volume, error)) {
    throw UsageError(
        fmt::format("--save-manifest {}: a manifest names files, not folders; give --volume one of the files in {}, "
                    "which stands for "
                    "its series",
                    path.string(), surface.volume.string()));
  }
  const fs::path beside = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::path data = surface.volume.has_parent_path() ? surface.volume.parent_path() : fs::path(".");
  if (!fs::equivalent(beside, data, error)) {
    throw UsageError(fmt::format("--save-manifest {}: a manifest lies beside its data; give a path in {}",
                                 path.string(), fs::absolute(data).lexically_normal().string()));
  }
}

FileSurface asked_of(const SurfaceArguments& surface) {
  FileSurface asked;
  asked.isovalue = surface.isovalue;
  asked.inside = surface.inside == "above" ? Inside::above : Inside::below;
  asked.labels = surface.labels;
  if (surface.resample.size() == 1) asked.resample = Eigen::Vector3d::Constant(surface.resample.front());
  if (surface.resample.size() == 3) asked.resample = Eigen::Vector3d(surface.resample.data());
  asked.smooth_voxels = surface.smooth;
  for (const Kernel kernel : {Kernel::bspline, Kernel::interpolating_bspline, Kernel::catmull_rom}) {
    if (surface.kernel == to_string(kernel)) asked.kernel = kernel;
  }
  asked.border = surface.border == "close" ? Border::close : Border::refuse;
  asked.choices = surface.choices;
  asked.part = surface.part;
  return asked;
}

}  // namespace

void check(const SurfaceArguments& surface) {
  const bool dataset = !surface.dataset.empty();
  const bool volume = !surface.volume.empty();
  if (dataset == volume) throw UsageError("give either --dataset or --volume, and not both");
  if (dataset) return check_dataset(surface);
  if (!surface.isovalue && surface.labels.empty())
    throw UsageError("--volume needs --isovalue, the value of its surface, or --labels, those of the object");
  if (!surface.resample.empty() && surface.resample.size() != 1 && surface.resample.size() != 3)
    throw UsageError("--resample takes one spacing in mm, or three: X,Y,Z");
  steps_of(asked_of(surface), {});  // throws if the arguments contradict each other
  if (!surface.save_manifest.empty()) check_manifest(surface);
}

Frame frame_of(const SurfaceArguments& surface) {
  for (const Frame frame : {Frame::lps, Frame::ras, Frame::lattice}) {
    if (surface.frame == to_string(frame)) return frame;
  }
  return Frame::file;
}

Dataset load(const SurfaceArguments& surface, Monitor& monitor) {
  const Monitor::Stage stage = monitor.stage("prepare");
  if (!surface.dataset.empty()) return load_dataset(surface.dataset, monitor, {}, surface.choices.min_component);
  const FileSurface asked = asked_of(surface);
  return dataset_from_file(surface.volume, asked, monitor, surface.save_manifest);
}

}  // namespace isobench
