#include "isobench/experiments/random_runs/random_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "isobench/datasets/formats/write_volume.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/random_runs/mesh_promises.h"
#include "isobench/experiments/random_runs/random_volume.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/methods/method.h"

namespace isobench {

namespace {

// `particles` has the most promises to keep, `cvt` shares its cure; the other methods get an equal share each.
const Method& random_method(RandomNumbers& random) {
  if (random.chance(0.35)) return method("particles");
  if (random.chance(0.2)) return method("cvt");
  std::vector<const Method*> others;
  for (const Method& other : methods()) {
    const bool is_complete = std::none_of(other.parameters.begin(), other.parameters.end(),
                                          [](const ParameterSpec& parameter) { return parameter.required; });
    if (is_complete && other.name != "particles" && other.name != "cvt") others.push_back(&other);
  }
  return *others[static_cast<std::size_t>(random.below(static_cast<int>(others.size())))];
}

// Edges from a part of a voxel to several, so that some meshes are finer than the features and some coarser.
SizingRequest random_sizing(const Lattice& lattice, bool uniform, RandomNumbers& random) {
  SizingRequest sizing;
  if (!uniform && random.chance(0.6)) {
    sizing.epsilon = random.chance(0.5) ? 0.5 : random.between(0.4, 1.0);
    sizing.delta = random.chance(0.5) ? 0.3 : random.between(0.1, 0.6);
  } else if (random.chance(0.9)) {
    sizing.edge_length = lattice.voxel() * random.between(0.7, 3.0);
  } else {
    sizing.vertices = random.between(50.0, 5000.0);
  }
  return sizing;
}

FileSurface random_surface(const RandomVolume& volume, RandomNumbers& random) {
  FileSurface asked;
  asked.isovalue = volume.isovalue;
  asked.inside = random.chance(0.5) ? Inside::above : Inside::below;
  if (random.chance(0.1)) asked.smooth_voxels = random.between(0.3, 1.5);
  if (random.chance(0.1)) asked.kernel = Kernel::interpolating_bspline;
  if (random.chance(0.1)) asked.kernel = Kernel::catmull_rom;
  asked.choices.exact_isovalue = random.chance(0.05);
  if (random.chance(0.2)) {
    asked.choices.min_component = random.between(0.0, 20.0) * volume.volume.lattice.spacing.prod();
  }
  return asked;
}

// With the Catmull-Rom spline, the derivatives of F are not those of its values, and no mesh can follow both.
bool keeps_promises(const RandomRun& run) { return run.asked.kernel != Kernel::catmull_rom; }

void mesh_and_judge(const RandomRun& run, double most_vertices, const std::filesystem::path& file,
                    RandomRunResult& result) {
  Monitor monitor;
  const Dataset dataset = dataset_from_file(file, run.asked, monitor);
  RunRecord record;
  const TriangleMesh mesh = mesh_and_measure(dataset, run.request, monitor, record, {.most_vertices = most_vertices});
  result.vertices = static_cast<double>(mesh.vertices.size());
  result.figures = figures_text(*record.measurement);
  if (keeps_promises(run)) result.wrong = broken_promises(run.request, mesh, *record.measurement);
}

}  // namespace

RandomRun random_run(std::uint64_t seed) {
  RandomNumbers random(seed);
  RandomRun run;
  run.seed = seed;
  RandomVolume volume = random_volume(random);
  run.asked = random_surface(volume, random);
  run.kind = volume.kind;
  run.ending = random.chance(0.8) ? ".nrrd" : ".vti";
  const Method& chosen = random_method(random);
  run.request.method = chosen.name;
  run.request.method_revision = chosen.revision;
  run.request.parameters = Parameters(chosen.parameters).all();
  run.request.seed = seed;
  const bool uniform = chosen.name == "isotropic-remeshing";  // which skips every other sizing
  run.request.sizing = random_sizing(volume.volume.lattice, uniform, random);
  run.volume = std::move(volume.volume);
  return run;
}

std::string describe(const RandomRun& run) {
  const auto& [width, height, depth] = run.volume.lattice.size;
  const Eigen::Vector3d& spacing = run.volume.lattice.spacing;
  const FileSurface& asked = run.asked;
  return fmt::format(
      "random run {}: {}, {} × {} × {} {} at {:.3g} × {:.3g} × {:.3g} mm, {} {}{}, smooth {:.2g}, {}, components from "
      "{:.2g} mm³, {} {}",
      run.seed, run.kind, width, height, depth, to_string(run.volume.samples.type()), spacing.x(), spacing.y(),
      spacing.z(), to_string(asked.inside), asked.choices.exact_isovalue ? "exactly " : "", *asked.isovalue,
      asked.smooth_voxels.value_or(0.0), to_string(asked.kernel), asked.choices.min_component, run.request.method,
      sizing_text(run.request.sizing));
}

RandomRunResult carry_out(const RandomRun& run, double most_vertices, const std::filesystem::path& folder) {
  RandomRunResult result;
  const std::filesystem::path file = folder / ("volume" + run.ending);
  const std::clock_t begin = std::clock();
  try {
    write_volume(run.volume, file);
    mesh_and_judge(run, most_vertices, file, result);
  } catch (const UsageError& error) {
    result.refusal = error.what();
  } catch (const DataError& error) {
    result.refusal = error.what();
  } catch (const Skipped& error) {
    result.refusal = error.what();
  } catch (const Error& error) {
    if (keeps_promises(run) && promises_mesh(run.request))
      result.wrong.push_back(fmt::format("fails: {}", error.what()));
    result.refusal = error.what();
  } catch (const std::exception& error) {
    result.wrong.push_back(fmt::format("is no refusal: {}", error.what()));
  }
  result.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return result;
}

}  // namespace isobench
