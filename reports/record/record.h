// What a run leaves behind: run.json, and how it is read back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/parameters.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/measurement.h"
#include "isobench/reports/record/environment.h"
#include "isobench/reports/record/named_numbers.h"
#include "isobench/reports/record/shared_value.h"

namespace isobench {

using ParameterValues = std::map<std::string, ParameterValue>;

/// What a run was asked to do: a cell of an experiment's plan. Everything except family, label, limits, `alone`,
/// `artefacts`, `metrics_of_use` and `aside` determines its name.
struct RunRequest {
  std::string run;  ///< name of its folder, e.g. "skull-particles-e0.5-d0.3-s1-1f2a9c3e"
  std::string dataset;
  std::string dataset_checksum;
  std::string family;  ///< the family of data sets that this one is a member of; "" if it is of none
  std::string method;
  int method_revision = 1;
  std::string label;                        ///< tells apart two entries of one method
  SharedValue<ParameterValues> parameters;  ///< every parameter of the method
  SizingRequest sizing;
  std::string match_to;  ///< the run whose number of vertices this one is matched to; "" if none
  std::uint64_t seed = 1;
  int repeat = 1;               ///< number of the repeat; a run is repeated to measure its seconds again
  bool alone = false;           ///< nothing else of its experiment runs at the same time, so that its seconds count
  bool artefacts = false;       ///< also store the medial axis, the sizing and the particles
  bool metrics_of_use = false;  ///< also measure what takes seconds (When::on_request)
  bool aside = false;           ///< for a plot of its own; the tables that compare leave it out
  double min_component = 0.0;   ///< mm³: components of F = c that enclose less are left out
  int metrics_revision = 1;
  std::optional<double> limit_minutes;
  std::optional<double> limit_memory_gb;
};

enum class Status {
  ok,
  failed,         ///< an error or a crash
  timeout,        ///< stopped at its limit of minutes
  out_of_memory,  ///< stopped at its limit of memory, or an allocation failed
  skipped,        ///< the method says that it cannot do this task
};
/// "ok", "failed", "timeout", "out of memory", "skipped".
std::string to_string(Status status);

/// The dataset as it was meshed.
struct DatasetRecord {
  std::string title;
  std::string source;
  std::vector<std::string> preparation;
  Lattice lattice;
  double isovalue = 0.0;
  std::optional<double> asked_isovalue;  ///< set if that is no regular value of F, and `isovalue` is taken instead
  std::string inside;                    ///< "above" or "below"
  std::string kernel;                    ///< as to_string(Kernel) names it
};

/// The result of matching. The mesh is measured against the sizing as it was asked for, before scaling.
struct MatchRecord {
  double vertices = 0.0;  ///< asked for
  double scale = 1.0;     ///< factor on the edge lengths, as scaled() puts it
  int tries = 0;          ///< meshes made on the way; seconds and memory are those of the one that was kept
  std::string reason;     ///< why the number could not be reached; "" where it was
};

/// The sizing field of the request, mm.
struct SizingRecord {
  bool uniform = false;
  double floor = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};

/// Which program measured, if the mesh was measured again after the run.
struct MeasuredAgain {
  std::string when;  ///< UTC, ISO 8601
  std::string commit;
  bool dirty = false;
};

struct RunRecord {
  static constexpr int schema_version = 1;

  RunRequest request;
  Status status = Status::failed;
  std::string reason;   ///< empty where status is ok
  std::string started;  ///< UTC, ISO 8601
  int threads = 0;
  bool deterministic = true;  ///< as the method declares
  Environment environment;

  std::optional<DatasetRecord> dataset;  ///< set if the run got as far as loading it
  std::optional<MatchRecord> match;      ///< set if the request has match_to and the status is ok
  std::optional<SizingRecord> sizing;
  std::optional<Measurement> measurement;  ///< set if the status is ok
  std::optional<MeasuredAgain> measured_again;
  std::string mesh_checksum;  ///< checksum() of the mesh in mesh.vtp; "" where there is none

  double seconds_prepare = 0.0;  ///< reading and preparing the volume, wall
  double seconds_sizing = 0.0;   ///< the sizing field that the method asked for
  double seconds_method = 0.0;   ///< the method without it
  double seconds_total = 0.0;    ///< sizing + method
  double peak_memory_mb = 0.0;   ///< of the process, or of a program that it ran, up to the finished mesh

  std::vector<StageTime> stages;
  NamedNumbers counters;
  std::map<std::string, std::vector<double>> traces;
  std::vector<std::string> notes;
};

/// Figures have the names of results.csv. A figure that was not measured is null. A figure that is unknown, because the
/// record is older than the figure, is left out. Numbers that are not finite are null.
std::string to_json(const RunRecord& record);
/// Throws DataError that names `origin` if the text is no record, or a record of another schema version. Records of
/// program version 0.1.0 have the same schema version, and lack the figures that were added later.
RunRecord record_from_json(const std::string& text, const std::string& origin);

void write_record(const RunRecord& record, const std::filesystem::path& path);
RunRecord read_record(const std::filesystem::path& path);

/// The figures of a measurement alone (`isobench measure --json`).
std::string to_json(const Measurement& measurement);

/// A plan: every cell of an experiment, as plan.json keeps it.
std::string plan_to_json(const std::vector<RunRequest>& plan);
void write_plan(std::ostream& file, const std::vector<RunRequest>& plan);
std::vector<RunRequest> plan_from_json(const std::string& text, const std::string& origin);

}  // namespace isobench
