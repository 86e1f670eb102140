#include "experiments/ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <fstream>

#include "experiments/cell.h"

namespace isobench {

namespace {

std::string last_lines(const std::filesystem::path& log, std::size_t count) {
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  const std::streamoff length = file.tellg();
  file.seekg(std::max<std::streamoff>(0, length - 4096));  // however much a child has written
  std::deque<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.empty()) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  return text;
}

RunRecord failure(const RunRequest& request, Status status, const std::string& reason, double seconds) {
  RunRecord record = begin_record(request, 0);
  record.status = status;
  record.reason = reason;
  record.seconds_total = seconds;
  return record;
}

}  // namespace

RunRecord without_record(const RunRequest& request, const ChildExit& exit, double seconds,
                         const std::filesystem::path& log) {
  const std::string how = exit.signal != 0 ? "ended by " + signal_name(exit.signal)
                                           : fmt::format("ended with exit code {} and no record", exit.code);
  const std::string tail = last_lines(log, 3);
  return failure(request, Status::failed, tail.empty() ? how : how + "; its log ends: " + tail, seconds);
}

std::optional<RunRecord> beyond_limits(const RunRequest& request, const Child& child) {
  const double seconds = child.seconds();
  if (request.limit_minutes && seconds > 60.0 * *request.limit_minutes) {
    return failure(request, Status::timeout, fmt::format("not finished after {} minutes", *request.limit_minutes),
                   seconds);
  }
  if (request.limit_memory_gb && child.peak_memory_gb() > *request.limit_memory_gb) {
    return failure(request, Status::out_of_memory, fmt::format("needed more than {} GB", *request.limit_memory_gb),
                   seconds);
  }
  return std::nullopt;
}

}  // namespace isobench
