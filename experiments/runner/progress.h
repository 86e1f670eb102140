// Shows progress on stderr: a line that is redrawn on a terminal, otherwise a plain line now and then.
#pragma once

#include <chrono>
#include <string>

#include "isobench/foundation/monitor.h"

namespace isobench {

enum class Verbosity { quiet, normal, verbose };

/// Writes to stderr.
class Console {
 public:
  explicit Console(Verbosity verbosity);

  /// Prints a line; not if quiet.
  void line(const std::string& text);
  /// Prints a line; only if verbose.
  void detail(const std::string& text);
  /// Shows the present state: redraws one line on a terminal; otherwise prints a line, at most every 30 seconds.
  void update(const std::string& text, double fraction);
  /// Removes the redrawn line.
  void clear();
  Verbosity verbosity() const { return verbosity_; }

  /// The text in colour if stderr is a terminal and NO_COLOR is not set.
  std::string good(const std::string& text) const;
  std::string bad(const std::string& text) const;

 private:
  Verbosity verbosity_;
  bool terminal_;
  bool colour_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// Shows the progress of a computation in this process.
class ConsoleSink : public ProgressSink {
 public:
  explicit ConsoleSink(Console& console) : console_(console) {}
  void show(const std::string& stage, double fraction) override;

 private:
  Console& console_;
  std::string stage_;
};

/// Sends the progress of a cell to the process that started it, and prints its stages, which go to the log.
class PipeSink : public ProgressSink {
 public:
  explicit PipeSink(int descriptor) : descriptor_(descriptor) {}
  void show(const std::string& stage, double fraction) override;

 private:
  int descriptor_;
  std::string stage_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_;
};

}  // namespace isobench
