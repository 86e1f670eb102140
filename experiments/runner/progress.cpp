#include "isobench/experiments/runner/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "isobench/experiments/terminal/terminal.h"

namespace isobench {

namespace {

using Clock = std::chrono::steady_clock;

bool elapsed(Clock::time_point& last, std::chrono::milliseconds interval) {
  const Clock::time_point now = Clock::now();
  if (last != Clock::time_point{} && now - last < interval) return false;
  last = now;
  return true;
}

std::string bar(double fraction) {
  constexpr int width = 20;
  const int filled = static_cast<int>(std::lround(fraction * width));
  return fmt::format("[{:#<{}}{:.<{}}] {:3.0f} % ", "", filled, "", width - filled, 100.0 * fraction);
}

}  // namespace

Console::Console(Verbosity verbosity) : verbosity_(verbosity), terminal_(isatty(STDERR_FILENO) == 1) {
  const char* no_color = std::getenv("NO_COLOR");
  colour_ = terminal_ && (no_color == nullptr || *no_color == '\0');
}

void Console::line(const std::string& text) {
  if (verbosity_ == Verbosity::quiet) return;
  clear();
  fmt::print(stderr, "{}\n", text);
}

void Console::detail(const std::string& text) {
  if (verbosity_ == Verbosity::verbose) line(text);
}

void Console::update(const std::string& text, double fraction) {
  if (verbosity_ == Verbosity::quiet) return;
  if (!terminal_) {
    if (last_ == Clock::time_point{}) last_ = Clock::now();  // so that short work prints no line
    if (!elapsed(last_, std::chrono::seconds(30))) return;
    fmt::print(stderr, "{}{}\n", text, fraction >= 0.0 ? fmt::format(" {:.0f} %", 100.0 * fraction) : "");
    return;
  }
  if (!elapsed(last_, std::chrono::milliseconds(100))) return;
  // One column less than there are: a full line would make the terminal go to the next one.
  const std::size_t most = terminal_width(STDERR_FILENO).value_or(80) - 1;
  fmt::print(stderr, "\r\x1b[K{}", first_characters((fraction >= 0.0 ? bar(fraction) : "") + text, most));
  std::fflush(stderr);
  drawn_ = true;
}

void Console::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

std::string Console::good(const std::string& text) const { return colour_ ? "\x1b[32m" + text + "\x1b[0m" : text; }
std::string Console::bad(const std::string& text) const { return colour_ ? "\x1b[31m" + text + "\x1b[0m" : text; }

void ConsoleSink::show(const std::string& stage, double fraction) {
  if (stage != stage_) console_.detail(stage);
  stage_ = stage;
  console_.update(stage, fraction);
}

void PipeSink::show(const std::string& stage, double fraction) {
  const bool fresh = stage != stage_;
  if (fresh) {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    fmt::print("{:9.3f} s  {}\n", seconds, stage);
    std::fflush(stdout);
    stage_ = stage;
  }
  if (!fresh && !elapsed(last_, std::chrono::milliseconds(100))) return;
  const std::string line = fmt::format("{:.4f} {}\n", fraction, stage);
  // A cell goes on if nobody reads its progress: SIGPIPE is ignored, and so is the result of write().
  [[maybe_unused]] const ssize_t written = write(descriptor_, line.data(), line.size());
}

}  // namespace isobench
