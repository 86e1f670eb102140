#include "isobench/reports/record/record.h"

namespace isobench {

std::string to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::failed:
      return "failed";
    case Status::timeout:
      return "timeout";
    case Status::out_of_memory:
      return "out of memory";
    case Status::skipped:
      return "skipped";
  }
  return "failed";
}

void write_record(const RunRecord& record, const std::filesystem::path& path) { write_text(path, to_json(record)); }

RunRecord read_record(const std::filesystem::path& path) { return record_from_json(read_text(path), path.string()); }

}  // namespace isobench
