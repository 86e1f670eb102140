#include "isobench/experiments/runner/fault_injection.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"

namespace isobench {

namespace {

/// The kind of the first fault whose glob matches this run; "" if there is none.
std::string fault_of(const RunRequest& request) {
  const char* variable = std::getenv("ISOBENCH_TEST_FAULT");
  if (variable == nullptr) return "";
  std::istringstream faults(variable);
  for (std::string fault; std::getline(faults, fault, ';');) {
    const std::size_t colon = fault.find(':');
    if (colon != std::string::npos && selected(request, fault.substr(colon + 1))) return fault.substr(0, colon);
  }
  return "";
}

[[noreturn]] void hang(bool hoarding) {
  std::vector<std::vector<char>> hoard;
  while (true) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (hoarding) hoard.emplace_back(std::size_t{16} << 20U, 'x');
  }
}

/// Writes something invalid and exits with 0.
[[noreturn]] void pretend(const std::string& kind, const RunRequest& request, const std::filesystem::path& folder) {
  RunRecord record = begin_record(request, 1);
  if (kind == "garbage") {
    std::ofstream(folder / "run.json") << to_json(record).substr(0, 200);
    std::ofstream(folder / "mesh.vtp") << "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"99";
  } else if (kind == "foreign") {
    ++record.request.seed;
    record.status = Status::skipped;
    record.reason = "somebody else's";
    write_record(record, folder / "run.json");
  } else if (kind == "hollow") {
    record.status = Status::ok;
    record.measurement = Measurement{};
    write_record(record, folder / "run.json");
  }
  std::_Exit(0);
}

}  // namespace

void inject_fault(const RunRequest& request, const std::filesystem::path& folder) {
  const std::string kind = fault_of(request);
  if (kind == "crash") {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
  }
  if (kind == "hang" || kind == "memory") hang(kind == "memory");
  if (kind == "silent" || kind == "garbage" || kind == "foreign" || kind == "hollow") pretend(kind, request, folder);
}

void inject_fault(const RunRequest& request, TriangleMesh& mesh) {
  const std::string kind = fault_of(request);
  if (kind == "nan") mesh.vertices.at(0)[1] = std::numeric_limits<double>::quiet_NaN();
  if (kind == "index") mesh.triangles.at(0)[2] = static_cast<std::uint32_t>(mesh.vertices.size());
  if (kind == "empty") mesh.triangles.clear();
}

}  // namespace isobench
