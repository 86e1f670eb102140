#include "isobench/reports/record/record.h"

#include <unistd.h>

#include <array>
#include <fstream>

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

std::string read_text(const std::filesystem::path& path) {
  // Opening a folder succeeds, only reading from it fails.
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) throw DataError(path.string() + ": cannot be read");
  // In one piece of the size that the file says it has: a stream of text would grow by doubling, and be copied.
  std::string text;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (!unknown) text.reserve(size);
  std::array<char, 16384> part{};
  while (file.read(part.data(), part.size()), file.gcount() > 0)
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  return text;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_text(path, [&text](std::ostream& file) { file << text; });
}

void write_text(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  const std::filesystem::path temporary = path.string() + ".tmp-" + std::to_string(getpid());
  {
    std::ofstream file(temporary, std::ios::binary);
    write(file);
    file.close();
    if (!file) throw Error(path.string() + ": cannot be written; is the disk full or the folder read-only?");
  }
  std::filesystem::rename(temporary, path);
}

void write_record(const RunRecord& record, const std::filesystem::path& path) { write_text(path, to_json(record)); }

RunRecord read_record(const std::filesystem::path& path) { return record_from_json(read_text(path), path.string()); }

}  // namespace isobench
