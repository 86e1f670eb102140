#include "isobench/foundation/files/whole_files.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <fstream>
#include <system_error>
#include <utility>

namespace isobench {

namespace fs = std::filesystem;

namespace {

const char* remedy_of(int cause) {
  switch (cause) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or write to another disk";
    case EFBIG:
      return "raise the limit on the size of files (ulimit -f) or write to another disk";
    default:
      return "check that its folder exists and that you may write there";
  }
}

}  // namespace

PartialFile::PartialFile(fs::path target)
    : target_(std::move(target)),
      temporary_(target_.string() + mark + std::to_string(getpid()) + target_.extension().string()) {}

PartialFile::~PartialFile() {
  std::error_code error;
  if (!temporary_.empty()) fs::remove(temporary_, error);
}

void PartialFile::complete() {
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw not_written(target_, error.value());
  temporary_.clear();
}

Error not_written(const fs::path& path, int cause) {
  const std::string reason = cause == 0 ? "" : ": " + std::generic_category().message(cause);
  return Error(path.string() + ": cannot be written" + reason + "; " + remedy_of(cause));
}

std::string read_text(const fs::path& path) {
  // Opening a folder succeeds, only reading from it fails.
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) throw DataError(path.string() + ": cannot be read");
  // Reserve memory for the whole file: a text that grows is copied again and again.
  std::string text;
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(path, unknown);
  if (!unknown) text.reserve(size);
  std::array<char, 16384> part{};
  while (file.read(part.data(), part.size()), file.gcount() > 0)
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  return text;
}

std::string read_text_or_empty(const fs::path& path) {
  try {
    return read_text(path);
  } catch (const DataError&) {
    return "";
  }
}

void write_text(const fs::path& path, const std::string& text) {
  write_text(path, [&text](std::ostream& file) { file << text; });
}

void write_text(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  PartialFile partial(path);
  errno = 0;
  std::ofstream file(partial.path(), std::ios::binary);
  write(file);
  file.close();
  if (!file) throw not_written(path, errno);
  partial.complete();
}

std::string last_lines(const fs::path& path, std::size_t count, std::uintmax_t begin) {
  constexpr std::streamoff most = 4096;  // bytes; a program may have written far more
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff length = file.tellg();
  file.seekg(std::max({length - most, static_cast<std::streamoff>(begin), std::streamoff{0}}));
  std::deque<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r.") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  return text;
}

}  // namespace isobench
