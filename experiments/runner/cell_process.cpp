#include "isobench/experiments/runner/cell_process.h"

#include <cstdlib>

namespace isobench {

namespace {

ChildOptions options_for(std::vector<std::string> words, const std::filesystem::path& log) {
  words.insert(words.end(), {"--progress-fd", std::to_string(ChildProcess::pipe_number)});
  return {.words = std::move(words),
          .out = {ChildOutput::To::new_file, log},
          .own_group = true,
          .dies_with_parent = true,
          .pipe = true};
}

}  // namespace

CellProcess::CellProcess(std::vector<std::string> words, const std::filesystem::path& log)
    : process_(options_for(std::move(words), log)) {}

const CellProgress& CellProcess::progress() {
  unread_ += process_.take_from_pipe();
  // The last complete line tells where the child is now; earlier ones are out of date.
  const std::size_t end = unread_.rfind('\n');
  if (end == std::string::npos) return progress_;
  const std::size_t before = end == 0 ? std::string::npos : unread_.rfind('\n', end - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  const std::string line = unread_.substr(start, end - start);
  unread_.erase(0, end + 1);
  const std::size_t space = line.find(' ');
  if (space != std::string::npos) progress_ = {line.substr(space + 1), std::strtod(line.c_str(), nullptr)};
  return progress_;
}

}  // namespace isobench
