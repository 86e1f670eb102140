#include "isobench/experiments/runner/remeasure.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/experiments/runner/store.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// The dataset and the sizing field of the present run. Runs are sorted so that each of these is made once.
class Surfaces {
 public:
  const Dataset& dataset(const RunRequest& request, Monitor& monitor) {
    if (dataset_.surface == nullptr || name_ != request.dataset || min_component_ != request.min_component) {
      field_.reset();
      name_ = request.dataset;
      min_component_ = request.min_component;
      dataset_ = load_dataset(request.dataset, monitor, {}, request.min_component);
    }
    if (dataset_.checksum != request.dataset_checksum) {
      throw DataError("dataset '" + request.dataset + "' has changed since it was meshed; run the experiment again");
    }
    return dataset_;
  }
  const SizingField& field(const RunRequest& request, Monitor& monitor) {
    const std::string key = fmt::format("{} {}", sizing_text(request.sizing), request.sizing.floor);
    if (!field_ || key_ != key) {
      field_.emplace(make_sizing_field(*dataset(request, monitor).surface, request.sizing, monitor));
      key_ = key;
    }
    return *field_;
  }

 private:
  std::string name_;
  double min_component_ = 0.0;
  Dataset dataset_;
  std::string key_;
  std::optional<SizingField> field_;
};

TriangleMesh stored_mesh(const fs::path& path, const RunRecord& record) {
  if (!fs::exists(path)) throw DataError("mesh.vtp is missing; run it again");
  TriangleMesh mesh = read_mesh(path);
  if (!record.mesh_checksum.empty() && checksum(mesh) != record.mesh_checksum) {
    throw DataError("mesh.vtp is not the mesh of its record (their checksums differ); run it again");
  }
  return mesh;
}

// Measures with the metrics of this program. The mesh in world coordinates gets the new arrays; its coordinates stay
// the same to the last bit, because only a copy is moved to the lattice frame.
void measure_again(RunRecord& record, TriangleMesh& mesh, Surfaces& surfaces, Monitor& monitor) {
  const RunRequest& request = record.request;
  const Dataset& dataset = surfaces.dataset(request, monitor);
  if (record.dataset && record.dataset->isovalue != dataset.surface->isovalue()) {
    throw DataError(fmt::format("the mesh is of isovalue {}, and dataset '{}' now has {}; run it again",
                                record.dataset->isovalue, request.dataset, dataset.surface->isovalue()));
  }
  const SizingField& sizing = surfaces.field(request, monitor);
  TriangleMesh local = to_local(mesh, dataset.surface->lattice());
  const MetricChoice choice = request.metrics_of_use ? MetricChoice::all : MetricChoice::usual;
  record.measurement = measure(local, {dataset.surface.get(), &sizing, dataset.topology.get()}, monitor, choice);
  record.sizing = SizingRecord{sizing.uniform(), sizing.floor_length(), sizing.smallest(), sizing.largest()};
  record.measured_again = measured_now();
  mesh.vertex_data = std::move(local.vertex_data);
  mesh.triangle_data = std::move(local.triangle_data);
}

// The same run under the name that it has with the metrics of this program, and with the metrics of use if they are
// wanted. A run that has them keeps them.
RunRequest renamed(RunRequest request, MetricChoice choice) {
  request.metrics_revision = metrics_revision;
  request.metrics_of_use = request.metrics_of_use || choice == MetricChoice::all;
  request.run = run_name(request);
  return request;
}

void copy_others(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path name = entry.path().filename();
    if (name != "run.json" && name != "mesh.vtp") fs::copy(entry.path(), to / name, fs::copy_options::recursive);
  }
}

class Remeasuring {
 public:
  Remeasuring(const fs::path& folder, MetricChoice choice, Console& console)
      : store_(folder), choice_(choice), console_(console) {}

  void run(const RunRecord& record) {
    const std::string run = record.request.run;
    if (record.status != Status::ok) {
      ++summary.without_mesh;
      return;
    }
    try {
      ++(replace(record.request) ? summary.measured : summary.elsewhere);
    } catch (const std::exception& error) {
      ++summary.failed;
      console_.line(run + ": kept as it was: " + error.what());
    }
  }

  RemeasureSummary summary;

 private:
  bool replace(const RunRequest& planned) {
    ConsoleSink sink(console_);
    Monitor monitor(&sink);
    const RunRequest request = renamed(planned, choice_);
    std::optional<Claim> claim = store_.claim(request);
    if (!claim) {
      console_.line(request.run + ": left to another process that is working on it");
      return false;
    }
    const fs::path old = store_.folder() / planned.run;
    RunRecord record =
        read_record(old / "run.json");  // read again: another process may have changed it before the claim
    TriangleMesh mesh = stored_mesh(old / "mesh.vtp", record);
    record.request = request;
    measure_again(record, mesh, surfaces_, monitor);
    copy_others(old, claim->folder());
    write_mesh(mesh, claim->folder() / "mesh.vtp");
    write_record(record, claim->folder() / "run.json");
    claim->commit();
    if (planned.run != request.run) fs::remove_all(old);
    console_.detail(request.run + ": measured");
    return true;
  }

  Store store_;
  MetricChoice choice_;
  Console& console_;
  Surfaces surfaces_;
};

}  // namespace

RemeasureSummary remeasure(const fs::path& folder, MetricChoice choice, Console& console) {
  Results results = load_results(folder);
  std::stable_sort(results.records.begin(), results.records.end(), [](const RunRecord& a, const RunRecord& b) {
    const auto key = [](const RunRecord& r) { return std::pair(r.request.dataset, sizing_text(r.request.sizing)); };
    return key(a) < key(b);
  });
  Remeasuring remeasuring(folder, choice, console);
  for (const RunRecord& record : results.records) remeasuring.run(record);
  for (const std::string& sentence : results.unreadable) console.line(sentence);
  remeasuring.summary.failed += static_cast<int>(results.unreadable.size());
  const FileLock lock = lock_results(folder);
  const fs::path plan_path = folder / "plan.json";
  std::vector<RunRequest> plan = plan_from_json(read_text(plan_path), plan_path.string());
  for (RunRequest& request : plan) request = renamed(std::move(request), choice);
  write_text(plan_path, [&plan](std::ostream& file) { write_plan(file, plan); });
  console.clear();
  return remeasuring.summary;
}

}  // namespace isobench
