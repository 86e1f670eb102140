// Progress for people: a line that redraws itself on a terminal, sparse plain lines anywhere else. All of it on stderr.
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

  /// A line that stays; not shown when quiet.
  void line(const std::string& text);
  /// A line that stays; shown only when verbose.
  void detail(const std::string& text);
  /// Where things are now: redrawn in place on a terminal; otherwise a plain line, at most one every 30 seconds.
  void update(const std::string& text, double fraction);
  /// Takes the redrawn line away.
  void clear();
  Verbosity verbosity() const { return verbosity_; }

  /// `text` in a colour where stderr is a terminal and NO_COLOR is not set.
  std::string good(const std::string& text) const;
  std::string bad(const std::string& text) const;

 private:
  Verbosity verbosity_;
  bool terminal_;
  bool colour_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// Shows a computation of this process on a console.
class ConsoleSink : public ProgressSink {
 public:
  explicit ConsoleSink(Console& console) : console_(console) {}
  void show(const std::string& stage, double fraction) override;

 private:
  Console& console_;
  std::string stage_;
};

/// Sends a cell's progress to the process that started it, and its stages to the log.
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
